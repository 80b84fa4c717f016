"""Odd answers cost only points: they cause no grader error, and feedback and report are still written."""

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
CASES = [("hw08_axis_angle", 50)]  # (assignment, least number of odd answers)
CASES += [pytest.param(slug, 2000, marks=pytest.mark.slow) for slug in assignments.slugs(COURSE)]
SHARES = (1.0,) * 7 + (0.2,)  # share of the calls that return an odd answer, used in turn by successive submissions


@pytest.fixture
def counted(monkeypatch):
    """Count the odd answers in `counted.answers`: the share `counted.share` of the calls of `counted.names`."""
    real, counted = Student.replies, SimpleNamespace(names=(), share=1.0, answers=0.0)

    def replies(student, name, *args, **kwargs):
        came = real(student, name, *args, **kwargs)
        counted.answers += counted.share * len(came) if name in counted.names else 0
        return came

    monkeypatch.setattr(Student, "replies", replies)
    return counted


def submission(slug, text, seed, share):
    """Return the solution with odd answers (all functions if share is 1, else a few) and the names of the functions."""
    rng = random.Random(f"{slug} {seed}")
    names = [*assignments.assignment(COURSE, slug).returns]
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
