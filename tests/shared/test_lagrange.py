"""Lagrange's equations, compared with known accelerations and with identities at random states."""

import subprocess
import sys

import numpy as np
import pytest
import sympy
from sympy import cos, sin, symbols

from tam570 import lagrange

DRAW = np.random.default_rng(572)
t = symbols("t")
x, y, z, theta, phi = symbols("x y z theta phi")
u, v, w, p, q = symbols("u v w p q")
m, g, l, c, I = symbols("m g l c I")  # noqa: E741  as on the blackboard
NUMBERS = {"m": 1.3, "g": 9.81, "l": 0.7}

# States are random numbers of order one. The equations divide by no small number there, so a hundred roundings
# stay far below this; a wrong term changes the first digit.
SAME = 1e-12
BEAD = m * v**2 * (1 + 4 * c**2 * x**2) / 2 - m * g * c * x**2
# two equal point masses on equal rods
BARS = m * l**2 * (2 * p**2 + q**2 + 2 * p * q * cos(theta - phi)) / 2 + m * g * l * (2 * cos(theta) + cos(phi))


def built(lagrangian, coordinates, velocities, **how):
    return lagrange.load(lagrange.source(lagrangian, coordinates, velocities, **how))


def spherical_pendulum():
    """Return the equations of a spherical pendulum; z points up."""
    rod = [(x**2 + y**2 + z**2 - l**2) / 2]
    return built(m * (u**2 + v**2 + w**2) / 2 - m * g * z, [x, y, z], [u, v, w], constraints=rod)


def chaplygin_sleigh():
    """Return the equations of a knife edge at (x, y) along theta; G is c ahead of it, with inertia I about G."""
    vx, vy = u - c * sin(theta) * w, v + c * cos(theta) * w
    T = m * (vx**2 + vy**2) / 2 + I * w**2 / 2
    edge = [v * cos(theta) - u * sin(theta)]
    return built(T, [x, y, theta], [u, v, w], constraints=edge)


def test_time_in_the_lagrangian():
    """A bead on a straight wire that turns at the rate W(t) has r'' = W^2 r; a constraint y = t^3 lifts a particle."""
    turned = built(m * (v**2 + (1 + t) ** 2 * x**2) / 2, [x], [v])
    assert turned.rhs(2.0, (0.3, -0.4), m=1.3) == pytest.approx((-0.4, 9 * 0.3), rel=SAME)
    lift = built(m * (u**2 + v**2) / 2 - m * g * y, [x, y], [u, v], constraints=[y - t**3])
    assert lift.rhs(2.0, (0.1, 8.0, 0.5, 12.0), m=1.3, g=9.81) == pytest.approx((0.5, 12.0, 0.0, 12.0), rel=SAME)
    assert lift.multipliers(2.0, (0.1, 8.0, 0.5, 12.0), m=1.3, g=9.81)[0] == pytest.approx(1.3 * (9.81 + 12))


def test_mass_matrix_and_forcing_are_what_rhs_solves():
    for system, size, numbers in (
        (built(BARS, [theta, phi], [p, q]), 4, NUMBERS),
        (spherical_pendulum(), 6, NUMBERS),
        (chaplygin_sleigh(), 6, {"m": 1.3, "c": 0.4, "I": 0.2}),
    ):
        for state in DRAW.uniform(-1.5, 1.5, (5, size)):
            arguments = (0.0, tuple(state))
            acceleration = np.array(system.rhs(*arguments, **numbers)[size // 2 :])
            inertial = np.array(system.mass_matrix(*arguments, **numbers)) @ acceleration
            forces = np.array(system.forcing(*arguments, **numbers))
            if hasattr(system, "multipliers"):
                A = np.array(system.constraint_matrix(*arguments, **numbers))
                forces = forces + A.T @ system.multipliers(*arguments, **numbers)
            assert inertial == pytest.approx(forces, abs=SAME * 100)


def test_the_text_runs_where_sympy_and_numpy_are_not(tmp_path):
    """The generated text gives the same numbers if it is imported as a file or loaded by `load`."""
    text = lagrange.source(BEAD, [x], [v])
    (tmp_path / "bead.py").write_text(text, encoding="utf-8")
    code = (
        "import sys; sys.modules['sympy'] = None; sys.path.insert(0, sys.argv[1]);"
        "import bead; from tam570 import lagrange; from pathlib import Path;"
        "loaded = lagrange.load(Path(bead.__file__).read_text());"
        "arguments = (0.0, (0.3, -0.4)), dict(m=1.3, c=0.4, g=9.81);"
        "print(bead.rhs(*arguments[0], **arguments[1]) == loaded.rhs(*arguments[0], **arguments[1]));"
        "print(repr(bead.rhs(*arguments[0], **arguments[1]))); print('numpy' in sys.modules)"
    )
    command = [sys.executable, "-c", code, str(tmp_path)]
    printed = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    here = built(BEAD, [x], [v]).rhs(0.0, (0.3, -0.4), m=1.3, c=0.4, g=9.81)
    assert printed == ["True", repr(here), "False"]


def test_powers_roots_and_constants_are_printed_as_they_are():
    """The slope of a potential with each special case of the printer agrees with 30 digits of SymPy."""
    V = sympy.pi / (x + c) ** 2 + sympy.sqrt(x) / x**3 + sympy.exp(1) * (x - c) ** 4 + sympy.atan2(x, c) + 1 / x
    rhs = built(v**2 / 2 - V, [x], [v]).rhs
    for position, curve in DRAW.uniform(0.5, 2, (5, 2)):
        slope = float(sympy.diff(V, x).evalf(30, subs={x: position, c: curve}))
        assert rhs(0.0, (position, 0.0), c=curve)[1] == pytest.approx(-slope, rel=SAME)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: lagrange.source(m * v**2, [x], [v, w]), "^velocities: one for each"),
        (lambda: lagrange.source(m * v**2, [x], [v], forces=[1, 2]), "^forces: one for each"),
        (lambda: lagrange.source(m * v**2, [x, y], [v, w]), "^lagrangian: the mass matrix is singular"),
        (lambda: lagrange.source((v + w) ** 2, [x, y], [v, w]), "^lagrangian: the mass matrix is singular"),
        (lambda: lagrange.source(m * v**2, [x], [v], constraints=[v**2 - 1]), "^constraints must be linear"),
        (lambda: lagrange.source(m * v**2, [x], [v], constraints=[t]), "^constraints are not independent"),
        (lambda: lagrange.source(u**2 + v**2, [x, y], [u, v], constraints=[x * y, x * v + y * u]), "not independent"),
        (lambda: lagrange.source(symbols("lambda") * v**2, [x], [v]), "'lambda' cannot be a name"),
        (lambda: lagrange.source(m * v**2, [t], [v]), "'t' stands for two"),
        (lambda: lagrange.source(v**2 - sympy.Heaviside(x) * x, [x], [v]), "no function of math computes"),
    ],
)
def test_what_cannot_be_written_is_refused(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_an_indefinite_mass_matrix_is_eliminated_or_refused():
    x, y, v, w, m, k = sympy.symbols("x y v w m k")
    with pytest.raises(ValueError, match="indefinite"):
        lagrange.source(m * v * w - k * x * y, [x, y], [v, w])  # M = [[0, m], [m, 0]]
    twin = lagrange.load(lagrange.source(m * v * v / 2 + 2 * m * v * w - k * x * x / 2, [x, y], [v, w]))
    _, _, a, b = twin.rhs(0.0, (1.0, 0.5, 0.0, 0.0), m=2.0, k=3.0)
    assert (2.0 * a + 4.0 * b, 4.0 * a) == pytest.approx((-3.0, 0.0))
