"""Each hidden case is judged by itself, and the fewest that catch all are chosen."""

import pytest

from tam570_grader.audit.cases import fewest
from tam570_grader.audit.local import Key, LocalStudent, Replies, failed_cases
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import solution_with

SLUG = "hw08_axis_angle"
ASSIGNMENT = assignments.assignment(assignments.find(), SLUG)
(CHECK,) = (check for check in ASSIGNMENT.checks if check.name == "skew_is_the_cross_product")


def key(name):
    return Key("a check", "f", name, 1)


def test_the_fewest_cases_are_the_cheap_ones_that_catch_all():
    cheap, costly, both, alone = map(key, ("cheap", "costly", "both", "alone"))
    caught = {
        (0, "sign"): {cheap, costly},
        (0, "factor"): {both, costly},
        (1, "sign"): {both},
        (0, "steps"): {alone, costly},
    }
    seconds = {cheap: 1e-5, both: 1e-5, alone: 1.0, costly: 2.0}
    assert set(fewest({what: frozenset(keys) for what, keys in caught.items()}, seconds)) == {cheap, both, alone}
    assert fewest({(0, "sign"): frozenset({both, cheap}), (0, "factor"): frozenset({both})}, seconds) == [both]


@pytest.mark.parametrize(
    ("wrong", "label"),
    [
        ("if np.count_nonzero(v) == 1: raise RuntimeError", "a v along a coordinate axis"),
        ("if not np.any(v): return np.full((3, 3), np.nan)", "a v of zeros"),
        ("if np.count_nonzero(v) == 1: v = -v", "a v along a coordinate axis"),
    ],
)
def test_a_case_is_judged_whatever_the_others_say(wrong, label, solution_text):
    solution = Replies(solution_with(solution_text(SLUG), ""))
    text = f"\n_skew = skew\ndef skew(v):\n    v = np.array(v)\n    {wrong}\n    return _skew(v)\n"
    module = solution_with(solution_text(SLUG), text)
    student = LocalStudent(ASSIGNMENT, CHECK, solution, Replies(module, solution, frozenset({"skew"})))
    failed = failed_cases(student, CHECK, 5, SLUG)
    assert {case.label for case in failed} == {label}
    assert len(failed) == sum(case.label == label for case in student.cases)
