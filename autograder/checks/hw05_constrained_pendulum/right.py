"""What is right in hw05: acceleration and constraint force from one linear system, motions from the angle."""

import math

import numpy as np
from scipy.integrate import odeint


def on_circle(theta, omega, length):
    """The state (..., 4) at an angle from straight down."""
    s, c, speed = np.sin(theta), np.cos(theta), length * np.asarray(omega)
    return np.stack([length * s, -length * c, speed * c, speed * s], axis=-1)


def together(state, mass, length, gravity):
    """Acceleration and constraint force: m a - N r = (0, -m g), r . a = -v . v."""
    r, v = state[:2], state[2:]
    matrix = np.block([[mass * np.eye(2), -r[:, None]], [r, np.zeros(1)]])
    *a, pull = np.linalg.solve(matrix, [0.0, -mass * gravity, -v @ v])
    return np.array(a), pull * r


def acceleration(state, **known):
    return together(state, **known)[0]


def constraint_force(state, **known):
    return together(state, **known)[1]


def consistent_state(state, length):
    """By complex numbers: the place's direction, and the velocity's part across it."""
    place, velocity = complex(*state[:2]), complex(*state[2:])
    outward = place / abs(place)
    across = 1j * outward * (velocity / outward).imag
    return np.array([length * outward.real, length * outward.imag, across.real, across.imag])


def energy(state, mass, gravity):
    weight = np.array([0.0, -mass * gravity])
    return mass * abs(complex(*state[2:])) ** 2 / 2 - weight @ state[:2]


def wireframe(state, length):
    return np.array([[[0.0, 0.0], state[:2]]])


def simulate(t, state, mass, length, gravity):
    """(n, 4) states at the times t, by the angle from straight down."""
    x, y, vx, vy = state
    start = math.atan2(x, -y), (x * vy - y * vx) / length**2

    def rates(_, angle):
        return angle[1], -gravity / length * math.sin(angle[0])

    angles = odeint(rates, start, t, tfirst=True, rtol=1e-12, atol=1e-12, mxstep=100_000)  # good to 4e-9 after 100 s
    states = on_circle(angles[:, 0], angles[:, 1], length)
    states[0] = state
    return states


def energies(rows, mass, length, gravity):
    """Energy along a motion, over m g l, or m l^2/s^2 without gravity."""
    return (np.sum(rows[:, 2:] ** 2, axis=1) / 2 + gravity * rows[:, 1]) / ((gravity or 1.0) * length)
