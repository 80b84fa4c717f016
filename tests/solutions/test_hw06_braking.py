"""hw06's reference solution, by other routes: Jourdain's principle at 50 digits, work and energy, closed forms."""

import math

import mpmath
import numpy as np
import pytest
from cars import DIGITS, LOCKED, body, car, free_and_dragging, hw, motion, only, usual, velocity, wheelbase


@LOCKED
def test_the_loads_balance_the_weight_and_its_moment(locked):
    for _ in range(50):
        c = car()
        here, there = (
            hw.axle_load(which, **only(c, "mass", "front", "rear", "gravity")) for which in ("front", "rear")
        )
        weight = c["mass"] * c["gravity"]
        assert here + there == pytest.approx(weight, rel=DIGITS)
        assert abs(here * c["front"] - there * c["rear"]) <= DIGITS * weight * wheelbase(c)


@LOCKED
def test_friction_is_against_the_velocity_of_the_locked_axle_and_has_its_size(locked):
    for _ in range(50):
        c = car()
        state = motion(c)
        load = hw.axle_load(locked, **only(c, "mass", "front", "rear", "gravity"))
        force = hw.friction_force(state, locked, **only(c, "mass", "front", "rear", "friction", "gravity"))
        sliding = velocity(free_and_dragging(locked, c)[1], state, locked, c)
        assert np.hypot(*force) == pytest.approx(c["friction"] * load, rel=DIGITS)
        assert force @ sliding == pytest.approx(-np.hypot(*force) * np.hypot(*sliding), rel=DIGITS)


def jourdain(rates, state, locked, car):
    """Residuals of the principle of virtual power at 50 digits, for the two motions that the free axle allows.

    G's acceleration is the derivative of its velocity along a motion with these rates; no axes turn, no side force
    occurs. Returns the residuals of a virtual speed and of a virtual yaw rate, and the sizes of their terms.
    """
    m, inertia = mpmath.mpf(car["mass"]), mpmath.mpf(car["yaw_inertia"])
    free, dragging = (mpmath.mpf(x) for x in free_and_dragging(locked, car))
    heading, u, r = (mpmath.mpf(float(x)) for x in state[2:])
    du, dr = (mpmath.mpf(float(x)) for x in rates[3:])

    def of_G(t):
        return (u + du * t - 1j * free * (r + dr * t)) * mpmath.expj(heading + r * t + dr * t * t / 2)

    acceleration = mpmath.diff(of_G, 0) / mpmath.expj(heading)
    arm = dragging - free
    sliding = u + 1j * arm * r
    load = m * mpmath.mpf(car["gravity"]) * abs(free) / abs(arm)
    force = -mpmath.mpf(car["friction"]) * load * sliding / abs(sliding) if sliding else mpmath.mpc(0)
    along = m * acceleration.real - force.real
    about = -free * m * acceleration.imag + inertia * dr - arm * force.imag
    size = m * (abs(du) + abs(free) * r * r) + abs(force)
    turning = abs(arm * force) + m * abs(free * u * r) + abs(inertia * dr)
    return along, about, size, turning


@LOCKED
@pytest.mark.parametrize("fixed", [{}, {"friction": 0.0}, {"gravity": 0.0}])
def test_the_rates_satisfy_jourdains_principle(locked, fixed):
    with mpmath.workdps(50):
        for _ in range(40):
            c = car(**fixed)
            state = motion(c)
            rates = hw.state_derivative(0.0, state, locked, **c)
            along, about, size, turning = jourdain(rates, state, locked, c)
            assert abs(along) <= DIGITS * size
            assert abs(about) <= DIGITS * turning


@LOCKED
def test_the_free_axle_does_not_slip_sideways_and_goes_at_the_speed(locked):
    for _ in range(50):
        c = car()
        state = motion(c)
        rates = hw.state_derivative(0.0, state, locked, **c)
        along = np.array([math.cos(state[2]), math.sin(state[2])])
        across = np.array([-along[1], along[0]])
        of_free = rates[:2] + free_and_dragging(locked, c)[0] * state[4] * across
        scale = np.abs(rates[:2]).max() + wheelbase(c) * abs(state[4])
        assert abs(of_free @ across) <= DIGITS * scale
        assert abs(of_free @ along - state[3]) <= DIGITS * scale


@LOCKED
def test_kinetic_energy_changes_by_the_power_of_friction(locked):
    """The energy is quadratic in speed and yaw rate, so that a central difference of any step is exact."""
    for _ in range(50):
        c = car()
        state = motion(c)
        rates = hw.state_derivative(0.0, state, locked, **c)
        step = 0.1 * usual(c) / np.abs(rates[3:] * [1, wheelbase(c)]).max()
        after, before = (hw.kinetic_energy(state + h * rates, locked, **body(c)) for h in (step, -step))
        force = hw.friction_force(state, locked, **only(c, "mass", "front", "rear", "friction", "gravity"))
        power = force @ velocity(free_and_dragging(locked, c)[1], state, locked, c)
        assert abs((after - before) / (2 * step) - power) <= DIGITS * (after + before) / step


@LOCKED
def test_at_rest_nothing_acts_and_nothing_changes(locked):
    c = car()
    rest = motion(c, 0.0, 0.0)
    force = hw.friction_force(rest, locked, **only(c, "mass", "front", "rear", "friction", "gravity"))
    assert not force.any()
    assert not hw.state_derivative(0.0, rest, locked, **c).any()
    np.testing.assert_array_equal(hw.simulate(np.array([3.0, 4.0, 9.0]), rest, locked, **c), [rest] * 3)


@LOCKED
def test_the_smallest_motion_has_the_full_friction(locked):
    c = car()
    tiny = np.array([0.0, 0.0, 0.0, -1e-150, 0.0])
    force = hw.friction_force(tiny, locked, **only(c, "mass", "front", "rear", "friction", "gravity"))
    load = hw.axle_load(locked, **only(c, "mass", "front", "rear", "gravity"))
    np.testing.assert_allclose(force, [c["friction"] * load, 0.0], rtol=DIGITS)


def test_other_axles_are_refused():
    c = car()
    state, t = motion(c), np.array([0.0, 1.0])
    calls = [
        lambda w: hw.axle_load(w, **only(c, "mass", "front", "rear", "gravity")),
        lambda w: hw.friction_force(state, w, **only(c, "mass", "front", "rear", "friction", "gravity")),
        lambda w: hw.state_derivative(0.0, state, w, **c),
        lambda w: hw.simulate(t, state, w, **c),
        lambda w: hw.kinetic_energy(state, w, **body(c)),
        lambda w: hw.yaw_growth_rate(1.0, w, **c),
        lambda w: hw.critical_speed(w, **only(c, "front", "rear", "friction", "gravity")),
        lambda w: hw.small_yaw_rate(1.0, 2.0, 0.1, w, **c),
    ]
    for call in calls:
        for wrong in ("both", "Front", "", None):
            with pytest.raises(ValueError):
                call(wrong)
