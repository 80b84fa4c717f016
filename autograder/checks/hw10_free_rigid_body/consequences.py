"""Right functions of hw10 in terms of others, or in other forms; diagnosis tries mistakes in these, too."""

import math

import numpy as np


def euler_rates_313(angles, omega):
    """Solve for the rates: omega is psi' along space z, theta' along the line of nodes, phi' along body z."""
    _, theta, phi = angles
    if abs(math.sin(theta)) < 1e-12:
        raise ValueError
    along_x = [math.sin(theta) * math.sin(phi), math.cos(phi), 0.0]
    along_y = [math.sin(theta) * math.cos(phi), -math.sin(phi), 0.0]
    return np.linalg.solve([along_x, along_y, [math.cos(theta), 0.0, 1.0]], omega)


def growth_rate_squared(axis, spin, *, inertia):
    """Multiply what each deviation adds to the rate of the other; Euler's equations have no higher powers."""
    j, k = (i for i in range(3) if i != axis)
    steady, unit = spin * np.eye(3)[axis], np.eye(3)

    def slope(rate, deviation):
        ends = [np.asarray(euler_equations(steady + sign * unit[deviation], inertia=inertia))[rate] for sign in (-1, 1)]
        return (ends[1] - ends[0]) / 2

    return slope(j, k) * slope(k, j)


def tumble_period(omega, *, inertia):
    """Compute a quarter period: K of the modulus by the arithmetic-geometric mean, over a rate."""
    A, B, C = inertia
    p, q, r = omega
    round_0, round_2 = A * (B - A) * p**2, C * (C - B) * r**2
    if round_0 == round_2:
        return math.inf
    if round_0 > round_2:
        A, C, p, r = C, A, r, p
    along = B * (B - A) * q**2 + C * (C - A) * r**2
    modulus = (B - A) * (A * (C - A) * p**2 + B * (C - B) * q**2) / ((C - B) * along)
    quarter = math.pi / (2 * _agm(1.0, math.sqrt(1 - modulus)))
    return 4 * quarter * math.sqrt(A * B * C / ((C - B) * along))
