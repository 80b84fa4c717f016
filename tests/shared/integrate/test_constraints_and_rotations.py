"""Constraints that hold after every step, and rotations that stay rotations."""

import math

import numpy as np
import pytest
from systems import PENDULUM, pendulum

from tam570.integrate import solve, solve_rotation
from tam570.invariants import rotation_defect, violation

EPS = 2.0**-52


def test_projection_keeps_a_constraint_and_leaves_the_motion_right():
    def particle(t, state):
        x, y, u, v = state
        pull = (u * u + v * v - 9.81 * y) / (x * x + y * y)
        return u, v, -pull * x, -9.81 - pull * y

    def on_the_circle(state):
        x, y, u, v = state
        r = math.hypot(x, y)
        along = (x * v - y * u) / r
        return x / r, y / r, -along * y / r, along * x / r

    t = np.linspace(0, 100, 201)
    states = solve(particle, t, [1.0, 0.0, 0.0, 0.0], project=on_the_circle, rtol=1e-12)
    assert violation(lambda s: s[0] ** 2 + s[1] ** 2 - 1, states).max() < 10 * EPS
    assert violation(lambda s: s[0] * s[2] + s[1] * s[3], states).max() < 1e-14
    angle = solve(pendulum, t, [math.pi / 2, 0.0], parameters=PENDULUM, rtol=1e-12)[:, 0]
    assert states[:, 0] == pytest.approx(np.sin(angle), abs=1e-7)  # 2000 steps of 1e-12; the phase adds them up
    free = solve(particle, t, [1.0, 0.0, 0.0, 0.0])
    assert violation(lambda s: s[0] ** 2 + s[1] ** 2 - 1, free).max() > 1e-9  # what would happen without


def euler(t, omega, *, inertia):
    A, B, C = inertia
    p, q, r = omega
    return (B - C) / A * q * r, (C - A) / B * r * p, (A - B) / C * p * q


def test_rotations_stay_rotations_and_angular_momentum_stays():
    inertia = np.array([1.0, 2.0, 3.0])
    t = np.linspace(0, 200, 101)
    omegas, R = solve_rotation(euler, t, [0.1, 1.0, 0.2], np.eye(3), parameters={"inertia": tuple(inertia)}, rtol=1e-12)
    assert rotation_defect(R).max() < 1e-14
    momentum = np.einsum("nij,nj->ni", R, inertia * omegas)
    assert np.abs(momentum - momentum[0]).max() < 1e-9


def test_constant_spin_is_exact():
    spin = np.array([0.3, -0.4, 1.2])
    _, R = solve_rotation(lambda t, w: (0.0, 0.0, 0.0), [0, 1.0, 50.0], spin, np.eye(3), rtol=1e-12)
    angle = np.linalg.norm(spin) * 50
    n = spin / np.linalg.norm(spin)
    hat = np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    assert R[-1] == pytest.approx(np.eye(3) + math.sin(angle) * hat + (1 - math.cos(angle)) * hat @ hat, abs=1e-11)
