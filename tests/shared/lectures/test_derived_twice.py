"""Rates of lectures that no exact motion and no limit tests, derived again from a Lagrangian."""

import numpy as np
import pytest
import sympy

from tam570 import lagrange
from tam570.lectures import load

DRAW = np.random.default_rng(570)
g = 9.81


def symbols(*names):
    return sympy.symbols(" ".join(names), real=True)


def quadratic_drag():
    (x, y, p, q), m, c = symbols("x", "y", "p", "q"), 0.7, 0.3
    speed = sympy.sqrt(p**2 + q**2)
    drag = [-c * speed * p, -c * speed * q]
    return m * speed**2 / 2 - m * g * y, [x, y], [p, q], {"mass": m, "drag": c, "gravity": g}, {"forces": drag}


def bodies():
    n, masses, newton = 3, (0.5, 1.5, 2.5), 0.8
    q, v = symbols(*(f"q{i}" for i in range(3 * n))), symbols(*(f"v{i}" for i in range(3 * n)))
    L = sum(masses[i // 3] * v[i] ** 2 for i in range(3 * n)) / 2
    for i, j in ((1, 0), (2, 0), (2, 1)):
        square = sum((q[3 * i + k] - q[3 * j + k]) ** 2 for k in range(3))
        L += newton * masses[i] * masses[j] / sympy.sqrt(square)
    return L, q, v, {"masses": masses, "newton": newton}


def convergence():
    """Return the Lagrangian system of two particles on massless rods."""
    (a, b), (p, q), (m1, m2), (r1, r2) = symbols("a", "b"), symbols("p", "q"), (0.7, 1.9), (1.3, 0.8)
    v1, v2 = r1 * p, r2 * q
    T = (m1 * v1**2 + m2 * (v1**2 + v2**2 + 2 * v1 * v2 * sympy.cos(a - b))) / 2
    V = -g * ((m1 + m2) * r1 * sympy.cos(a) + m2 * r2 * sympy.cos(b))
    return T - V, [a, b], [p, q], {"masses": (m1, m2), "lengths": (r1, r2), "gravity": g}


@pytest.mark.parametrize("system", [quadratic_drag, bodies, convergence])
def test_rates_are_those_of_a_lagrangian(system):
    L, q, v, parameters, *options = system()
    equations = lagrange.load(lagrange.source(L, q, v, **dict(*options)))
    for state in DRAW.normal(size=(5, 2 * len(q))).tolist():
        rates = load(system.__name__).rates(0.0, state, **parameters)
        assert rates == pytest.approx(equations.rhs(0.0, state), rel=1e-11, abs=1e-11)
