"""The audit: mutants of the solutions, fairness, diagnosis, margins, and hidden cases."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from classes import HW08, check_result, result

from tam570_grader import cli
from tam570_grader.audit import diagnosis, fairness, margins, mutation
from tam570_grader.audit.cases import fewest
from tam570_grader.audit.gradings import Grading, seeds_that_fail, tried
from tam570_grader.audit.local import Key, LocalStudent, Replies, failed_cases
from tam570_grader.audit.margins import Margin
from tam570_grader.audit.mutate import mutants
from tam570_grader.checks import assignments
from tam570_grader.checks.failure import Failure
from tam570_grader.diagnosis.mistakes import Mistake, solution_with
from tam570_grader.grading.executor import executor

LISTED = {  # pattern of a line that the audit prints: mutants of _unit that are listed as equivalent {mutant: proof}
    r'\[_unit\]\n    "scaled @ scaled -> scaled.T @ scaled" = ""': {},
    " 1 equivalent, 0 survive[^$]* scaled.T @ scaled: it has no proof": {"scaled @ scaled -> scaled.T @ scaled": " "},
    "LISTED IN VAIN _unit: .*: it loses points": {"axis / largest -> axis * largest": "it is"},
    "LISTED IN VAIN _unit: .*: there is no such mutant": {"axis -> largest": "it is"},
}
ASSIGNMENT = assignments.assignment(assignments.find(), HW08)
(CHECK,) = (check for check in ASSIGNMENT.checks if check.name == "skew_is_the_cross_product")


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("return -a", {"-a -> a"}),
        ("return a + b", {"a + b -> a - b", "a + b -> a", "a + b -> b", "a + b -> a + 2 * b"}),
        ("return a * b", {"a * b -> a / b"}),
        ("return a @ b", {"a @ b -> b @ a", "a @ b -> a.T @ b"}),
        ("return a ** 2", {"a ** 2 -> a ** 3", "a ** 2 -> a ** 1", "2 -> 4"}),
        ("return 0.5", {"0.5 -> 1.0", "0.5 -> 0.25"}),
        ("return np.sin(a)", {"np.sin(a) -> np.cos(a)"}),
        ("return f(a, b)", {"f(a, b) -> f(b, a)"}),
        ("return a[0]", {"a[0] -> a[1]"}),
        ("return a if a < b else b", {"a if a < b else b -> a", "a if a < b else b -> b", "a < b -> a <= b"}),
        ("return a.copy()", {"a.copy() -> a"}),
        ("return a.T", {"a.T -> a"}),
        ("return a < b and a", {"a < b -> a <= b", "a < b and a -> a < b or a"}),
        ("return a, b", {"(a, b) -> (b, a)"}),
        ("if a: return a\n    return b", {"a -> True", "a -> False"}),
    ],
)
def test_a_mutant_has_one_slip(body, expected):
    actual = mutants(HW08, f"def f(a, b):\n    {body}\n")
    assert {f"{item.was} -> {item.now}" for item in actual} == expected


@pytest.mark.slow
def test_no_slip_in_a_solution_keeps_full_marks(slug, capsys):
    assert cli.main(["audit", slug, "--jobs", "1"]) == 0, capsys.readouterr().out


@pytest.mark.parametrize("line", LISTED)
def test_the_audit_fails_where_a_mutant_survives_or_is_listed_in_vain(line, capsys, monkeypatch):
    listed = {("_unit", change): proof for change, proof in LISTED[line].items()}
    monkeypatch.setattr("tam570_grader.audit.mutation.equivalents", lambda course, slug: listed)
    assert cli.main(["audit", "hw08", "--function", "_unit", "--jobs", "1"]) == 1
    assert re.search(line, capsys.readouterr().out)


def test_the_bound_on_a_rate_is_that_of_the_binomial():
    """The bound p after k failures in n runs makes the probability of k or fewer failures 5 %."""
    assert fairness.upper_bound(0, 100) == pytest.approx(1 - 0.05 ** (1 / 100), rel=1e-12)
    p = fairness.upper_bound(2, 50)
    assert sum(math.comb(50, k) * p**k * (1 - p) ** (50 - k) for k in range(3)) == pytest.approx(0.05)
    assert fairness.upper_bound(3, 3) == 1


def test_right_submissions_are_fair_and_what_is_kept_is_not_run_again(tmp_path, capsys, monkeypatch):
    keep = tmp_path / "fair.jsonl"
    command = ["audit", "hw08", "--fairness", "2", "--jobs", "1", "--keep", str(keep)]
    assert cli.main(command) == 0
    out, lines = capsys.readouterr().out, keep.read_text()
    assert re.search(r"hw08_axis_angle: +\d+ runs, 0 false fails", out)
    keep.write_text(lines + '{"half a li')
    monkeypatch.setattr("tam570_grader.audit.fairness._graded", None)
    assert cli.main(command) == 0
    assert capsys.readouterr().out == out
    monkeypatch.setattr(assignments, "engine_digest", lambda: b"another grader")
    with pytest.raises(TypeError):
        cli.main(command)


def test_a_diagnosis_tells_named_from_unnamed_and_misled():
    def said(mistake, cause, messages=("the transpose",)):
        failed = result("s", check_result(suspect=cause, failure=Failure()))
        return diagnosis.diagnosis(failed, Mistake("", mistake, "a", ""), messages)

    correct, silent = said("the transpose", "the transpose"), said("the transpose", None)
    wrong, actual = said("a sign", "the transpose"), said("a sign", "the transpose", messages=())
    assert [item.is_named for item in (correct, silent, wrong, actual)] == [True, False, False, False]
    assert [item.misled for item in (correct, silent, wrong, actual)] == [False, False, True, False]
    assert diagnosis.faults([correct, silent]) == 1 and diagnosis.faults([correct]) == 0
    assert diagnosis.faults([correct] * 10 + [wrong]) == 1


@pytest.mark.slow
def test_the_margins_of_a_check_are_measured_from_both_sides(course):
    with executor(1) as here:
        actual = {margin.check: margin for margin in margins.margins(course, "hw12_bead_on_wire", 2, here)}
    energy = actual["simulate_keeps_the_energy"]
    assert 0 < 10 * energy.careful < 1 < energy.physics[1] / 10 and energy.physics[0]
    assert not any("accelerat" in check for check in actual)


def test_wrong_physics_is_judged_by_its_distance_and_inaccurate_numerics_is_not():
    actual = [("DOP853", {"energy": 0.01}), ("friction", {"energy": 50.0}), ("coarse", {"energy": 2.0})]
    actual += [("another_check", {"energy": 0.5}), ("no_number", {"energy": np.inf})]
    by_name = {
        "friction": Mistake("friction", "A force too many.", "energy", ""),
        "coarse": Mistake("coarse", "Few steps.", "energy", "", numerics=True),
        "another_check": Mistake("another_check", "What this check need not tell.", "path", ""),
        "no_number": Mistake("no_number", "An exception.", "energy", ""),
    }
    margin = margins.margin("energy", actual, by_name)
    assert margin == Margin("energy", 0.01, ("friction", 50.0), ("coarse", 2.0)) and not margin.small
    by_name["coarse"] = replace(by_name["coarse"], numerics=False)
    assert margins.margin("energy", actual, by_name).small


def test_the_fewest_cases_are_the_cheap_ones_that_catch_all():
    cheap, costly, both, alone = (Key("a check", "f", name, 1) for name in ("cheap", "costly", "both", "alone"))
    caught = {(0, "sign"): {cheap, costly}, (0, "factor"): {both, costly}}
    caught |= {(1, "sign"): {both}, (0, "steps"): {alone, costly}}
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
    solution = Replies(solution_with(solution_text(HW08), ""))
    text = f"\n_skew = skew\ndef skew(v):\n    v = np.array(v)\n    {wrong}\n    return _skew(v)\n"
    module = solution_with(solution_text(HW08), text)
    student = LocalStudent(ASSIGNMENT, CHECK, solution, Replies(module, solution, frozenset({"skew"})))
    failed = failed_cases(student, CHECK, 5, HW08)
    assert {case.label for case in failed} == {label}
    assert len(failed) == sum(case.label == label for case in student.cases)


def test_a_slip_alone_is_in_one_function_and_others_call_the_right_one(solution_text):
    correct = solution_text(HW08)
    slipped = next(item for item in mutants(HW08, correct) if item.function == "skew")
    calls = {"a check": {"skew", "rotate"}, "another": {"rotation_matrix"}}
    actual, as_it_was = {}, {}
    _, alone = mutation.to_catch(correct, [slipped], calls)
    exec(alone.text, actual)
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
        return {**calls, **{name: calls[name] - {"skew"} for name in holes}, "not there": {"skew"}}, longest

    monkeypatch.setattr(mutation, "calls_of_checks", without)
    assert cli.main(["audit", "hw08", "--function", "skew", "--jobs", "1"]) == hole
    assert ("SURVIVES" in capsys.readouterr().out) == hole


@pytest.mark.parametrize("outcome, most", [("return -right(v)", 8), ("os._exit(1)", 1)])
def test_a_check_fails_with_the_seeds_with_which_a_grading_fails_it(outcome, most, course, solution_text):
    wrong = f"\n\nimport os\nright = skew\ndef skew(v):\n    if v[0] > 1.4: {outcome}\n    return right(v)\n"
    check, seeds = "skew_is_the_cross_product", range(8)
    grading = Grading(course, HW08, "", solution_text(HW08) + wrong, 0, checks=frozenset({check}))
    results = [tried(replace(grading, seed=seed)) for seed in seeds]
    failing = [seed for seed, result in zip(seeds, results, strict=True) if result.score < result.max_score]
    assert 1 < len(failing) < len(seeds)
    assert seeds_that_fail(grading, check, seeds) == {*failing[:most]}  # after a crash, later seeds are left out
