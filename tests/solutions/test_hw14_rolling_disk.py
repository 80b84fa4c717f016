"""hw14's solution: three derivations."""

import math

import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw14_rolling_disk")

# Disk, hoop, a general wheel and a long roller: A and C in units of m a^2.
SHAPES = {"disk": (0.25, 0.5), "hoop": (0.5, 1.0), "wheel": (0.61, 0.87), "roller": (4.0, 0.5)}
TINY = 1e-30  # complex step: its square vanishes beside 1


def disk_of(shape, mass=1.7, radius=0.45, gravity=9.81):
    inertia = tuple(k * mass * radius**2 for k in SHAPES[shape])
    return {"mass": mass, "radius": radius, "gravity": gravity, "inertia": inertia}


def states(seed, count, tilts=(0.1, 3.0), rates=5.0):
    """Random Euler states; rates in rad/s."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        position, angles = rng.uniform(-3, 3, 2), rng.uniform(-5, 5, 2)
        yield np.array([*position, angles[0], rng.uniform(*tilts), angles[1], *rng.normal(0, rates, 3)])


def frame(state):
    """e1, e2, e3 of a state that may be complex."""
    yaw, tilt = state[2:4]
    c, s = np.cos(tilt), np.sin(tilt)
    e1 = np.array([np.cos(yaw), np.sin(yaw), 0])
    e3 = np.array([np.sin(yaw) * s, -np.cos(yaw) * s, c])
    return e1, np.array([-np.sin(yaw) * c, np.cos(yaw) * c, s]), e3


def omega(state):
    e1, _, e3 = frame(state)
    return state[5] * np.array([0, 0, 1]) + state[6] * e1 + state[7] * e3


def along_the_motion(function, state, disk):
    """d/dt of a function of the Euler state by a complex step along the equations: exact to rounding."""
    rates = np.array(hw.euler_state_derivative(0.0, state, **disk))
    return np.imag(function(state + 1j * TINY * rates)) / TINY


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("mass, radius, gravity", [(1.7, 0.45, 9.81), (1e-6, 1e3, 1.6), (1e6, 1e-3, 0.0)])
def test_three_derivations_agree_pointwise(shape, mass, radius, gravity):
    disk = disk_of(shape, mass, radius, gravity)
    for state in states(3, 100, (0.02, 3.12), rates=3 * math.sqrt(9.81 / radius)):
        placed = hw.matrix_state(state, radius=radius)
        matrix = np.array(hw.matrix_state_derivative(0.0, placed, **disk))
        multiplier = hw.multiplier_state_derivative(0.0, placed, **disk)
        scale = np.repeat([np.abs(matrix[part]).max() for part in (np.s_[:3], np.s_[3:12], np.s_[12:])], [3, 9, 3])
        np.testing.assert_allclose(multiplier / scale, matrix / scale, rtol=0, atol=1e-11)
        omega_rate = along_the_motion(omega, state, disk)
        np.testing.assert_allclose(omega_rate / scale[-1], matrix[12:] / scale[-1], rtol=0, atol=1e-11)
