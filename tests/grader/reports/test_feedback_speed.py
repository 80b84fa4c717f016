"""Run time against error on a student's page: what is measured, where the point is drawn, what it is compared with."""

import json
import runpy

import numpy as np
import pytest
from classes import hand_in

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.reports.pictures import BOTTOM, LAST, LEFT, TOP, among
from tam570_grader.results.run_time import scenes

SLUG = "hw07_double_pendulum"
SPEED = {"function": "simulate", "scene": "double pendulum", "seconds": 0.1, "error": 1e-6, "machine": 0.5}


def test_what_the_pages_know_of_run_times_is_made_from_the_benchmark(course):
    path = course / "benchmarks" / "run_time_for_pages.py"
    program = runpy.run_path(str(path))
    stored = json.loads(program["PLACE"].read_text())
    assert json.loads(json.dumps(program["shared"]())) == stored, f"run: python {path.relative_to(course)}"
    assert set(stored) <= set(assignments.slugs(course)) and len(stored) > 4


@pytest.mark.parametrize("what", ["return t", "raise NotImplementedError", "import os; os._exit(0)"])
def test_a_simulation_that_is_none_has_no_point(grade, solution_text, what):
    text = solution_text(SLUG) + f"\n\ndef simulate(t, *args, **kwargs):\n    {what}\n"
    assert grade(SLUG, text, 1, speed=True).speed is None


@pytest.mark.parametrize(("seconds", "error"), [(1e-4, 1e-15), (0.1, 1e-6), (30.0, 9e-3)])
@pytest.mark.parametrize("slug", scenes())
def test_the_point_is_in_the_frame_where_its_numbers_say(slug, seconds, error):
    drawn = among(slug, {**SPEED, "seconds": seconds, "error": error})
    x, y = drawn.point
    assert LEFT <= x <= LAST and TOP <= y <= BOTTOM
    for position, ticks, value in ((x, drawn.x, error), (y, drawn.y, seconds)):
        places, decades = zip(*[(at, float(text[2:])) for at, text in ticks], strict=True)
        assert np.polyval(np.polyfit(places, decades, 1), position) == pytest.approx(np.log10(value), abs=0.05)


def test_it_is_measured_when_asked_for_and_stands_on_the_page(tmp_path, solution_text, capsys):
    hand_in(tmp_path / "in", {"ada": solution_text(SLUG)}, SLUG)
    pages, actual = [], []
    for options in ([], ["--speed"]):
        command = ["grade", str(tmp_path / "in"), "--out", str(tmp_path / "out"), "--seed", "1", "--json", *options]
        assert cli.main(command) == 0
        actual.append(json.loads(capsys.readouterr().out))
        pages.append((tmp_path / "out" / "feedback" / "ada" / f"{SLUG}.html").read_text())
    assert ["speed" in line for line in actual] == [False, True]
    assert ["Run time against error" in page for page in pages] == [False, True]
