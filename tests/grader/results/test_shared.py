"""Who shares a wrong result that no known mistake explains: found across names, never for what anybody may come by."""

import numpy as np
import pytest
from classes import HW08, check_result, hand_in, result

from tam570_grader import cli
from tam570_grader.checks.failure import Failure
from tam570_grader.results.shared import groups, signs_of

ODD = np.array([0.123456789012345, -2.0, 0.7])


def sharer(student, actual, *, cause=None, near_miss=False, checks=("skew_is_the_cross_product",)):
    failure = Failure(quantity="skew(v)", error=1.0, limit=1e-12, near_miss=near_miss, actual=actual)
    return result(student, *(check_result(name, suspect=cause, failure=failure) for name in checks))


def sharers(*results):
    signs = {(each.student, each.assignment): [*signs_of(each)] for each in results}  # the newest counts
    return [(group.students, group.checks) for group in groups(signs)]


def test_two_with_the_same_numbers_are_named():
    observed = sharers(sharer("ann", ODD), sharer("ben", ODD * (1 + 1e-14)), sharer("cas", ODD * (1 + 1e-10)))
    assert observed == [(("ann", "ben"), ("skew_is_the_cross_product",))]


def test_the_newest_result_counts_and_checks_of_one_group_stand_together():
    both = [sharer(student, ODD, checks=("x", "y")) for student in "ab"]
    assert sharers(*both) == [(("a", "b"), ("x", "y"))]
    assert sharers(*both, sharer("b", ODD * 2)) == []


@pytest.mark.parametrize(
    ("actual", "more"),
    [
        (np.zeros(3), {}),
        (np.full(3, np.nan), {}),
        (np.array([1.0, -0.5, 3.25]), {}),
        (np.array([np.pi / 4]), {}),
        (np.array([-2 * np.pi / 3, np.sqrt(2) / 2, 0.0]), {}),
        (None, {}),
        ("text", {}),
        (ODD, {"cause": "The sign is wrong."}),
        (ODD, {"near_miss": True}),
    ],
)
def test_what_anybody_may_come_by_is_not_told(actual, more):
    assert sharers(sharer("ann", actual, **more), sharer("ben", actual, **more)) == []


def test_the_report_names_them(tmp_path, solution_text, capsys):
    odd = "\n\ndef skew(v):\n    return np.outer(v, v) * 1.2345 + 0.1 * np.eye(3)\n"
    texts = {"ann": odd, "ben": odd.replace("v", "w"), "cas": "", "dan": odd.replace("0.1", "0.2")}
    hand_in(tmp_path / "submitted", {student: solution_text(HW08) + text for student, text in texts.items()})
    assert cli.main(["grade", str(tmp_path / "submitted"), "--out", str(tmp_path / "out"), "--seed", "1"]) == 0
    assert cli.main(["report", str(tmp_path / "out")]) == 0
    page = (tmp_path / "out" / "report.html").read_text()
    assert "The same wrong result" in page and "ann, ben" in page and "ben, dan" not in page
