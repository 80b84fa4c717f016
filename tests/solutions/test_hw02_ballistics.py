"""hw02: by which size the hidden check judges a flight."""

import math

import numpy as np
import pytest

from tam570_grader import Case
from tam570_grader.checks import assignments

ballistics = assignments.solution("hw02_ballistics")

BALL = {"mass": 1.7, "gravity": 9.81}  # kg, m/s^2
SPEED = 30.0  # m/s


def test_the_size_of_a_flight_back_at_launch_height_is_that_of_its_path():
    """At the ends alone it has none: no simulation would be right to a part of that."""
    columns = assignments.assignment(assignments.find(), "hw02_ballistics").results["simulate"].columns
    time = ballistics.flight_time(SPEED, math.pi / 2, drag=0.3, **BALL)
    call = Case(np.array([2.0, 2.0 + time]), SPEED, math.pi / 2, drag=0.3, **BALL)
    ends = ballistics.trajectory(call.args[0] - 2.0, *call.args[1:], **call.kwargs)
    top = ballistics.trajectory(np.linspace(0.0, time, 101), *call.args[1:], **call.kwargs)[:, 1].max()
    assert [column.scale(call, ends) for column in columns] == pytest.approx([top, top, SPEED, SPEED], rel=0.05)
