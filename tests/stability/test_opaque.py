"""Right-hand sides that cannot be analyzed: a run sees their pulses, and costs little more than SciPy's if smooth."""

import math
import struct

import numpy as np
import pytest
from run_time.public import PROBLEMS
from scipy.integrate import quad, solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation

from tam570.integrate import solve

END = 10.0
POINTS = 1000  # of a run, at least


def opaque(rates):
    """Return the same rates by a function whose decisions `solve` cannot detect, and a list with an item per call."""
    calls = []

    def counted(t, y):
        calls.append(t)
        plain = struct.unpack(f"{1 + len(y)}d", struct.pack(f"{1 + len(y)}d", t, *y))  # only of numbers
        return rates(plain[0], plain[1:])

    return counted, calls


def box(x):
    return 1.0 if abs(x) <= 0.5 else 0.0


def bell(x):
    return math.exp(-math.pi * x * x)


def tent(x):
    return max(0.0, 1.0 - abs(x))


SHAPES = [box, bell, tent]  # of width and area 1


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("width", [1.0, 1.4, 1.9, 2.7, 5.0, 9.0, 25.0, 70.0])
@pytest.mark.parametrize("middle", [1.2345678, 4.56789, 8.7654321])
def test_a_pulse_of_time_as_long_as_a_thousandth_of_the_run_is_seen(shape, width, middle):
    duration = width * 1.001 * END / POINTS  # an edge may be just beyond a point

    def rates(t, y):
        return y[1], -y[0] + 0.1 * shape((t - middle) / duration)

    def quiet(t, y):
        return y[1], -y[0]

    states = solve(opaque(rates)[0], [0, END], [1.0, 0.0])
    expected = solve(rates, [0, END], [1.0, 0.0], rtol=1e-12)
    assert np.abs(solve(quiet, [0, END], [1.0, 0.0]) - expected).max() > 1e-5  # the pulse matters
    assert states == pytest.approx(expected, rel=0, abs=1e-8)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("width", [1.0, 1.4, 2.7, 9.0, 70.0])
def test_a_pulse_in_a_window_of_the_state_is_seen(shape, width):
    duration = width * 1.001 * END / POINTS

    def rates(t, y):  # y[0] passes each value once
        return 0.5 + 1.0 / (1.0 + t), 0.1 * shape((y[0] - 3.3) / duration)

    rate = 0.5 + 1.0 / (1.0 + 3.1)  # the least rate of y[0] near 3.3 is larger than this
    states = solve(opaque(rates)[0], [0, END], [0.0, 0.0])
    expected = solve(rates, [0, END], [0.0, 0.0], rtol=1e-12)
    assert expected[-1, 1] > 0.05 * duration / rate
    assert states == pytest.approx(expected, rel=0, abs=1e-8)


@pytest.mark.parametrize("jump", [0.3, 2.2222, 7.77])
def test_a_jump_is_seen(jump):
    def rates(t, y):
        return (1.0 if t < jump else 2.0,)

    states = solve(opaque(rates)[0], [0, END], [0.0])
    assert states[-1, 0] == pytest.approx(2 * END - jump, rel=1e-9)


@pytest.mark.parametrize("rtol", [1e-6, 1e-10])
@pytest.mark.parametrize("name", ["DETEST A3", "DETEST B4", "DETEST D3", "DETEST E3", "Brusselator", "Pleiades"])
def test_a_smooth_function_costs_a_thousand_points_and_a_few_per_step(name, rtol):
    rates, start, end = PROBLEMS[name]
    function, calls = opaque(rates)
    report = solve(function, [0, end], start, rtol=rtol, report=True).report
    assert report.unseen_reason
    assert len(calls) < report.evaluations + POINTS + 15 * (report.steps + 10)
    assert report.steps < 600


MATRIX = np.array([[2.0, 0.3, 0], [0.3, 1.5, 0.2], [0, 0.2, 1.0]])
LIBRARIES = {
    "Rotation": (
        lambda t, y: np.cross(Rotation.from_rotvec([0.1 * t, 0.2, 0.3]).apply([1.0, 0, 0]), y),
        [1.0, 2.0, 3.0],
    ),
    "expm": (lambda t, y: expm(-0.1 * t * MATRIX) @ -y, [1.0, 0.0, 0.0]),
    "brentq": (lambda t, y: [brentq(lambda x: x + 0.5 * math.sin(x) - y[0], -9, 9) * -0.3], [2.0]),
    "quad": (lambda t, y: [-y[0] * quad(lambda x: math.exp(-x * x), 0, 1 + y[0] ** 2)[0]], [1.0]),
}


@pytest.mark.parametrize("name", LIBRARIES)
def test_functions_of_libraries_cost_little_more_than_in_scipy(name):
    rates, start = LIBRARIES[name]
    calls = []

    def counted(t, y):
        calls.append(t)
        return rates(t, y)

    states = solve(counted, [0, 5.0], start)
    ours = len(calls)
    reference = solve_ivp(counted, (0, 5), start, method="DOP853", rtol=1e-10, atol=1e-12)
    assert states[-1] == pytest.approx(reference.y[:, -1], rel=1e-8, abs=1e-9)
    assert ours < 2 * (len(calls) - ours) + 1.6 * POINTS
