"""The equations of motion by another route: from a Lagrangian, its constraints and forces, at random states."""

import numpy as np
import pytest
import sympy

from tam570 import lagrange
from tam570.lectures import load

DRAW = np.random.default_rng(570)


def symbols(*names):
    return sympy.symbols(" ".join(names), real=True)


def compared(name, states, parameters, other):
    """Rates of a lecture at random states beside other ones."""
    for state in states:
        found = load(name).rates(0.0, state.tolist(), **parameters)
        assert found == pytest.approx(other(state), rel=1e-11, abs=1e-11)


def by_lagrange(name, L, q, v, parameters, others, around=0.0, **options):
    """Compare with the equations of a Lagrangian; `others` are its parameters, states are drawn around a state."""
    equations = lagrange.load(lagrange.source(L, q, v, **options))
    states = around + DRAW.normal(size=(5, 2 * len(q)))
    compared(name, states, parameters, lambda state: equations.rhs(0.0, state.tolist(), **others))


def test_quadratic_drag():
    x, y, p, q, m, c, g = symbols("x", "y", "p", "q", "m", "c", "g")
    speed = sympy.sqrt(p**2 + q**2)
    L = m * speed**2 / 2 - m * g * y
    known = {"mass": 0.7, "drag": 0.3, "gravity": 9.81}
    others = {"m": 0.7, "c": 0.3, "g": 9.81}
    by_lagrange("quadratic_drag", L, [x, y], [p, q], known, others, forces=[-c * speed * p, -c * speed * q])


def test_oscillator():
    q, v, (m, k) = symbols("x", "y", "z"), symbols("u", "v", "w"), symbols("m", "k")
    L = m * sum(a**2 for a in v) / 2 - k * sum(a**2 for a in q) / 2
    by_lagrange("oscillator", L, q, v, {"mass": 0.7, "stiffness": 5.0}, {"m": 0.7, "k": 5.0})


def test_planet():
    q, v, gm = symbols("x", "y", "z"), symbols("u", "v", "w"), sympy.Symbol("gm", positive=True)
    L = sum(a**2 for a in v) / 2 + gm / sympy.sqrt(sum(a**2 for a in q))
    by_lagrange("planet", L, q, v, {"gm": 2.3}, {"gm": 2.3})


def test_bodies():
    n, masses, newton = 3, (0.5, 1.5, 2.5), 0.8
    q, v = symbols(*(f"q{i}" for i in range(3 * n))), symbols(*(f"v{i}" for i in range(3 * n)))
    L = sum(masses[i // 3] * v[i] ** 2 for i in range(3 * n)) / 2
    for i in range(n):
        for j in range(i):
            square = sum((q[3 * i + k] - q[3 * j + k]) ** 2 for k in range(3))
            L += newton * masses[i] * masses[j] / sympy.sqrt(square)
    by_lagrange("bodies", L, q, v, {"masses": masses, "newton": newton}, {})


def test_two_masses():
    (x, y, u, v), (m1, m2, k, d) = symbols("x", "y", "u", "v"), symbols("m1", "m2", "k", "d")
    L = (m1 * u**2 + m2 * v**2) / 2 - k * (y - x - d) ** 2 / 2
    known = {"masses": (0.5, 2.0), "stiffness": 6.0, "rest_length": 1.2}
    by_lagrange("two_masses", L, [x, y], [u, v], known, {"m1": 0.5, "m2": 2.0, "k": 6.0, "d": 1.2})


def test_truss():
    masses, bars, lengths, k = (0.5, 1.0, 2.0), ((0, 1), (1, 2), (2, 0)), (1.0, 1.5, 0.7), 40.0
    q, v = symbols(*(f"q{i}" for i in range(6))), symbols(*(f"v{i}" for i in range(6)))
    L = sum(masses[i // 2] * v[i] ** 2 for i in range(6)) / 2
    for (i, j), rest in zip(bars, lengths, strict=True):
        length = sympy.sqrt((q[2 * i] - q[2 * j]) ** 2 + (q[2 * i + 1] - q[2 * j + 1]) ** 2)
        L -= k * (length - rest) ** 2 / 2
    known = {"masses": masses, "bars": bars, "lengths": lengths, "stiffness": k}
    by_lagrange("truss", L, q, v, known, {})


def test_swinging_bar():
    """The bar is the sum of its parts: the Lagrangian is integrated along it."""
    th, om, m, length, g, s = symbols("th", "om", "m", "length", "g", "s")
    L = sympy.integrate(m / length * (s**2 * om**2 / 2 + g * s * sympy.cos(th)), (s, 0, length))
    known = {"mass": 0.7, "length": 1.3, "gravity": 9.81}
    by_lagrange("swinging_bar", L, [th], [om], known, {"m": 0.7, "length": 1.3, "g": 9.81})


def test_sleigh():
    """With a multiplier for the blade, in the coordinates of the blade."""
    (x, y, h, u, v, w), (m, J, a) = symbols("x", "y", "h", "u", "v", "w"), symbols("m", "J", "a")
    gx, gy = u - a * w * sympy.sin(h), v + a * w * sympy.cos(h)
    slip = v * sympy.cos(h) - u * sympy.sin(h)
    L = m * (gx**2 + gy**2) / 2 + J * w**2 / 2
    equations = lagrange.load(lagrange.source(L, [x, y, h], [u, v, w], constraints=[slip]))

    def other(state):
        px, py, heading, speed, yaw = state.tolist()
        c, s = np.cos(heading), np.sin(heading)
        full = [px, py, heading, speed * c, speed * s, yaw]
        *velocities, ax, ay, turning = equations.rhs(0.0, full, m=0.7, J=0.2, a=0.4)
        return [*velocities, ax * c + ay * s, turning]  # the unit vector ahead turns across itself

    known = {"mass": 0.7, "inertia": 0.2, "offset": 0.4}
    compared("sleigh", DRAW.normal(size=(5, 5)), known, other)


def test_string():
    """The Lagrangian in Cartesian coordinates of both particles, with r put in by SymPy."""
    r, th, u, w, m1, m2, g = symbols("r", "th", "u", "w", "m1", "m2", "g")
    x, y = r * sympy.cos(th), r * sympy.sin(th)
    square = sum((a.diff(r) * u + a.diff(th) * w) ** 2 for a in (x, y))
    L = sympy.simplify(m1 * square / 2) + m2 * u**2 / 2 - m2 * g * r
    known = {"masses": (0.7, 1.9), "gravity": 9.81}
    by_lagrange("string", L, [r, th], [u, w], known, {"m1": 0.7, "m2": 1.9, "g": 9.81}, around=[6.0, 0, 0, 0])


@pytest.mark.parametrize(("surface", "signs"), [("bowl", (1, 1)), ("saddle", (1, -1)), ("plane", (0, 0))])
def test_surface(surface, signs):
    x, y, u, v, m, g, c = symbols("x", "y", "u", "v", "m", "g", "c")
    h = c * (signs[0] * x**2 + signs[1] * y**2) / 2
    L = m * (u**2 + v**2 + (h.diff(x) * u + h.diff(y) * v) ** 2) / 2 - m * g * h
    known = {"mass": 1.7, "gravity": 9.81, "surface": surface, "curvature": 0.8}
    others = {"m": 1.7, "g": 9.81, "c": 0.8} if surface != "plane" else {"m": 1.7}
    by_lagrange("surface", L, [x, y], [u, v], known, others)


@pytest.mark.slow
def test_top():
    """Body components of omega from R^T R', R a product of three matrices."""
    psi, theta, phi, a, b, c, m, d, C, A, g = symbols("psi", "theta", "phi", "a", "b", "c", "m", "d", "C", "A", "g")
    R = sympy.rot_ccw_axis3(psi) * sympy.rot_ccw_axis1(theta) * sympy.rot_ccw_axis3(phi)
    rate = sum((R.diff(q) * v for q, v in zip((psi, theta, phi), (a, b, c), strict=True)), sympy.zeros(3))
    spin = sympy.simplify(R.T * rate)
    w1, w2, w3 = spin[2, 1], spin[0, 2], spin[1, 0]
    L = sympy.simplify((A * (w1**2 + w2**2) + C * w3**2) / 2) - m * g * d * R[2, 2]
    known = {"mass": 0.5, "distance": 0.3, "axial": 0.2, "transverse": 0.5, "gravity": 9.81}
    others = {"m": 0.5, "d": 0.3, "C": 0.2, "A": 0.5, "g": 9.81}
    by_lagrange("top", L, [psi, theta, phi], [a, b, c], known, others, around=[0, 1.6, 0, 0, 0, 0])
