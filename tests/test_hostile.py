"""An attack earns only the points of its correct functions, affects no other student, and leaves nothing behind."""

import ast
import contextlib
import os
import re
import time
from pathlib import Path

import psutil
import pytest
from processes import await_end, descendants

from tam570_grader.checks import assignments
from tam570_grader.grading import run_checks
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.process import ProcessLost
from tam570_grader.sandbox.student import Student
from tam570_grader.sandbox.zygote import ResourceLimits

COURSE = assignments.find()
SLUG = "hw08_axis_angle"
FILES = sorted((Path(__file__).parent / "hostile").glob("*.py"))
# `recurses` runs until its time limit, as an endless loop does.
SLOW = [path for k, path in enumerate(FILES) if k % 8 or path.stem == "recurses"]
ATTACKS = [pytest.param(path, marks=[pytest.mark.slow] * (path in SLOW)) for path in FILES]
# None of its functions calls another, so an attack on one function costs no points of the others.
HONEST = COURSE / "autograder" / "checks" / SLUG / "alternatives" / "quaternions_and_lists.py"
JUNK = """
def skew(v): return [[0.0] * 3] * 3
def rotation_matrix(axis, angle): return [[0.0] * 3] * 3
def rotate(r, axis, angle): return [0.0] * 3
"""
BRIEF = ResourceLimits(cpu=4, call=1)
A_CHECK = 2.0  # s of processor time that the supervisor needs to check the correct functions
pytestmark = pytest.mark.skipif(isolation() != "bubblewrap", reason="needs bubblewrap and namespaces")


@pytest.fixture
def attacked(grade):
    """`attacked(path, honest=...)` -> the result of the attack appended to correct functions or to JUNK."""

    def attacked(path, *, honest):
        text = (HONEST.read_text() if honest else JUNK) + "\n\n" + path.read_text()
        return grade(SLUG, text, seed=2, limits=BRIEF)

    return attacked


def said(result):
    return [(check.name, check.outcome, check.message, check.error) for check in result.checks] + [result.message]


@pytest.mark.parametrize("path", ATTACKS, ids=lambda path: path.stem)
def test_an_attack_gains_nothing(path, attacked):
    result = attacked(path, honest=False)
    assert result.score == 0, said(result)


@pytest.mark.parametrize("path", ATTACKS, ids=lambda path: path.stem)
def test_the_honest_part_keeps_its_points_and_the_next_student_notices_nothing(
    path, attacked, grade, solution_text, zygotes
):
    deserves = re.search(r"^deserves: (.+)$", ast.get_docstring(ast.parse(path.read_text())), re.MULTILINE)[1]
    result = attacked(path, honest=True)
    if deserves.replace(".", "").isdigit():
        assert result.score == float(deserves), said(result)
    else:
        assert result.score is not None and result.score < result.max_score, said(result)
    after = grade(SLUG, solution_text(SLUG), seed=2, limits=BRIEF)
    assert after.score == after.max_score, said(after)
    zygote = zygotes(SLUG, BRIEF)
    zygote.process(cpu=1.0).drop()  # this also ends the process that waits for the next submission
    # only descendants, because the zygote of another xdist worker may use the same user id
    await_end([child for child in descendants(os.getpid()) if zygote.user in owners(child)])
    assert not planted(), "left lying about"


@pytest.mark.slow
def test_a_class_of_attackers_costs_their_allowances_and_no_more(grade, solution_text, zygotes, monkeypatch):
    """Every second attack and then the solution run in one zygote, which survives; no attack exceeds its time limit."""
    spent = []

    class Counted(Student):
        def leave(self):
            with contextlib.suppress(ProcessLost):
                spent.append(self.seconds())
            super().leave()

    monkeypatch.setattr(run_checks, "Student", Counted)
    zygote, limits = zygotes(SLUG, BRIEF), BRIEF
    for path in FILES[::2]:
        before = time.thread_time()
        grade(SLUG, HONEST.read_text() + "\n\n" + path.read_text(), seed=2, limits=BRIEF)
        ours = time.thread_time() - before
        assert ours <= limits.cpu + A_CHECK, f"{path.stem} cost the supervisor {ours} s"
    honest = grade(SLUG, solution_text(SLUG), seed=2, limits=BRIEF)
    assert honest.score == honest.max_score and zygotes(SLUG, BRIEF) is zygote
    assert max(spent) <= limits.cpu + 1  # the kernel counts in seconds


def test_no_hidden_input_comes_back(attacked):
    attack = next(path for path in FILES if path.stem == "tells_the_inputs")
    result = attacked(attack, honest=True)
    assert not any("LEAK" in check.message for check in result.checks), said(result)


def owners(process):
    with contextlib.suppress(psutil.NoSuchProcess):
        return process.uids()
    return ()


def planted():
    places = ("/", "/tmp", "/var/tmp", "/dev/shm", "/root", os.getcwd(), os.path.dirname(os.__file__))
    return [folder for folder in places if os.path.exists(os.path.join(folder, "tam570-was-here"))]
