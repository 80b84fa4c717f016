"""Laws of the lectures on the string, the top, and the particle on a surface."""

import math

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.lectures import string, surface, top

DRAW = np.random.default_rng(572)


def test_newton_and_lagrange_agree_on_the_string():
    for _ in range(10):
        state = [*DRAW.uniform(0.2, 3, 1), *DRAW.normal(size=3)]
        parameters = {"masses": DRAW.uniform(0.1, 5, 2), "gravity": 9.81}
        accelerations, tension = string.by_newton(state, **parameters)
        assert accelerations == pytest.approx(string.by_lagrange(state, **parameters), rel=1e-12, abs=1e-12)
        # the mass below by itself: m2 r'' = T - m2 g
        assert tension == pytest.approx(parameters["masses"][1] * (accelerations[0] + 9.81), rel=1e-12)


TOP = {"mass": 0.8, "distance": 0.3, "axial": 0.02, "transverse": 0.09, "gravity": 9.81}
WEIGHT = 0.8 * 0.3 * 9.81


@pytest.mark.parametrize("tilt", [0.4, 1.2, math.pi / 2 + 0.3, 2.8])
@pytest.mark.parametrize("spin", [60.0, -60.0])
def test_steady_precession_stays_steady(tilt, spin):
    slow, fast = top.steady_precession(tilt, spin, **TOP)
    assert abs(slow) < abs(fast)
    for W in (slow, fast):
        balance = TOP["transverse"] * math.cos(tilt) * W**2 - TOP["axial"] * spin * W + WEIGHT
        assert abs(balance) < 1e-12 * (WEIGHT + abs(TOP["axial"] * spin * W))
        rates = top.rates(0.0, (0.2, tilt, 0.1, W, 0.0, spin - W * math.cos(tilt)), **TOP)
        assert rates[3:] == pytest.approx((0.0, 0.0, 0.0), abs=1e-10)


def test_a_level_top_precesses_as_the_classics_have_it():
    slow, fast = top.steady_precession(math.pi / 2, 40.0, **TOP)
    assert slow == pytest.approx(top.classic_precession(40.0, **TOP), rel=1e-14) and math.isinf(fast)
    assert top.classic_precession(40.0, **TOP) == pytest.approx(WEIGHT / (0.02 * 40.0))
    near = top.steady_precession(math.pi / 2 - 1e-3, 40.0, **TOP)[0]
    assert near == pytest.approx(slow, rel=1e-2) and near != slow


def test_too_slow_a_top_has_no_steady_precession():
    limit = math.sqrt(4 * TOP["transverse"] * math.cos(0.5) * WEIGHT) / TOP["axial"]
    top.steady_precession(0.5, limit * (1 + 1e-9), **TOP)
    with pytest.raises(ValueError, match="no steady precession"):
        top.steady_precession(0.5, limit * (1 - 1e-9), **TOP)
    with pytest.raises(ValueError, match="no steady precession"):
        top.steady_precession(math.pi / 2, 0.0, **TOP)
    assert top.steady_precession(2.5, 0.0, **TOP)[0] == pytest.approx(-top.steady_precession(2.5, 0.0, **TOP)[1])


@pytest.mark.parametrize("share", [0.97, 1.03])
def test_a_top_sleeps_as_its_motion_does(share):
    """Next to upright: within 3 s the tilt grows many times, or hardly."""
    spin = share * math.sqrt(4 * TOP["transverse"] * WEIGHT) / TOP["axial"]
    start = (0.0, 1e-4, 0.0, spin * TOP["axial"] / (2 * TOP["transverse"]), 0.0, 0.0)
    start = (*start[:5], spin - start[3])
    tilts = solve(top.rates, np.linspace(0.0, 3.0, 100), start, parameters=TOP)[:, 1]
    assert top.sleeps(spin, **TOP) == (tilts.max() < 1e-3) == (share > 1)


@pytest.mark.parametrize("shape", ["bowl", "saddle", "plane"])
def test_the_force_of_the_surface_does_no_virtual_work(shape):
    """Along both tangents it vanishes; with the weight it gives F = m a of the motion in space."""
    parameters = {"mass": 1.7, "gravity": 9.81, "surface": shape, "curvature": 0.8}
    sx, sy = {"bowl": (0.8, 0.8), "saddle": (0.8, -0.8), "plane": (0, 0)}[shape]
    for x, y, u, v in DRAW.normal(size=(5, 4)):
        force = surface.constraint_force([x, y, u, v], **parameters)
        assert [force @ [1, 0, sx * x], force @ [0, 1, sy * y]] == pytest.approx([0, 0], abs=1e-12)
        _, _, ax, ay = surface.rates(0.0, [x, y, u, v], **parameters)
        az = sx * (u * u + x * ax) + sy * (v * v + y * ay)
        assert force - [0, 0, 1.7 * 9.81] == pytest.approx(1.7 * np.array([ax, ay, az]), abs=1e-11)
