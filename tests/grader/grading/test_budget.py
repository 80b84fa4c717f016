"""The grader limits the work and memory of each check: a check that needs too much fails, and the others run."""

import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
from parameters import first

from tam570.meter import Exhausted, Meter, limited
from tam570_grader.checks import assignments, effort
from tam570_grader.checks.case import Call, Case
from tam570_grader.checks.effort import PACKAGES, Finder, compile_counted
from tam570_grader.diagnosis import diagnose
from tam570_grader.diagnosis.mistakes import MOST_STEPS, NoValue, answer
from tam570_grader.grading import budget, consequences
from tam570_grader.grading.run_checks import graded
from tam570_grader.sandbox.student import Source
from tam570_grader.sandbox.zygote import ResourceLimits

SLUG = "hw08_axis_angle"
FEW = 100_000  # steps
LITTLE = 2**28  # bytes
ENDLESS = """
def endless(*_):
    while True:
        pass
"""
SPRING = """
def simulate(n):
    from tam570.integrate import solve
    return solve(lambda t, y: (y[1], -n * y[0]), [0.0, 1.0], [1.0, 0.0], report=True)
"""


def compiled(text):
    names = {}
    exec(compile_counted(text, "<text>"), names)
    return names


def grows(*_):
    return [np.empty(2**24) for _ in range(100)]


@pytest.fixture
def evaluated(course, zygotes, solution_text, monkeypatch):
    """`evaluated(run, name, text)` -> the result if the check `name` calls `run`; the default text is the solution."""
    assignment = assignments.assignment(course, SLUG)
    monkeypatch.setattr(consequences, "budget", lambda: budget.budget(FEW, LITTLE))

    def evaluated(run=None, name="", text=""):
        checks = [replace(check, run=run) if check.name == name else check for check in assignment.checks]
        source = Source((text or solution_text(SLUG)).encode())
        return graded("ada", source, replace(assignment, checks=tuple(checks)), zygotes(SLUG, ResourceLimits()), 1)

    return evaluated


@pytest.mark.parametrize(("run", "words"), [(compiled(ENDLESS)["endless"], "work"), (grows, "memory")])
def test_a_check_that_does_not_end_fails_alone(run, words, evaluated, course):
    check = assignments.assignment(course, SLUG).checks[-1]
    result = evaluated(run, check.name)
    assert result.status == "graded" and result.score == 10 - check.points
    assert words in result.checks[-1].message
    assert evaluated().score == 10


def test_memory_is_limited_where_a_cluster_grades_in_a_thread_of_its_own(evaluated, course):
    assert evaluated().score == 10  # starts the zygote in this thread, because it ends with its thread
    name = assignments.assignment(course, SLUG).checks[-1].name
    with ThreadPoolExecutor(1) as pool:
        result = pool.submit(evaluated, grows, name).result()
    assert "memory" in result.checks[-1].message
    assert evaluated().score == 10


def test_to_look_for_a_mistake_is_part_of_it(evaluated, solution_text, monkeypatch):
    monkeypatch.setattr(diagnose, "named_mistake", compiled(ENDLESS)["endless"])
    result = evaluated(text=solution_text(SLUG) + "\n\ndef skew(v): return np.eye(3)")
    assert result.status == "graded"
    assert {check.suspect for check in result.checks} == {None}


def test_steps_are_counted_of_rates_that_are_traced_and_would_be_compiled():
    simulate = compiled(SPRING)["simulate"]
    with limited(10**6) as slow:
        simulate(1.0)
    with limited(10**6) as fast:
        motion = simulate(1e4)
    assert slow.remaining > fast.remaining + 1000
    assert not motion.report.untraced_reason
    assert motion.states[-1, 0] == pytest.approx(np.cos(100), abs=1e-6)
    with limited(1000), pytest.raises(Exhausted):
        simulate(1e4)


@pytest.mark.parametrize("number", first(1, ["1e300", "-1e30", "1e6"]))
def test_rows_that_are_absurd_are_judged_by_every_check(number, grade, solution_text, course):
    """No check runs out of its budget, though an integration from such a row would never end."""
    slug = "hw10_free_rigid_body"
    absurd = "\n\ndef simulate(t, R, omega, *, inertia):\n    return [np.stack([x, *{}[1:]]) for x in (omega, R)]"
    absurd = absurd.format(f"np.full((len(t), *np.shape(x)), {number})")
    result = grade(slug, solution_text(slug) + absurd, naming=False)
    assert result.status == "graded"
    assert not any(check.message and "to judge" in check.message for check in result.checks)
    lines = {check.name: check.title for check in assignments.assignment(course, slug).checks}
    of_motions = ("simulate", "plot_rim_paths")  # plot_rim_paths calls simulate
    assert all(check.outcome == "passed" for check in result.checks if not lines[check.name].startswith(of_motions))


def test_a_module_that_was_left_compiled_is_read_until_its_text_changes(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    monkeypatch.setattr(sys, "pycache_prefix", None)
    file = tmp_path / "endless.py"

    def loaded(text):
        file.write_text(text)
        names = {}
        exec(Finder.find_spec(f"{PACKAGES}.endless", [str(tmp_path)]).loader.get_code(f"{PACKAGES}.endless"), names)
        return names["endless"]

    for _ in range(2):
        with limited(9), pytest.raises(Exhausted):
            loaded(ENDLESS)()
        monkeypatch.setattr(effort, "compile_counted", None)
    monkeypatch.undo()
    assert loaded(ENDLESS.replace("while True", "for _ in range(9)"))() is None


def test_a_mistake_that_runs_away_has_no_answer_and_leaves_steps_for_the_others():
    call, more = Call("endless", Case(), None), 2 * MOST_STEPS
    with limited(more) as meter:
        assert answer("def endless():\n    return 1.0\n", ENDLESS, call) is NoValue
        assert 0 < meter.remaining < more
    with pytest.raises(Exhausted), limited(FEW):  # the budget of the diagnosis ends it as before
        answer("def endless():\n    return 2.0\n", ENDLESS, call)


def test_steps_of_several_blocks_count_in_one_meter():
    meter, names = Meter(10), compiled("def step():\n    return 1\n")
    for _ in range(5):
        with meter.running():
            names["step"]()
    assert meter.remaining == 5
    with pytest.raises(Exhausted), meter.running():
        for _ in range(6):
            names["step"]()
