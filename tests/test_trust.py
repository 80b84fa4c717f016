"""TRUST.md names a test or an attack for each claim; these exist where it says."""

import re

from tam570_grader.writing import assignments

COURSE = assignments.find()
ROWS = [row for row in (COURSE / "autograder" / "TRUST.md").read_text().splitlines() if row.startswith("| ")]
PLACED = re.compile(r"((?:`test_\w+`(?:, | and )?)+) in `(tests/[\w/.]+)`")


def missing(rows):
    """(name, file) of the tests that a file of that name does not hold, and files or attacks that are not there."""
    for row in rows:
        for names, path in PLACED.findall(row):
            text = (COURSE / path).read_text() if (COURSE / path).exists() else ""
            yield from ((name, path) for name in re.findall(r"`(\w+)`", names) if f"def {name}(" not in text)
        for path in re.findall(r"`(tests/[\w/.]+)`", row):
            if not (COURSE / path).exists():
                yield "", path


def test_every_test_that_trust_names_is_there():
    assert not list(missing(ROWS)) and sum("`test_" in row for row in ROWS) > 4


def test_a_name_that_is_gone_is_found():
    row = "| x | `test_gone` in `tests/test_trust.py`, `tests/nowhere.py` |"
    assert list(missing([row])) == [("test_gone", "tests/test_trust.py"), ("", "tests/nowhere.py")]
