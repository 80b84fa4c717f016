"""A feedback page reveals no more bits about hidden inputs than TRUST.md says."""

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
from tam570_grader.sandbox.imports import KNOWN_TEXTS

COURSE = assignments.find()
TEXT = (COURSE / "autograder" / "TRUST.md").read_text()


def errors_told(limit):
    """Return the sentences about errors of every size above a limit, many of them just above it."""
    rng = np.random.default_rng(0)
    sizes = [*limit * (1 + 10 ** rng.uniform(-15.5, 1, 500)), *10 ** rng.uniform(-300, 300, 500)]
    failures = [Failure(quantity="x", error=float(size), limit=limit) for size in sizes if size > limit]
    return {describe_failure(failure).partition(" (limit")[0] for failure in failures}


def times_told():
    """Return the times of the largest error that failures state, for random time grids."""
    rng, times = np.random.default_rng(1), set()
    for _ in range(100):
        t = np.sort(10 ** rng.uniform(-9, 9, 20))
        try:
            with check_context():
                expect(rng.uniform(1, 2, 20), np.zeros(20), scale=1.0, tolerance=1e-9, quantity="x", unit="m", t=t)
        except Failed as failed:
            times.add(f"{failed.failure.time:g}")
    return times


def sentences_told(slug):
    """Return an upper bound on the number of sentences that can name a mistake."""
    folder, solution = assignments.checks_folder(COURSE, slug), (COURSE / "solutions" / f"{slug}.py").read_text()
    texts = "".join(path.read_text() for path in folder.glob("*.py"))
    exceptions = len(vars(builtins)) + sum(map(len, KNOWN_TEXTS.values()))
    causes = len(mistakes(folder)) + len([*mutants_of(solution)]) + exceptions
    return causes + len(re.findall(r"label|hint|fail", texts))


def test_a_page_tells_no_more_bits_than_the_table_says():
    """Count the sentences that pages contain; where the numbers are too many to list, check their digits."""
    rows = re.findall(r"^\| ([^|]+) \| (\d+) \|", TEXT, re.MULTILINE)
    bits = {words.split(",")[0]: int(number) for words, number in rows}
    outcome, error, time, along, invariant, sentence, everything = bits.values()
    two_digits = 90 * 633 + 1  # numbers with two digits in the range of a double
    errors = errors_told(1e-6)
    assert all(len(re.sub(r"e.*|[^1-9]", "", text.split(" by ")[1])) <= 2 for text in errors)
    assert len(errors) < two_digits
    assert all(len(re.sub(r"e.*|[^1-9]", "", text)) <= 2 for text in times_told())
    assert error == time == math.ceil(math.log2(two_digits)) and outcome == math.ceil(math.log2(4 * 1001))
    assert along == invariant == BITS
    assert 10 * sentences_told("hw14_rolling_disk") < 2**sentence  # hw14 has the most
    assert everything == outcome + error + time + along + invariant + sentence
