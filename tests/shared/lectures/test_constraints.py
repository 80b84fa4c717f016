"""Laws of the lectures on constraints: rods, trusses, a car, a bar, a sleigh, a string, a top, a surface."""

import math

import numpy as np
import pytest
from scipy.special import ellipkm1

from tam570.integrate import solve
from tam570.invariants import observed_order
from tam570.lectures import rod, sleigh, stopping_car, string, surface, swinging_bar, top, truss

DRAW = np.random.default_rng(914)
WAYS = [stopping_car.by_centre_of_mass, stopping_car.by_three_points, stopping_car.by_one_point]
BAR = {"mass": 0.7, "length": 1.3, "gravity": 9.81}
BODY = {"mass": 0.7, "inertia": 0.2, "offset": 0.4}
TOP = {"mass": 0.8, "distance": 0.3, "axial": 0.02, "transverse": 0.09, "gravity": 9.81}
WEIGHT = 0.8 * 0.3 * 9.81


def test_both_ways_to_a_rod_agree():
    for _ in range(20):
        forces, masses = DRAW.normal(size=2), DRAW.uniform(0.1, 3.0, 2)
        (a, T), other = rod.by_constraint(forces, masses=masses), rod.by_elimination(forces, masses=masses)
        assert (a, T) == pytest.approx(other, rel=1e-12)
        assert masses * a == pytest.approx(forces + [T, -T], rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("way", [rod.by_constraint, rod.by_elimination])
def test_massless_ends_hand_the_force_on(way):
    assert way((3.0, -1.0), masses=(0.0, 2.0)) == pytest.approx((1.0, -3.0))
    assert way((3.0, -1.0), masses=(2.0, 0.0)) == pytest.approx((1.0, -1.0))


def test_ten_times_as_stiff_is_ten_times_as_rigid():
    t = np.linspace(0, 0.5, 6)
    stiffnesses, gaps = np.array([1e4, 1e5, 1e6]), []
    for stiffness in stiffnesses:
        parameters = {**truss.EXAMPLE, "stiffness": stiffness}
        moved = solve(truss.rates, t, truss.START, parameters=parameters, rtol=1e-12)
        gaps.append(np.abs(moved - truss.rigid(t, truss.START, **parameters))[:, :8].max())
    assert observed_order(1 / stiffnesses, gaps) == pytest.approx(1.0, abs=0.15)


def test_the_rigid_body_keeps_lengths_and_momenta():
    start = np.array(truss.START) + 0.1 * DRAW.normal(size=16)
    t = np.linspace(2.0, 9.0, 8)
    states = truss.rigid(t, start, **truss.EXAMPLE)
    assert states[0, :8] == pytest.approx(start[:8], abs=1e-14)
    r = states[:, :8].reshape(8, 4, 2)
    lengths = np.linalg.norm(r[:, :, None] - r[:, None], axis=-1)
    assert lengths == pytest.approx(np.broadcast_to(lengths[0], lengths.shape), abs=1e-13)
    for name in ("momentum", "angular_momentum"):
        expected = truss.INVARIANTS[name](start, **truss.EXAMPLE)
        for state in states:
            assert truss.INVARIANTS[name](state, **truss.EXAMPLE) == pytest.approx(expected, abs=1e-12)
    h = 1e-6
    after, before = truss.rigid([2.0, 5.0 + h, 5.0 - h], start, **truss.EXAMPLE)[1:]
    between = truss.rigid([2.0, 5.0], start, **truss.EXAMPLE)[1, 8:]
    assert between == pytest.approx(((after - before) / (2 * h))[:8], abs=1e-8)


@pytest.mark.parametrize("locked", ["front", "rear", "both"])
def test_all_ways_to_stop_agree_and_balance(locked):
    for _ in range(20):
        height, front, rear = DRAW.uniform(0.2, 1.5, 3)
        friction = DRAW.uniform(0, 0.99) * front / height
        car = {"height": height, "front": front, "rear": rear, "friction": friction, "gravity": 9.81, "locked": locked}
        d, front_load, rear_load = result = WAYS[0](**car)
        assert all(way(**car) == pytest.approx(result, rel=1e-9, abs=1e-11) for way in WAYS[1:])
        sliding = {"front": front_load, "rear": rear_load, "both": 9.81}[locked]
        assert d == pytest.approx(friction * sliding, rel=1e-9) and front_load + rear_load == pytest.approx(9.81)
        assert front * front_load - rear * rear_load == pytest.approx(height * d, abs=1e-9)


@pytest.mark.parametrize("way", WAYS)
def test_the_axle_that_lifts_is_named(way):
    car = {"height": 1.0, "front": 0.5, "rear": 0.7, "gravity": 9.81}
    for locked in ("front", "both"):
        for friction in (0.6, 1.2, 1.5):
            with pytest.raises(ValueError, match="rear axle lifts"):
                way(**car, friction=friction, locked=locked)
        assert way(**car, friction=0.5, locked=locked)[2] == pytest.approx(0.0, abs=1e-12)
    assert min(way(**car, friction=1.5, locked="rear")) > 0
    flat = way(**{**car, "height": 0.0}, friction=0.8, locked="front")
    assert flat == pytest.approx((0.8 * 9.81 * 0.7 / 1.2, 9.81 * 0.7 / 1.2, 9.81 * 0.5 / 1.2))


def test_the_hinge_moves_the_centre_of_mass():
    """F + weight = m a, with the acceleration of G from differences along the solved motion."""
    h = 1e-4
    for th, om in DRAW.normal(size=(5, 2)) * 2:
        states = solve(swinging_bar.rates, [0, h, 2 * h], [th, om], parameters=BAR, rtol=1e-14)
        before, now, after = 0.65 * np.column_stack([np.sin(states[:, 0]), -np.cos(states[:, 0])])
        acceleration = (after - 2 * now + before) / h**2
        along, across = swinging_bar.hinge_force(states[1], **BAR)
        c, s = math.cos(states[1, 0]), math.sin(states[1, 0])
        force = along * np.array([-s, c]) + across * np.array([c, s])
        assert force + [0, -0.7 * 9.81] == pytest.approx(0.7 * acceleration, abs=1e-4)


@pytest.mark.parametrize("th", [1e-6, 0.5, -2.0, 3.1, 3.14159265, 7.0, -9.0, 0.0])
def test_the_bar_comes_back_after_four_complete_integrals(th):
    turned = th - 2 * math.pi * round(th / (2 * math.pi))
    w = math.sqrt(1.5 * 9.81 / 1.3)
    T = 4 * ellipkm1(math.cos(turned / 2) ** 2) / w
    quarter, period = swinging_bar.exact([0.0, T / 4, T], [th, 0.0], **BAR)[1:]
    sensitive = 1e-12 / math.cos(turned / 2)
    assert quarter[0] - (th - turned) == pytest.approx(0.0, abs=sensitive)
    assert quarter[1] == pytest.approx(-2 * w * math.sin(turned / 2), abs=1e-11)
    assert period == pytest.approx([th, 0.0], abs=1e2 * sensitive)


@pytest.mark.parametrize("offset", [0.4, -0.4, 1e-3, 0.0, 3.0])
@pytest.mark.parametrize("motion", [(-1.0, 0.03), (1.2, -2.0), (0.0, 0.7), (0.8, 0.0), (-1.0, 1e-9)])
def test_the_exact_sleigh_is_the_solved_one(offset, motion):
    parameters, t = {**BODY, "offset": offset}, 1.0 + np.linspace(0, 9, 7)
    start = (0.3, -0.2, 0.5, *motion)
    solved = solve(sleigh.rates, t, start, parameters=parameters, rtol=1e-13)
    assert sleigh.exact(t, start, **parameters) == pytest.approx(solved, abs=2e-7 if motion[1] == 1e-9 else 1e-9)


@pytest.mark.parametrize("speed", [-0.8, 0.8])
def test_small_yaw_rates_grow_at_the_rate_that_is_said(speed):
    T = 2.0
    states = solve(sleigh.rates, [0, T], [0.0, 0.0, 0.0, speed, 1e-7], parameters=BODY, rtol=1e-13)
    grown = math.log(states[1, 4] / 1e-7) / T
    assert grown == pytest.approx(sleigh.straight_growth_rate(speed, **BODY), rel=1e-6)


def test_newton_and_lagrange_agree_on_the_string():
    for _ in range(10):
        state = [*DRAW.uniform(0.2, 3, 1), *DRAW.normal(size=3)]
        parameters = {"masses": DRAW.uniform(0.1, 5, 2), "gravity": 9.81}
        accelerations, tension = string.by_newton(state, **parameters)
        assert accelerations == pytest.approx(string.by_lagrange(state, **parameters), rel=1e-12, abs=1e-12)
        # Newton's law of the lower mass: m2 r'' = T - m2 g
        assert tension == pytest.approx(parameters["masses"][1] * (accelerations[0] + 9.81), rel=1e-12)


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
    assert top.steady_precession(2.5, 0.0, **TOP)[0] == pytest.approx(-top.steady_precession(2.5, 0.0, **TOP)[1])


@pytest.mark.parametrize("share", [0.97, 1.03])
def test_a_top_sleeps_as_its_motion_does(share):
    """A top that is nearly upright keeps its tilt small for 3 s if and only if its spin is large enough."""
    spin = share * math.sqrt(4 * TOP["transverse"] * WEIGHT) / TOP["axial"]
    start = (0.0, 1e-4, 0.0, spin * TOP["axial"] / (2 * TOP["transverse"]), 0.0, 0.0)
    start = (*start[:5], spin - start[3])
    tilts = solve(top.rates, np.linspace(0.0, 3.0, 100), start, parameters=TOP)[:, 1]
    assert top.sleeps(spin, **TOP) == (tilts.max() < 1e-3) == (share > 1)


@pytest.mark.parametrize("shape", ["bowl", "saddle", "plane"])
def test_the_force_of_the_surface_does_no_virtual_work(shape):
    """The force has no component along either tangent; with the weight it gives F = m a of the motion in space."""
    parameters = {"mass": 1.7, "gravity": 9.81, "surface": shape, "curvature": 0.8}
    sx, sy = {"bowl": (0.8, 0.8), "saddle": (0.8, -0.8), "plane": (0, 0)}[shape]
    for x, y, u, v in DRAW.normal(size=(5, 4)):
        force = surface.constraint_force([x, y, u, v], **parameters)
        assert [force @ [1, 0, sx * x], force @ [0, 1, sy * y]] == pytest.approx([0, 0], abs=1e-12)
        _, _, ax, ay = surface.rates(0.0, [x, y, u, v], **parameters)
        az = sx * (u * u + x * ax) + sy * (v * v + y * ay)
        assert force - [0, 0, 1.7 * 9.81] == pytest.approx(1.7 * np.array([ax, ay, az]), abs=1e-11)
