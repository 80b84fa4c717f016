"""TRUST.md names a test or an attack for each claim; these exist where it says. What feedback tells is counted here."""

import builtins
import math
import re

import numpy as np

from tam570_grader.checks import assignments
from tam570_grader.checks.curves import BITS
from tam570_grader.checks.expect import Failed, check_context, expect
from tam570_grader.checks.failure import Failure
from tam570_grader.diagnosis.mistakes import mistakes
from tam570_grader.diagnosis.mutants import mutants_of
from tam570_grader.reports.sentences import describe_failure

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


def errors_told(limit):
    """What is said of errors of every size beyond a limit, many of them just beyond it."""
    rng = np.random.default_rng(0)
    sizes = [*limit * (1 + 10 ** rng.uniform(-15.5, 1, 20_000)), *10 ** rng.uniform(-300, 300, 20_000)]
    failures = [Failure(quantity="x", error=float(size), limit=limit) for size in sizes if size > limit]
    return {describe_failure(failure).partition(" (limit")[0] for failure in failures}


def times_told():
    """What is said of the time of the largest error, of any times."""
    rng, told = np.random.default_rng(1), set()
    for _ in range(2000):
        times = np.sort(10 ** rng.uniform(-9, 9, 20))
        try:
            with check_context():
                expect(rng.uniform(1, 2, 20), np.zeros(20), scale=1.0, tolerance=1e-9, quantity="x", unit="m", t=times)
        except Failed as failed:
            told.add(f"{failed.failure.time:g}")
    return told


def sentences_told(slug):
    """How many sentences of ours may name what went wrong."""
    folder, solution = assignments.checks_folder(COURSE, slug), (COURSE / "solutions" / f"{slug}.py").read_text()
    texts = "".join(path.read_text() for path in folder.glob("*.py"))
    own = len(mistakes(folder)) + sum(map(len, mutants_of(solution).values())) + len(vars(builtins))
    return own + len(re.findall(r"label|hint|fail", texts))


def test_a_page_tells_no_more_bits_than_the_table_says():
    """Each count is of what a page was seen to say; digits, where there are too many numbers to see them all."""
    rows = re.findall(r"^\| ([^|]+) \| (\d+) \|", TEXT, re.MULTILINE)
    bits = {words.split(",")[0]: int(number) for words, number in rows}
    outcome, error, time, along, invariant, sentence, everything = bits.values()
    two_digits = 90 * 633 + 1  # of any number of the machine
    told = errors_told(1e-6)
    assert all(len(re.sub(r"e.*|[^1-9]", "", text.split(" by ")[1])) <= 2 for text in told) and len(told) < two_digits
    assert all(len(re.sub(r"e.*|[^1-9]", "", text)) <= 2 for text in times_told())
    assert error == time == math.ceil(math.log2(two_digits)) and outcome == math.ceil(math.log2(4 * 1001))
    assert along == invariant == BITS
    assert max(map(sentences_told, assignments.slugs(COURSE))) < 2**sentence
    assert everything == outcome + error + time + along + invariant + sentence
