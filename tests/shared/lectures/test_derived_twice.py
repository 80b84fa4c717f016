"""The equations of motion that no exact motion tells, by another route: a Lagrangian, constraints, forces."""

import numpy as np
import pytest
import sympy

from tam570 import lagrange
from tam570.lectures import load

DRAW = np.random.default_rng(570)
g, k = 9.81, 5.0


def symbols(*names):
    return sympy.symbols(" ".join(names), real=True)


def compare(name, states, parameters, by_another_route):
    """Rates of a lecture at random states beside other ones."""
    for state in states:
        rates = load(name).rates(0.0, state.tolist(), **parameters)
        assert rates == pytest.approx(by_another_route(state), rel=1e-11, abs=1e-11)


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


def truss():
    masses, bars, lengths = (0.5, 1.0, 2.0), ((0, 1), (1, 2), (2, 0)), (1.0, 1.5, 0.7)
    q, v = symbols(*(f"q{i}" for i in range(6))), symbols(*(f"v{i}" for i in range(6)))
    L = sum(masses[i // 2] * v[i] ** 2 for i in range(6)) / 2
    for (i, j), rest in zip(bars, lengths, strict=True):
        length = sympy.sqrt((q[2 * i] - q[2 * j]) ** 2 + (q[2 * i + 1] - q[2 * j + 1]) ** 2)
        L -= k * (length - rest) ** 2 / 2
    return L, q, v, {"masses": masses, "bars": bars, "lengths": lengths, "stiffness": k}


def convergence():
    """Two particles on rods without mass."""
    (a, b), (p, q), (m1, m2), (r1, r2) = symbols("a", "b"), symbols("p", "q"), (0.7, 1.9), (1.3, 0.8)
    v1, v2 = r1 * p, r2 * q
    T = (m1 * v1**2 + m2 * (v1**2 + v2**2 + 2 * v1 * v2 * sympy.cos(a - b))) / 2
    V = -g * ((m1 + m2) * r1 * sympy.cos(a) + m2 * r2 * sympy.cos(b))
    return T - V, [a, b], [p, q], {"masses": (m1, m2), "lengths": (r1, r2), "gravity": g}


def top():
    """Body components of omega from R^T R', R a product of three matrices."""
    psi, theta, phi, a, b, c = symbols("psi", "theta", "phi", "a", "b", "c")
    m, d, C, A = 0.5, 0.3, 0.2, 0.5
    R = sympy.rot_ccw_axis3(psi) * sympy.rot_ccw_axis1(theta) * sympy.rot_ccw_axis3(phi)
    rate = sum((R.diff(q) * v for q, v in zip((psi, theta, phi), (a, b, c), strict=True)), sympy.zeros(3))
    spin = sympy.simplify(R.T * rate)
    w1, w2, w3 = spin[2, 1], spin[0, 2], spin[1, 0]
    L = (A * (w1**2 + w2**2) + C * w3**2) / 2 - m * g * d * R[2, 2]
    parameters = {"mass": m, "distance": d, "axial": C, "transverse": A, "gravity": g}
    return L, [psi, theta, phi], [a, b, c], parameters, {"around": [0, 1.6, 0, 0, 0, 0]}


@pytest.mark.parametrize(
    "system", [quadratic_drag, bodies, truss, convergence, pytest.param(top, marks=pytest.mark.slow)]
)
def test_rates_are_those_of_a_lagrangian(system):
    L, q, v, parameters, *more = system()
    options = dict(*more)
    states = options.pop("around", 0.0) + DRAW.normal(size=(5, 2 * len(q)))
    equations = lagrange.load(lagrange.source(L, q, v, **options))
    compare(system.__name__, states, parameters, lambda state: equations.rhs(0.0, state.tolist()))


def test_sleigh():
    """With a multiplier for the blade, in the coordinates of the blade."""
    (x, y, h, u, v, w), (m, J, a) = symbols("x", "y", "h", "u", "v", "w"), symbols("m", "J", "a")
    gx, gy = u - a * w * sympy.sin(h), v + a * w * sympy.cos(h)
    sideways = v * sympy.cos(h) - u * sympy.sin(h)
    L = m * (gx**2 + gy**2) / 2 + J * w**2 / 2
    equations = lagrange.load(lagrange.source(L, [x, y, h], [u, v, w], constraints=[sideways]))

    def other(state):
        px, py, heading, speed, yaw = state.tolist()
        c, s = np.cos(heading), np.sin(heading)
        full = [px, py, heading, speed * c, speed * s, yaw]
        *velocities, ax, ay, turning = equations.rhs(0.0, full, m=0.7, J=0.2, a=0.4)
        return [*velocities, ax * c + ay * s, turning]  # the unit vector ahead turns across itself

    parameters = {"mass": 0.7, "inertia": 0.2, "offset": 0.4}
    compare("sleigh", DRAW.normal(size=(5, 5)), parameters, other)
