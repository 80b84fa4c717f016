"""The audit sees a hole in the checks of a function that others call: its slips are tried in it alone, too."""

from dataclasses import replace

import numpy as np
import pytest

from tam570_grader import cli
from tam570_grader.audit import mutation
from tam570_grader.audit.gradings import Grading, seeds_that_fail, tried
from tam570_grader.audit.mutate import mutants

SLUG = "hw08_axis_angle"


def test_a_slip_alone_is_in_one_function_and_others_call_the_right_one(solution_text):
    correct = solution_text(SLUG)
    slipped = next(item for item in mutants(SLUG, correct) if item.function == "skew")
    calls = {"a check": {"skew", "rotate"}, "another": {"rotation_matrix"}}
    actual, as_it_was = {}, {}
    exec(mutation.alone(correct, slipped, calls), actual)
    exec(correct, as_it_was)
    v = np.array([1.0, 2.0, 3.0])
    assert not np.array_equal(actual["skew"](v), as_it_was["skew"](v))
    np.testing.assert_array_equal(actual["rotation_matrix"](v, 0.4), as_it_was["rotation_matrix"](v, 0.4))


@pytest.mark.parametrize("hole", [True, False])
def test_a_function_without_a_check_of_its_own_is_a_hole(hole, capsys, monkeypatch):
    full = mutation.calls_of_checks

    def without(*of):
        calls, longest = full(*of)
        holes = [name for name in calls if hole and name.startswith("skew")]
        return {**calls, **{name: calls[name] - {"skew"} for name in holes}}, longest

    monkeypatch.setattr(mutation, "calls_of_checks", without)
    monkeypatch.setattr(mutation, "_is_shared", lambda function, *of: function == "skew")
    assert cli.main(["audit", "hw08", "--function", "skew", "--jobs", "1"]) == hole
    assert ("SURVIVES" in capsys.readouterr().out) == hole


@pytest.mark.parametrize("outcome, most", [("return -right(v)", 8), ("os._exit(1)", 1)])
def test_a_check_fails_with_the_seeds_with_which_a_grading_fails_it(outcome, most, course, solution_text):
    wrong = f"\n\nimport os\nright = skew\ndef skew(v):\n    if v[0] > 1.4: {outcome}\n    return right(v)\n"
    check, seeds = "skew_is_the_cross_product", range(8)
    grading = Grading(course, SLUG, "", solution_text(SLUG) + wrong, 0, checks=frozenset({check}))
    results = [tried(replace(grading, seed=seed)) for seed in seeds]
    failing = [seed for seed, result in zip(seeds, results, strict=True) if result.score < result.max_score]
    assert 1 < len(failing) < len(seeds)
    assert seeds_that_fail(grading, check, seeds) == {*failing[:most]}  # a crash says nothing of the seeds after it
