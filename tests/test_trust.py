"""TRUST.md names a test or an attack for each claim; these exist where it says."""

import re

from tam570_grader.checks import assignments

COURSE = assignments.find()
TEXT = (COURSE / "autograder" / "TRUST.md").read_text()
TESTS = {path.relative_to(COURSE).as_posix(): path.read_text() for path in (COURSE / "tests").rglob("*.py")}
PLACED = re.compile(r"((?:`test_\w+`(?:,\s| and )?)+) in\s`(tests/[\w/.]+)`")


def missing(text):
    """(name, file) of tests that the file does not hold, (name, "") of what is nowhere, ("", file) of no file."""
    for names, path in PLACED.findall(text):
        yield from ((name, path) for name in named(names) if f"def {name}(" not in TESTS.get(path, ""))
    there = {found for one in TESTS.values() for found in re.findall(r"^def (test_\w+)\(", one, re.MULTILINE)}
    there |= {path.split("/")[-1].removesuffix(".py") for path in TESTS if path.startswith("tests/hostile/")}
    yield from ((name, "") for name in named(text) if name not in there)
    yield from (("", path) for path in re.findall(r"`(tests/[\w/.]+)`", text) if not (COURSE / path).exists())


def named(text):
    """What is named as a test or an attack: by a name of several words, or in the last column of a table."""
    shown = [line.rpartition(" | ")[2] for line in text.splitlines() if line.startswith("| ")]
    return {*re.findall(r"`([a-z]\w*_\w*)`", text), *re.findall(r"`(\w+)`", " ".join(shown))}


def test_every_test_that_trust_names_is_there():
    assert not list(missing(TEXT)) and len(named(TEXT)) > 80


def test_a_name_that_is_gone_is_found():
    row = (
        "| x | `test_gone` in `tests/test_trust.py`, `tests/nowhere.py`, `vanishes` |\nHere `is_gone`, `grade` is not."
    )
    placed = [("test_gone", "tests/test_trust.py"), ("", "tests/nowhere.py")]
    assert sorted(missing(row)) == sorted([*placed, ("test_gone", ""), ("vanishes", ""), ("is_gone", "")])
