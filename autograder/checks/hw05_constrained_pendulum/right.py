"""What is right in hw05: acceleration and constraint force from one linear system, motions from elliptic functions."""

import math

import numpy as np
from scipy.special import ellipj, ellipkinc


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


def angles(state, length):
    """Angle from straight down, and its rate."""
    x, y, vx, vy = state
    return math.atan2(x, -y), (x * vy - y * vx) / length**2


def simulate(t, state, mass, length, gravity):
    """(n, 4) states at the times t, by Jacobi's functions; above modulus one it goes round."""
    if not np.any(state[2:]) and state[0] == 0:
        return np.tile(state, (len(t), 1))
    angle, rate = angles(state, length)
    states = swung(t - t[0], angle, rate, length, gravity)
    states[0] = state
    return states


def swung(t, theta, omega, length, gravity):
    if gravity == 0:
        return on_circle(theta + omega * t, np.full(len(t), omega), length)
    k, half = math.sqrt(gravity / length), theta / 2
    m = math.sin(half) ** 2 + (omega / (2 * k)) ** 2
    if m < 1:
        since = ellipkinc(math.atan2(math.sin(half), omega / (2 * k)), m)
        sn, cn, _, _ = ellipj(since + k * t, m)
        return on_circle(2 * np.arcsin(math.sqrt(m) * sn), 2 * k * math.sqrt(m) * cn, length)
    spin = math.copysign(k * math.sqrt(m), omega)
    _, _, dn, phase = ellipj(ellipkinc(half, 1 / m) + spin * t, 1 / m)
    return on_circle(2 * phase, 2 * spin * dn, length)


def energies(rows, mass, length, gravity):
    """Energy along a motion, over m g l, or m l^2/s^2 without gravity."""
    return (np.sum(rows[:, 2:] ** 2, axis=1) / 2 + gravity * rows[:, 1]) / ((gravity or 1.0) * length)
