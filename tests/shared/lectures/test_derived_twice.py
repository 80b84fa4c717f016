"""The equations of motion by another route: from a Lagrangian, its constraints and forces, at random states."""

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


def oscillator():
    q, v, m = symbols("x", "y", "z"), symbols("u", "v", "w"), 0.7
    return sum(m * b**2 / 2 - k * a**2 / 2 for a, b in zip(q, v, strict=True)), q, v, {"mass": m, "stiffness": k}


def planet():
    q, v, gm = symbols("x", "y", "z"), symbols("u", "v", "w"), 2.3
    return sum(a**2 for a in v) / 2 + gm / sympy.sqrt(sum(a**2 for a in q)), q, v, {"gm": gm}


def bodies():
    n, masses, newton = 3, (0.5, 1.5, 2.5), 0.8
    q, v = symbols(*(f"q{i}" for i in range(3 * n))), symbols(*(f"v{i}" for i in range(3 * n)))
    L = sum(masses[i // 3] * v[i] ** 2 for i in range(3 * n)) / 2
    for i, j in ((1, 0), (2, 0), (2, 1)):
        square = sum((q[3 * i + k] - q[3 * j + k]) ** 2 for k in range(3))
        L += newton * masses[i] * masses[j] / sympy.sqrt(square)
    return L, q, v, {"masses": masses, "newton": newton}


def two_masses():
    (x, y), (u, v), m, d = symbols("x", "y"), symbols("u", "v"), (0.5, 2.0), 1.2
    L = (m[0] * u**2 + m[1] * v**2) / 2 - k * (y - x - d) ** 2 / 2
    return L, [x, y], [u, v], {"masses": m, "stiffness": k, "rest_length": d}


def truss():
    masses, bars, lengths = (0.5, 1.0, 2.0), ((0, 1), (1, 2), (2, 0)), (1.0, 1.5, 0.7)
    q, v = symbols(*(f"q{i}" for i in range(6))), symbols(*(f"v{i}" for i in range(6)))
    L = sum(masses[i // 2] * v[i] ** 2 for i in range(6)) / 2
    for (i, j), rest in zip(bars, lengths, strict=True):
        length = sympy.sqrt((q[2 * i] - q[2 * j]) ** 2 + (q[2 * i + 1] - q[2 * j + 1]) ** 2)
        L -= k * (length - rest) ** 2 / 2
    return L, q, v, {"masses": masses, "bars": bars, "lengths": lengths, "stiffness": k}


def swinging_bar():
    """The bar is the sum of its parts: the Lagrangian is integrated along it."""
    th, om, s, m, length = *symbols("th", "om", "s"), 0.7, 1.3
    L = sympy.integrate(m / length * (s**2 * om**2 / 2 + g * s * sympy.cos(th)), (s, 0, length))
    return L, [th], [om], {"mass": m, "length": length, "gravity": g}


def string():
    """The Lagrangian in Cartesian coordinates of both particles, with r put in by SymPy."""
    r, th, u, w, m = *symbols("r", "th", "u", "w"), (0.7, 1.9)
    x, y = r * sympy.cos(th), r * sympy.sin(th)
    square = sum((a.diff(r) * u + a.diff(th) * w) ** 2 for a in (x, y))
    L = sympy.simplify(m[0] * square / 2) + m[1] * u**2 / 2 - m[1] * g * r
    return L, [r, th], [u, w], {"masses": m, "gravity": g}, {"around": [6.0, 0, 0, 0]}


def surface(shape, signs):
    x, y, u, v, m, c = *symbols("x", "y", "u", "v"), 1.7, 0.8
    h = c * (signs[0] * x**2 + signs[1] * y**2) / 2
    L = m * (u**2 + v**2 + (sympy.diff(h, x) * u + sympy.diff(h, y) * v) ** 2) / 2 - m * g * h
    return L, [x, y], [u, v], {"mass": m, "gravity": g, "surface": shape, "curvature": c}


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


SYSTEMS = [
    *((each, ()) for each in (quadratic_drag, oscillator, planet, bodies, two_masses, truss, swinging_bar, string)),
    *((surface, case) for case in (("bowl", (1, 1)), ("saddle", (1, -1)), ("plane", (0, 0)))),
    pytest.param(top, (), marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("system", "case"), SYSTEMS)
def test_rates_are_those_of_a_lagrangian(system, case):
    L, q, v, parameters, *more = system(*case)
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
