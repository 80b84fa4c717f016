"""Laws of the lectures on constraints: rods, trusses, a car, a bar, a sleigh."""

import math

import numpy as np
import pytest
from scipy.special import ellipkm1

from tam570.integrate import solve
from tam570.invariants import observed_order
from tam570.lectures import rod, sleigh, stopping_car, swinging_bar, truss

DRAW = np.random.default_rng(914)


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
    for law in ("momentum", "angular_momentum"):
        expected = truss.INVARIANTS[law](start, **truss.EXAMPLE)
        for state in states:
            assert truss.INVARIANTS[law](state, **truss.EXAMPLE) == pytest.approx(expected, abs=1e-12)
    h = 1e-6
    after, before = truss.rigid([2.0, 5.0 + h, 5.0 - h], start, **truss.EXAMPLE)[1:]
    between = truss.rigid([2.0, 5.0], start, **truss.EXAMPLE)[1, 8:]
    assert between == pytest.approx(((after - before) / (2 * h))[:8], abs=1e-8)


WAYS = [stopping_car.by_centre_of_mass, stopping_car.by_three_points, stopping_car.by_one_point]


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


BAR = {"mass": 0.7, "length": 1.3, "gravity": 9.81}


def test_the_hinge_moves_the_centre_of_mass():
    """F + weight = m a of G, its acceleration by differences along the solved motion."""
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


BODY = {"mass": 0.7, "inertia": 0.2, "offset": 0.4}


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
