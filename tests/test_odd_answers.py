"""Odd answers cost a student points, and nobody else anything: no grader error, no page lost, no run ended."""

import json
import random
from pathlib import Path
from types import SimpleNamespace

import pytest

from tam570_grader.checks import assignments
from tam570_grader.reports import feedback, report
from tam570_grader.results import records
from tam570_grader.sandbox.student import Student

COURSE = assignments.find()
ODD = (Path(__file__).parent / "odd_answers.py").read_text()
CASES = [("hw08_axis_angle", 50)]  # assignments, and how many odd answers at least
CASES += [pytest.param(slug, 2000, marks=pytest.mark.slow) for slug in assignments.slugs(COURSE)]
SHARES = (1.0,) * 7 + (0.2,)  # of the calls that are answered oddly, in turn


@pytest.fixture
def counted(monkeypatch):
    """How many answers were odd: of those of the functions `counted.names` the share `counted.share`."""
    real, counted = Student.replies, SimpleNamespace(names=(), share=1.0, answers=0.0)

    def replies(student, name, *args, **kwargs):
        came = real(student, name, *args, **kwargs)
        counted.answers += counted.share * len(came) if name in counted.names else 0
        return came

    monkeypatch.setattr(Student, "replies", replies)
    return counted


def submission(slug, text, seed, share):
    """The solution with its functions answering oddly, each call of all of them or some of a few, and their names."""
    rng = random.Random(f"{slug} {seed}")
    names = [*assignments.assignment(COURSE, slug).results]
    names = names if share == 1 else rng.sample(names, min(len(names), rng.choice([1, 2, 4])))
    return f"{text}\nODD = {seed}, {names}, {share}\n{ODD}", names


@pytest.mark.parametrize(("slug", "least"), CASES)
def test_odd_answers_cost_points_alone(slug, least, grade, solution_text, counted):
    info, results, faults, seed = feedback.load_assignment_info(COURSE, slug), {}, [], 0
    while counted.answers < least:
        counted.share = SHARES[seed % len(SHARES)]
        text, counted.names = submission(slug, solution_text(slug), seed, counted.share)
        result = grade(slug, text, seed)
        back = records.read(json.loads(json.dumps(result.record(), allow_nan=False)))
        feedback.page(back, info)
        faults += [(seed, check.name, check.error) for check in back.checks if check.error]
        faults += [(seed, check.name, each.fault) for check in back.checks if (each := check.failure) and each.fault]
        results[f"s{seed}", slug] = back
        seed += 1
    report.report(report.newest(results.values()), {slug: info})
    assert not faults, faults
