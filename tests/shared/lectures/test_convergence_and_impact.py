"""Laws of the lectures on convergence and on collisions as stiff springs."""

import math

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.lectures import convergence, stiff_impact
from tam570.lectures.collisions import collide

STEPS = [0.01, 0.005, 0.0025]  # s
ROD = {"mass": 1.3, "inertia": 0.2, "arms": (-0.5, 0.3), "speed": 0.8}


@pytest.mark.parametrize(("method", "expected"), [("Euler", 1), ("Heun", 2), ("RK4", 4)])
def test_methods_converge_with_their_order_by_both_equations(method, expected):
    assert convergence.order(method, STEPS) == pytest.approx((expected, expected), abs=0.1)
    by_rates, wrong = convergence.errors(method, STEPS)
    assert by_rates.shape == wrong.shape == (3,) and (np.diff(by_rates) < 0).all() and (np.diff(wrong) < 0).all()


def test_the_rebound_is_that_of_the_solved_motion():
    for stiffness, gravity in ((50.0, 9.81), (3000.0, 9.81), (40.0, 0.0)):
        expected = {"mass": 0.7, "stiffness": stiffness, "gravity": gravity}
        impulse, duration = stiff_impact.rebound(stiffness, mass=0.7, speed=1.5, gravity=gravity)
        times = np.linspace(0.0, duration, 2001)
        states = solve(stiff_impact.rates, times, [0.0, -1.5], parameters=expected, rtol=1e-12)
        assert states[-1] == pytest.approx([0.0, 1.5], abs=1e-9) and (states[1:-1, 0] < 0).all()
        pushes = [stiff_impact.push(state, **expected) for state in states]
        assert impulse == pytest.approx(np.trapezoid(pushes, times), rel=1e-5)


def test_a_stiff_spring_is_a_collision_in_the_limit():
    stiffnesses = 1e5 * 100.0 ** np.arange(5)
    rebounds = [stiff_impact.rebound(k, mass=2.0, speed=3.0, gravity=9.81) for k in stiffnesses]
    impulses, durations = np.transpose(rebounds)
    assert durations[:-1] / durations[1:] == pytest.approx(np.full(4, 10.0), rel=0.05)
    assert durations * np.sqrt(stiffnesses / 2.0) == pytest.approx(np.full(5, math.pi), rel=0.02)
    excess = impulses - 2 * 2.0 * 3.0
    assert (excess > 0).all() and (np.diff(excess) < 0).all() and excess[-1] < 1e-3


def test_two_contacts_keep_the_balances_and_the_energy():
    for ratio in (0.02, 1.0, 7.0):
        (up, turning), (first, second) = stiff_impact.two_contacts((ratio, 1.0), **ROD)
        a, b = ROD["arms"]
        assert ROD["mass"] * (up + ROD["speed"]) == pytest.approx(first + second)
        assert ROD["inertia"] * turning == pytest.approx(a * first + b * second)
        kinetic = (ROD["mass"] * up**2 + ROD["inertia"] * turning**2) / 2
        assert kinetic == pytest.approx(ROD["mass"] * ROD["speed"] ** 2 / 2, rel=1e-8)


def test_only_the_ratio_of_the_stiffnesses_matters_and_it_does():
    soft, stiff = (stiff_impact.two_contacts((k, 3 * k), **ROD)[0] for k in (1.0, 1e8))
    assert soft == pytest.approx(stiff, rel=1e-9)
    assert np.abs(stiff_impact.two_contacts((20.0, 1.0), **ROD)[0] - stiff).max() > 0.05
    even = stiff_impact.two_contacts((5.0, 5.0), **{**ROD, "arms": (-0.4, 0.4)})[0]
    assert even == pytest.approx([ROD["speed"], 0.0], abs=1e-9)


def test_a_much_stiffer_contact_collides_first():
    """In the limit the rod hits one contact, then the other, as rigid bodies do, until it leaves both."""
    (up, turning), _ = stiff_impact.two_contacts((1e6, 1.0), **ROD)
    rod, arms = np.array([[0.0, -ROD["speed"], 0.0], [0.0, 0.0, 0.0]]), ROD["arms"]
    bodies = {"masses": (ROD["mass"], math.inf), "inertias": (ROD["inertia"], math.inf), "restitution": 1.0}
    which = 0
    while any(rod[0, 1] + arm * rod[0, 2] < -1e-12 for arm in arms):
        if rod[0, 1] + arms[which] * rod[0, 2] < 0:
            rod, _ = collide(rod, [0.0, -1.0], [[arms[which], 0.0], [0.0, 0.0]], **bodies)
        which = 1 - which
    assert [up, turning] == pytest.approx(rod[0, 1:], abs=5e-3)
