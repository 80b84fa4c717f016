"""Ticks of the curves in feedback: round numbers, in the frame, where they say."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tam570_grader.reports.pictures import BOTTOM, LEFT, RIGHT, TOP, picture


def curve(values, tolerance=1e-3, scale="linear"):
    return {"quantity": "the energy", "unit": "J", "tolerance": tolerance, "values": values, "scale": scale}


def mantissas(step):
    return step / 10 ** math.floor(math.log10(step) + 1e-9)


@given(st.lists(st.floats(-1.0, 1.0), min_size=2, max_size=9), st.integers(-12, 3))
def test_ticks_are_round_and_in_the_frame(values, power):
    ticks = picture(curve([value * 10.0**power for value in values], tolerance=10.0 ** (power - 2))).y
    assert 3 <= len(ticks) <= 8 and all(TOP - 0.1 <= place <= BOTTOM + 0.1 for place, _ in ticks)
    numbers = [float(text) for _, text in ticks]
    step = numbers[1] - numbers[0]
    assert min(abs(mantissas(abs(step)) - one) for one in (1, 2, 5, 10)) < 1e-3
    assert all(abs(number / step - round(number / step)) < 1e-3 for number in numbers)


@pytest.mark.parametrize("scale", ["linear", "log"])
@pytest.mark.parametrize("values", [[0.0, 0.0], [0.0, 1e-3], [5.0, 5.0]])
def test_times_are_quarters_of_the_motion(values, scale):
    """Whatever the values are, equal ones too; the times themselves are hidden."""
    drawn = picture(curve(values, scale=scale))
    assert [text for _, text in drawn.x] == ["start", "1/4", "1/2", "3/4", "end"]
    assert (drawn.x[0][0], drawn.x[-1][0]) == (LEFT, RIGHT)
