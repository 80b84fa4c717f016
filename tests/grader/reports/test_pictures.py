"""Ticks of the curves in feedback: round numbers, in the frame, where they say."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tam570_grader.reports.pictures import BOTTOM, LEFT, RIGHT, TOP, picture


def curve(first, last, values, tolerance=1e-3, scale="linear"):
    known = {"quantity": "the energy", "unit": "J", "tolerance": tolerance, "span": (first, last), "values": values}
    return {**known, "scale": scale}


def mantissas(step):
    return step / 10 ** math.floor(math.log10(step) + 1e-9)


@given(
    st.floats(-1e3, 1e3),
    st.floats(1e-2, 1e3),
    st.lists(st.floats(-1.0, 1.0), min_size=2, max_size=9),
    st.integers(-12, 3),
)
def test_ticks_are_round_and_in_the_frame(first, lasts, values, power):
    drawn = picture(
        curve(first, first + lasts, [value * 10.0**power for value in values], tolerance=10.0 ** (power - 2))
    )
    for ticks, ends in ((drawn.x, (LEFT, RIGHT)), (drawn.y, (TOP, BOTTOM))):
        assert 3 <= len(ticks) <= 8 and all(min(ends) - 0.1 <= place <= max(ends) + 0.1 for place, _ in ticks)
        numbers = [float(text) for _, text in ticks]
        step = numbers[1] - numbers[0]
        assert min(abs(mantissas(abs(step)) - one) for one in (1, 2, 5, 10)) < 1e-3
        assert all(abs(number / step - round(number / step)) < 1e-3 for number in numbers)


@pytest.mark.parametrize(("first", "last", "texts"), [(0.0, 10.0, "0 2 4 6 8 10"), (0.37, 7.2, "1 2 3 4 5 6 7")])
def test_times_are_where_they_say(first, last, texts):
    drawn = picture(curve(first, last, [0.0, 1e-3]))
    assert " ".join(text for _, text in drawn.x) == texts
    for place, text in drawn.x:
        assert place == pytest.approx(LEFT + (RIGHT - LEFT) * (float(text) - first) / (last - first))
