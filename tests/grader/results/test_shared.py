"""Who shares a wrong result that no known mistake explains: found across names, never for what anybody may come by."""

from dataclasses import replace

import numpy as np
import pytest

from tam570_grader import cli
from tam570_grader.checks.failure import Failure
from tam570_grader.results.records import CheckResult, Result
from tam570_grader.results.shared import Notes

SLUG = "hw08_axis_angle"
ODD = np.array([0.123456789012345, -2.0, 0.7])


def result(student, actual, *, suspect=None, near_miss=False, seed=1, check="skew_is_the_cross_product"):
    failure = Failure(quantity="skew(v)", error=1.0, limit=1e-12, near_miss=near_miss, actual=actual)
    check_result = CheckResult(check, "a", 0.0, 1.0, "failed", "wrong", suspect, failure)
    return Result(student, SLUG, "graded", 9.0, 10.0, seed, 0.1, "bubblewrap", (check_result,))


def groups(*results):
    notes = Notes()
    assert len(list(notes.passing(results))) == len(results)
    return [(item.students, item.checks) for item in notes.groups()]


def test_two_with_the_same_numbers_are_named():
    observed = groups(result("ann", ODD), result("ben", ODD * (1 + 1e-14)), result("cas", ODD * (1 + 1e-10)))
    assert observed == [(("ann", "ben"), ("skew_is_the_cross_product",))]


def test_the_newest_result_counts_and_checks_of_one_group_stand_together():
    both = [
        replace(result(who, ODD), checks=(*result(who, ODD).checks, *result(who, ODD, check="x").checks))
        for who in "ab"
    ]
    assert groups(*both) == [(("a", "b"), ("skew_is_the_cross_product", "x"))]
    assert groups(*both, result("b", ODD * 2)) == []


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
        (ODD, {"suspect": "The sign is wrong."}),
        (ODD, {"near_miss": True}),
    ],
)
def test_what_anybody_may_come_by_is_not_told(actual, more):
    assert groups(result("ann", actual, **more), result("ben", actual, **more)) == []


def test_the_report_names_them(tmp_path, solution_text, capsys):
    odd = "\n\ndef skew(v):\n    return np.outer(v, v) * 1.2345 + 0.1 * np.eye(3)\n"
    for student, text in {
        "ann": odd,
        "ben": odd.replace("v", "w"),
        "cas": "",
        "dan": odd.replace("0.1", "0.2"),
    }.items():
        folder = tmp_path / "submitted" / student / SLUG
        folder.mkdir(parents=True)
        (folder / f"{SLUG}.py").write_text(solution_text(SLUG) + text)
    assert cli.main(["grade", str(tmp_path / "submitted"), "--out", str(tmp_path / "out"), "--seed", "1"]) == 0
    assert cli.main(["report", str(tmp_path / "out")]) == 0
    page = (tmp_path / "out" / "report.html").read_text()
    assert "The same wrong result" in page and "ann, ben" in page and "ben, dan" not in page
