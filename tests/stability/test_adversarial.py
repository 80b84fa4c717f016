"""Difficult right-hand sides: `solve` is correct to a hundred times the tolerance, or raises an error that says why.

Contact, friction, jumps, pulses, lookups, branches, tuples, closures, state, randomness, edges of a domain. Each is
compared with an exact answer, or with SciPy's DOP853 at its best tolerance and with short steps, which starts again at
each jump in time. Each call is repeated, because no answer may depend on what ran before.
"""

import bisect
import cmath
import dataclasses
import functools
import itertools
import math
import pickle

import numpy as np
import pytest
from parameters import first
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline, RegularGridInterpolator, interp1d

from tam570.integrate import solve

RTOL, G, EDGE = 1e-9, 9.81, [1.0, 1.01]
HAT = interp1d([0, 1, 1.0001, 1.0099, 1.01, 9], [0, 0, 1, 1, 0, 0])
LINE = RegularGridInterpolator((HAT.x,), HAT.y)
TOOTHED = CubicSpline(np.arange(41) / 10, np.arange(41) == 25)


def against(rhs, span, start, *, stops=(), longest=0.1, exact=None, **options):
    """Return a case; the rates jump at the times `stops`, and SciPy's steps are at most `longest`."""
    return rhs, span, start, stops, longest, exact, options


def newton(acceleration, span, start=(0.0, 0.0), **more):
    """Return a case of a particle with this acceleration(t, x, v)."""
    return against(lambda t, y: (y[1], acceleration(t, y[0], y[1])), span, start, **more)


def by_scipy(rhs, span, start, stops, longest):
    state, (first, last) = np.array(start, dtype=float), span
    options = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13, "max_step": longest}
    for end in (*stops, last):
        low, high = np.nextafter(first, math.inf), np.nextafter(end, -math.inf)
        rates = functools.partial(lambda t, y, a, b: np.array(rhs(min(max(t, a), b), np.array(y))), a=low, b=high)
        with np.errstate(all="ignore"):  # SciPy divides 0 by 0 if all rates are zero
            state = solve_ivp(rates, (first, end), state, **options).y[:, -1]
        first = end
    return state


def wall(stiffness):
    return lambda t, y: (y[1], -stiffness * y[0] if y[0] < 0 else 0.0)


def bouncing(stiffness, damping=0.0):
    return lambda t, y: (y[1], -G + max(0.0, -stiffness * y[0] - damping * y[1]) if y[0] < 0 else -G)


def cradle(t, y):
    """Return the rates of three balls that touch; the first swings into the others."""
    push = 1e5 * np.maximum(y[:2] - y[1:3], 0.0) ** 1.5
    return *y[3:], *(np.append(0.0, push) - np.append(push, 0.0) - G * y[:3])


def struck_at_rest(t, y):
    push = 200 * max(y[0] - y[2] - 0.1, 0.0)
    return y[1], -push, y[3], push


WALLS, BETWEEN_WALLS = (1e4, 1e9), [0.5 - 2e-7 * math.pi, 1.0]  # N/m
CONTACT = {
    **{f"wall {k:.0e}": against(wall(k), (0, 2), [1.0, -1.0], exact=[1 - math.pi / k**0.5, 1.0]) for k in WALLS},
    "damped ball": against(bouncing(1e6, 200.0), (0, 0.6), [1.0, 0.0], longest=2.5e-3),
    "Hertz": against(lambda t, y: (y[1], -G + 100000.0 * max(-y[0], 0.0) ** 1.5), (0, 0.6), [0.3, 0.0], longest=5e-3),
    "two walls": newton(lambda t, x, v: -1e14 * (min(x, 0) + max(x - 1, 0)), (0, 2), [0.5, 1], exact=BETWEEN_WALLS),
    "cradle": against(cradle, (0, 0.7), [-0.3, 0.0, 0.0, 0.0, 0.0, 0.0], longest=2e-3),
    "rest": against(struck_at_rest, (0, 2), [0, 1, 0, 0], exact=[0.1 + math.pi / 40, 0, 1.9 - math.pi / 40, 1]),
    "gap": against(lambda t, y: (y[1], -y[0] - 100.0 * np.maximum(y[0] - 0.5, 0.0)), (0, 5), [1.0, 0.0], longest=0.02),
    "where": newton(lambda t, x, v: np.where(x < 0, -1e5 * x, 0.0), (0, 1.4), [1.0, -1.0], longest=0.025),
    "clip": against(lambda t, y: np.array([y[1], -50.0 * np.clip(y[0], -0.3, 0.3)]), (0, 3), [1.0, 0.0]),
    "abs of a state": against(lambda t, y: (y[1], -500.0 * (abs(y[0]) + y[0]) / 2 - y[0]), (0, 3), [1.0, 0.0]),
}


def coulomb(t, y):
    """Return rates whose motion is half a turn about 0.5, then half a turn about -0.5, and then rest."""
    return y[1], -y[0] - 0.5 * np.sign(y[1])


def at_rest_near_zero(t, y):
    x, v = np.zeros(2) if np.allclose(y, 0) else y
    return v, -x - G


def by_while(t, y):
    angle = y[0]
    while angle > math.pi:
        angle -= 2 * math.pi
    return 1.0, math.cos(angle)


FRICTION = {
    "it stops": against(lambda t, y: (y[1], -2.0 if y[1] > 0 else 0.0), (0, 3), [0.0, 4.0], exact=[4.0, 0.0]),
    "from rest": against(lambda t, y: (y[1], 1.0 - 0.5 * np.sign(y[1])), (0, 2), [0.0, 0.0], exact=[1.0, 1.0]),
    "Coulomb": against(coulomb, (0, 5), [2.0, 0.0], exact=[-0.5 + 0.5 * math.cos(5), -0.5 * math.sin(5)]),
    "quadratic drag": against(lambda t, y: (y[1], -abs(y[1]) * y[1] - 1.0), (0, 3), [0.0, 2.0]),
    "belt": newton(lambda t, x, v: -4.0 * x - 0.3 * math.tanh((v - 0.5) / 0.05), (0, 5), [0.1, 0.0], longest=0.025),
    "relay": against(lambda t, y: (y[1], -y[0] + (0.5 if y[0] > 0 else -0.5)), (0, 4), [1.0, 0.0], longest=0.05),
    "magnet": against(lambda t, y: (y[1], -y[0] / (0.01 + y[0] ** 2)), (0, 3), [0.5, 0.0], longest=0.05),
    "saturated": against(lambda t, y: (y[1], -max(-1.0, min(1.0, 20.0 * y[0]))), (0, 3), [0.4, 0.0], longest=0.05),
    "thermostat": against(lambda t, y: (1.0 - y[0] if y[0] < 0.3 else 0.5 - y[0],), (0, 2), [0.1], longest=0.025),
    "comparisons": against(lambda t, y: (t > 1, y[0] > 0.5), (3, 0), [2.0, 1.5], exact=[0.0, 0.0]),
    "dictionary": against(lambda t, y: -{True: y, False: 2 * y}[bool(y[0] > 0.5)], (0, 2), [1.0], longest=0.025),
    "at rest near zero": against(at_rest_near_zero, (0, 5), [0.0, 0.0], exact=[G * math.cos(5) - G, -G * math.sin(5)]),
    "while": against(by_while, (0, 5), [0.0, 0.0], exact=[5.0, math.sin(5.0)]),
    "any": against(lambda t, y: -y if np.any(y > 0.5) else -2 * y, (0, 2), [1.0, -1.0], longest=0.025),
    "index": against(lambda t, y: -np.array([1.0, 2.0, 3.0])[int(min(2 * y[0], 2))] * y, (0, 2), [1.2], longest=0.025),
}


def forced(force, span, start=(0.0, 0.0), **more):
    """Return a case of an oscillator with a force that depends on time."""
    return newton(lambda t, x, v: force(t) - x, span, start, **more)


GRID, TOOTH = np.linspace(0, 8, 801), np.where(np.arange(801) == 403, 100.0, 0.0)
SINE_TO_20 = 3 * math.pi * math.comb(20, 10) / 2**20
FIFTHS, RAMP = (0.2, 0.4, 0.6, 0.8, 1.0), (0, 6.4, 7.2, 8.8)
JUMPS = {
    "narrow peaks of a sine": against(
        lambda t, y: (math.cos(44 * t) > 0.999997,), (0, 2), [0.0], exact=[29 * math.acos(0.999997) / 44]
    ),
    "square wave": forced(lambda t: 1.0 if t % 2 < 1 else -1.0, (0, 4.5), [0.3, 0.0], stops=(1, 2, 3, 4)),
    "a wave that begins with rest": forced(lambda t: 1 if math.sin(t) > 0 else -1, (0, 4.5), [1, 0], stops=(math.pi,)),
    "a wave from rest": forced(lambda t: math.sin(5 * t) > 0 or -1, (0, 3.5), stops=math.pi / 5 * np.arange(1, 6)),
    "by a shift": forced(lambda t: 3.0 if (t - 1.3) * 2 > 1 else 0.0, (0, 3), [1.0, 0.0], stops=(1.8,)),
    "ramp at rest": newton(lambda t, x, v: np.interp(t, RAMP, [0, 0, 2, -1]) - 0.3 * v, (0, 8), stops=RAMP[1:3]),
    "a sine that rounding moves": newton(lambda t, x, v: math.sin(math.pi * (t - 2)) if x < 9 else 0.0, (0, 4)),
    "abs in time": forced(lambda t: abs(t - 1.7), (0, 3), [1.0, 0.0], stops=(1.7,)),
    "sawtooth": forced(lambda t: 5 * t - math.floor(5 * t), (0.01, 1.1), stops=FIFTHS),
    "steep ramp": forced(lambda t: min(max((t - 2) * 1e4, 0), 1), (0, 4), stops=(2, 2.0001)),
    "a tooth in a table": forced(lambda t: np.interp(t, GRID, TOOTH), (3, 5), stops=(4.02, 4.03, 4.04)),
    "behind a branch": newton(
        lambda t, x, v: 5.0 if x < 0.9 and 1.2 < t < 1.25 else -x, (0, 3), [1.0, 0.0], stops=(1.2, 1.25)
    ),
    "backwards": against(lambda t, y: (1.0 if t > 1 else 0.0,), (2, 0), [1.0], exact=[0.0]),
    "a rate at one time": against(lambda t, y: (1e11 if t == 1 else 1.0,), (0, 2), [0.0], exact=[2.0]),
    "a jump at the end": against(lambda t, y: (1.0 if t < 2 else 1e9,), (0, 2), [0.0], exact=[2.0]),
    "a blow": forced(lambda t: 1e6 if abs(t - 1.5) < 5e-7 else 0.0, (0, 3), exact=[math.sin(1.5), math.cos(1.5)]),
}


def narrow(t, y, *, centre=5.0, width=0.02):
    return y[1], math.exp(-(((t - centre) / width) ** 2)) / width - y[0]


def by_numpy(t, y):
    return np.array([y[1], 50 * np.exp(-(((t - 5) / 0.02) ** 2)) - (y[0] if y[0] < 1e9 else 0.0)])


PULSES = {
    "narrower": against(narrow, (0, 3), [0.0, 0.0], longest=0.025, parameters={"centre": 2.1, "width": 0.004}),
    "tanh": forced(lambda t: 5 * (math.tanh((t - 5) / 0.1) - math.tanh((t - 5.5) / 0.1)), (0, 7), longest=0.025),
    "expanded": forced(lambda t: 40 * math.exp(-400 * t * t + 2400 * t - 3600), (0, 5), longest=0.05),
    "at rest at both ends": against(lambda t, y: (math.sin(t) ** 20,), (0, 3 * math.pi), [0.0], exact=[SINE_TO_20]),
    "from nothing": forced(lambda t: math.exp(-1 / t) if t > 0 else 0.0, (0, 10)),  # all derivatives are 0 at t = 0
    "logistic": forced(lambda t: 1 / (1 + math.exp(-200 * (t - 2))), (0, 4), longest=0.05),
    "train": forced(lambda t: 8 * math.exp(-((math.sin(2 * t) / 0.05) ** 2)), (0, 6), longest=0.05),
    "Lorentzian": forced(lambda t: 1 / (1 + ((t - 3) / 0.001) ** 2) * 100, (0, 5), longest=0.01),
    "not traced": against(by_numpy, (0, 6), [0.0, 0.0], longest=0.05),
}


def passing(force):
    """Return a case of a particle of unit speed with a force that depends on its position."""
    return newton(lambda t, x, v: force(x), (0, 8), [0.0, 1.0], longest=0.05)


def kicked(t, x, v):
    return -x + 20 * math.exp(-(((x - 0.5) / 0.005) ** 2))


def clock_in_the_state(t, y):
    return 1.0, y[2], 50 * math.exp(-(((y[0] - 5) / 0.02) ** 2)) - y[1]


PASSED = {
    "narrow well": passing(lambda x: -50 * (x - 5) * math.exp(-(((x - 5) / 0.02) ** 2))),
    "bump": passing(lambda x: 5 * math.exp(-(((x - 5) / 0.02) ** 2))),
    "window": passing(lambda x: 2 * (math.tanh((x - 3) / 0.01) - math.tanh((x - 3.1) / 0.01))),
    "sech": passing(lambda x: 4 / math.cosh((x - 4) / 0.02) ** 2),
    "edge by erf": passing(lambda x: math.erf((x - 4) / 0.02) + 1),
    "kicked from rest": newton(kicked, (0, 6), [1.0, 0.0], longest=0.05),
    "a clock in the state": against(clock_in_the_state, (0, 7), [0.0, 0.0, 0.0], longest=0.05),
}


def doubled_later(t, y):
    if t > 1:
        y = 2 * y
    return y[1], -y[0]


def counting(t, y, calls=[]):  # noqa: B006
    calls.append(t)
    return y[1], -y[0]


def in_place(t, y):
    y[0], y[1] = y[1], -y[0]
    return y


def filled(t, y):
    rates = np.empty(2)
    rates[0], rates[1] = y[1], -y[0]
    return rates


def by_exception(t, y):
    try:
        return y[1], -1.0 / (1 if y[0] > 0.5 else 0)
    except ZeroDivisionError:
        return y[1], -2.0


def by_newton(t, y):
    """Solve Kepler's equation by Newton's iteration, whose number of steps changes with time."""
    angle = t
    for _ in range(50):
        change = (angle - 0.6 * math.sin(angle) - t) / (1 - 0.6 * math.cos(angle))
        angle -= change
        if abs(change) < 1e-12:
            break
    return (math.cos(angle) - 0.1 * y[0],)


@dataclasses.dataclass
class Oscillator:
    """A right-hand side of a mutable class, which has no hash."""

    rate: float

    def __call__(self, t, y):
        return y[1], -self.rate * y[0]


def empty_cell():
    def rates(t, y):
        return (y[1], -y[0]) if t >= 0 else (late, late)

    if not rates:
        late = 0.0
    return rates


BENT = np.frompyfunc(lambda x: -x if x < 0.5 else -0.5, 1, 1)
START, SINE = np.array([1.0, 0.0]), [math.cos(3.0), -math.sin(3.0)]  # shared by all cases: none may change it
OSCILLATORS = {
    "of a matrix": lambda t, y: np.array([[0.0, 1.0], [-1.0, 0.0]]) @ y,
    "of halves": lambda t, y: np.concatenate([y[1:], -y[:1]]),
    "adds slices": lambda t, y: (y[::-1] + y[::-1]) * np.array([0.5, -0.5]),  # with tuples, + would concatenate
    "text": lambda t, y: (y[1], -y[0] if "Symbol" not in str(y[0]) and str(y[0])[0] in "-0123456789" else 7.0),
    "counting": counting,
    "eval": lambda t, y: (y[1], eval("-y[0]")),
    "nan_to_num": lambda t, y: np.nan_to_num(np.array([y[1], -y[0]])),
    "pickle": lambda t, y: (pickle.loads(pickle.dumps(y))[1], -y[0]),
    "array, then list": lambda t, y: np.array([y[1], -y[0]]) if t < 0.7 else [y[1], -y[0]],
    "type": lambda t, y: (y[1], -y[0]) if type(y[0]) in (float, np.float64) else (0.0, 0.0),
    "in place": in_place,
    "filled": filled,
    "generator": lambda t, y: [y[1], -sum(v for v in y[:1])],
    "of a class": (lambda cls, t, y: (y[1], -y[0])).__get__(Oscillator),
}
AT_ONE = {  # what changes at t = 1
    "doubled": doubled_later,
    "negated": lambda t, y: (y[1], -y[0]) if t < 1 else tuple(-y),
    "sum": lambda t, y: (y[1], -y[0]) if t < 1 else (y[1], -y.sum()),
    "isinstance": lambda t, y: (y[1], -y[0]) if t < 1 or not isinstance(y, np.ndarray) else (y[1], -3 * y[0]),
}
TRACES = {
    **{name: against(rhs, (0, 2), [1.0, 0.0], stops=(1,)) for name, rhs in AT_ONE.items()},
    "import": against(lambda t, y: (y[1], -__import__("math").sin(y[0])), (0, 3), [1.0, 0.0]),
    "class": against(Oscillator(4.0), (0, 3), [1.0, 0.0], exact=[math.cos(6.0), -2 * math.sin(6.0)]),
    "frompyfunc": against(lambda t, y: (y[1], float(BENT(y[0]))), (0, 3), [1.0, 0.0]),
    "by Newton's iteration": against(by_newton, (0, 2), [0.0]),
    "by exception": against(by_exception, (0, 1.5), [1.0, 0.0], longest=0.025),
    **{name: against(rhs, (0, 3), START, exact=SINE) for name, rhs in OSCILLATORS.items()},
    "empty cell": against(empty_cell(), (0, 3), [1.0, 0.0], exact=SINE),
}


def limited(t, y):
    z = y[0] + 1j * y[1]
    rate = 2j * z if z.real > 0 else z.conjugate() - cmath.exp(1j * t)
    return rate.real, rate.imag


def modes(t, y):
    psi = y[:2] + 1j * y[2:]
    rates = -1j * (np.array([[1.0, 0.5j], [-0.5j, 2.0]]) @ psi + np.abs(psi) ** 2 * psi)
    return np.concatenate([rates.real, rates.imag])


def viewed(t, y):
    z = y.view(complex)
    return (1j * z - 0.1 * z * np.abs(z) ** 2).view(float)


def vortices(t, y):
    z = y[0::2] + 1j * y[1::2]
    rates = np.zeros(len(z), dtype=complex)
    for k in range(len(z)):
        rates[k] = sum(1 / (z[k] - other) for i, other in enumerate(z) if i != k)
    rates = np.conj(rates / 2j)
    return np.column_stack([rates.real, rates.imag]).ravel()


COMPLEX = {
    "limited": against(limited, (0, 3), [1.0, 0.2], longest=0.025),
    "modes": against(modes, (0, 3), [1.0, 0.2, 0.3, -0.4]),
    "viewed": against(viewed, (0, 3), [1.0, 0.2]),
    "vortices": against(vortices, (0, 3), [0.5, 0.3, -0.4, 0.2, 1.0, 0.9]),
}


def root(x, beyond=0.0, scale=1.0):
    try:
        return scale * math.sqrt(x)
    except ValueError:
        return beyond


ZIGZAG = math.pi**2 + 2 * (3.5 - math.pi) ** 2
EDGES = {
    "sqrt": against(lambda t, y: (math.sqrt(y[0]),), (0, 2), [0.1], exact=[(math.sqrt(0.1) + 1) ** 2]),
    "log with base": against(lambda t, y: (math.log(y[0], 2),), (0, 1), [1.2]),
    "acos": against(lambda t, y: (math.acos(y[0]),), (0, 0.3), [0.5]),
    "power": against(lambda t, y: (-(y[0] ** 1.4),), (0, 2), [0.2]),
    "pow": against(lambda t, y: (-math.pow(y[0], 1.4),), (0, 2), [0.2]),
    "relativistic": against(lambda t, y: (y[1], -y[0] * math.sqrt(1 - y[1] ** 2)), (0, 2), [0.1, 0.9]),
    "hypot of three": against(lambda t, y: (y[1], -math.hypot(y[0], y[1], 1.0)), (0, 2), [1.0, 0.0]),
    "its own fallback": against(lambda t, y: (-root(y[0]),), (0, 3), [1.0], exact=[0.0]),
    "stiff": against(lambda t, y: (-1e4 * (y[0] - math.cos(t)),), (0, 0.3), [1.0], longest=0.025),
    "fast start": against(lambda t, y: (-1e5 * y[0], y[0]), (0, 0.05), [1.0, 0.0], exact=[0.0, 1e-5]),
    "from zero": against(lambda t, y: (y[1], 1e6 * (math.sin(t) - y[0])), (0, 0.5), [0.0, 0.0], longest=0.025),
    "on a circle": newton(lambda t, x, v: -x if x * x + v * v > 1 else -x, (0, 3), [1.0, 0.0], exact=SINE),
    "from a switch": newton(lambda t, x, v: 0.0 if x < 0.5 else -1.0, (0, 1), [0.5, 0.275], exact=[0.37625, -0.275]),
    "zero over zero, traced": against(lambda t, y: (math.sin(t - 2) / (t - 2),), (0.1, 3), [0.0]),
    "zero over zero": newton(lambda t, x, v: math.sin(t - 2) / (t - 2) - (x if v < 9 else 0.0), (0.1, 3)),
    "three derivatives of zero": against(lambda t, y: (t**3,), (0, 30), [0.0], exact=[202500.0]),
    "at rest": against(lambda t, y: (0.0,), (0, 30), [1.5], exact=[1.5]),
    "a constant rate": against(lambda t, y: (2.0,), (0, 30), [0.0], exact=[60.0]),
    "acos of cos": against(lambda t, y: (1.0, math.acos(math.cos(y[0]))), (0, 7), [0.0, 0.0], exact=[7, ZIGZAG]),
    "a cusp": against(lambda t, y: (1.0, 100 * math.exp(-abs(y[0] - 1) * 100)), (0, 3), [0.0, 0.0], exact=[3.0, 2.0]),
    "slow": against(lambda t, y: (y[1] * 1e-150, -y[0] * 1e-150), (0, 3e150), [1.0, 0.0], exact=SINE),
    "tiny beside large": against(lambda t, y: (y[1], -y[0], -y[2]), (0, 3), [1e6, 0.0, 1e-6], longest=0.05),
}
CASES = {**CONTACT, **FRICTION, **JUMPS, **PULSES, **PASSED, **TRACES, **COMPLEX, **EDGES}


@pytest.mark.parametrize("name", CASES)
def test_it_is_right_and_the_same_whatever_ran_before(name):
    rhs, span, start, stops, longest, exact, options = CASES[name]
    if exact is None:
        exact = by_scipy(functools.partial(rhs, **options.get("parameters", {})), span, start, stops, longest)
    motion = solve(rhs, span, start, rtol=RTOL, report=True, **options)
    is_traced, first = not motion.report.untraced_reason, motion.states[-1]
    repeats = [solve(rhs, span, start, rtol=RTOL, **options)[-1] for _ in range(3 if is_traced else 1)]  # cached runs
    assert all((state == first).all() for state in repeats)
    assert first == pytest.approx(exact, rel=100 * RTOL, abs=100 * RTOL)
    assert name not in COMPLEX or (not motion.report.unseen_reason and motion.report.steps < 200)  # visible to `solve`
    if is_traced:
        compiled = solve(rhs, span, start, rtol=RTOL, method="compiled", **options)[-1]
        assert compiled == pytest.approx(exact, rel=100 * RTOL, abs=100 * RTOL)


@pytest.mark.parametrize("decay", [32.0, 1000.0])
@pytest.mark.parametrize("rtol", [1e-6, 1e-9, 1e-12])
def test_the_states_inside_steps_at_the_limit_of_stability_are_right(decay, rtol):
    def rhs(t, y):
        return -decay * y[0], -math.sin(t)

    few, many = np.linspace(0, 10, 6), np.linspace(0, 10, 2001)
    at = solve(rhs, few, [1.0, 1.0], rtol=rtol, dense=True).at
    runs = [solve(rhs, few, [1.0, 1.0], rtol=rtol, method=method) for method in ("auto", "python")]
    for t, states in [(many, at(many)), *((few, states) for states in runs)]:
        assert states == pytest.approx(np.column_stack([np.exp(-decay * t), np.cos(t)]), rel=0, abs=100 * rtol)


class Window:
    """A window function that stores its table and its inputs."""

    def __init__(self):
        self.table, self.inputs = HAT, []

    def __call__(self, x):
        self.inputs.append(x)
        return float(self.table(x))


# name: (function that a rate of 1 grows by in a short window of x, its integral over x from 0 to 3, the time that it
# saves if x is the state).
WINDOWS = {
    "between": (lambda x: 1 < x < 1.01, 0.01, 0.005),
    "absolute": (lambda x: abs(x - 1) < 0.005, 0.01, 0.005),
    "modulo": (lambda x: 1.0 < x % 1.5 < 1.02, 0.04, 0.02),
    "numpy.mod": (lambda x: (np.mod(x, 1.5) > 1) & (np.mod(x, 1.5) < 1.02), 0.04, 0.02),
    "fmod": (lambda x: 1.0 < math.fmod(x, 1.5) < 1.02, 0.04, 0.02),
    "remainder": (lambda x: math.remainder(x, 2) < -0.99, 0.01, 0.005),
    "sine": (lambda x: math.sin(x) > math.cos(0.01), 0.02, 0.01),
    "product": (lambda x: 1.0 < x * x < 1.0201, 0.01, 0.005),
    "logical_and": (lambda x: np.logical_and(x > 1, x < 1.01), 0.01, 0.005),
    "hypot": (lambda x: math.hypot(x - 1, 0.003) < 0.005, 0.008, 0.004),
    "floor": (lambda x: math.floor(20 * x) == 20, 0.05, 0.025),
    "round": (lambda x: round(20 * x) == 20, 0.05, 0.025),
    "ceil": (lambda x: np.ceil(20 * x) == 20, 0.05, 0.025),
    "clip": (lambda x: np.clip(x, 1, 1.01) not in (1, 1.01), 0.01, 0.005),
    "open clip": (lambda x: np.clip(x - 1, 0, None) * np.clip(1.01 - x, a_min=0, a_max=None) > 0, 0.01, 0.005),
    "ufunc.reduce": (lambda x: np.minimum.reduce([x - 1, 1.01 - x]) > 0, 0.01, 0.005),
    "functools.reduce": (lambda x: functools.reduce(np.minimum, [x - 1, 1.01 - x]) > 0, 0.01, 0.005),
    "modf": (lambda x: math.modf(20 * x)[1] == 20, 0.05, 0.025),
    "numpy.modf": (lambda x: np.modf(np.array([20 * x]))[1][0] == 20, 0.05, 0.025),
    "signs": (lambda x: (np.sign(x - 1) - np.sign(x - 1.01)) / 2, 0.01, 0.005),
    "heaviside": (lambda x: np.heaviside(x - 1, 1) - np.heaviside(x - 1.01, 1), 0.01, 0.005),
    "where": (lambda x: np.where((x > 1) & (x < 1.01), 1.0, 0.0), 0.01, 0.005),
    "piecewise": (lambda x: np.piecewise(x, [x < 1, (x >= 1) & (x < 1.01)], [0.0, 1.0, 0.0]), 0.01, 0.005),
    "isclose": (lambda x: math.isclose(x, 1, abs_tol=0.005, rel_tol=0), 0.01, 0.005),
    "numpy.isclose": (lambda x: np.isclose(x, 1, atol=0.005, rtol=0), 0.01, 0.005),
    "searchsorted": (lambda x: np.searchsorted(EDGE, [x])[0] == 1, 0.01, 0.005),
    "bisect": (lambda x: bisect.bisect(EDGE, x) == 1, 0.01, 0.005),
    "dictionary": (lambda x: {20: 1.0}.get(int(20 * x), 0.0), 0.05, 0.025),
    "text": (lambda x: str(float(x)).startswith("1.00"), 0.01, 0.005),
    "counted": (lambda x: sum(1 for edge in (1.0, 2.0) if edge <= x < edge + 0.01), 0.02, 0.01),
    "numpy.interp": (lambda x: np.interp(x, HAT.x, HAT.y), 0.0099, None),
    "in an object": (Window(), 0.0099, None),
    "complex": (lambda x: abs(complex(x, 0.003) - 1) < 0.005, 0.008, 0.004),
    "parts": (lambda x: 1 < (np.array([x, 9.0]) * 1j + 2).imag[0] < 1.01, 0.01, 0.005),
    "numpy.angle": (lambda x: math.atan2(1, 0.01) < np.angle(1j + (x - 1)) < math.pi / 2, 0.01, 0.005),
    "cmath": (lambda x: math.atan2(1, 0.01) < cmath.phase(x - 1 + 1j) < math.pi / 2, 0.01, 0.005),
    "caught": (lambda x: root((x - 1) * (x - 1.01), 1.0, 0.0), 0.01, 0.005),
    "complex root": (lambda x: cmath.sqrt((x - 1) * (1.01 - x)).real > 0, 0.01, 0.005),
    "view": (lambda x: 1 < np.array([0.0, x]).view(complex)[0].imag < 1.01, 0.01, 0.005),
    "lru_cache": (functools.lru_cache(lambda x: 1 < x < 1.01), 0.01, 0.005),
    "vectorize": (np.vectorize(lambda x: 1.0 if 1 < x < 1.01 else 0.0), 0.01, 0.005),
    "grid": (lambda x: LINE([x])[0], 0.0099, None),
    "a tooth of a spline": (lambda x: float(TOOTHED(x)), TOOTHED.integrate(0, 3), None),
}


@pytest.mark.parametrize("name", WINDOWS)
def test_no_window_of_time_or_state_is_stepped_over(name):
    window, of_time, of_state = WINDOWS[name]
    end = solve(lambda t, y: (1.0 + float(window(t)),), [0, 3], [0.0], rtol=RTOL)[-1, 0]
    assert end == pytest.approx(3 + of_time, rel=100 * RTOL)
    if of_state:
        end = solve(lambda t, y: (1.0 + float(window(y[0])),), [0, 2.9], [0.0], rtol=RTOL)[-1, 0]
        assert end == pytest.approx(2.9 + of_state, rel=100 * RTOL)


def test_a_start_has_its_answer_whatever_started_before():
    starts = np.linspace([-1.0, 0.1], [1.0, -0.4], 5)
    passed = functools.partial(solve, lambda t, y: (y[1], 1.0 if 0.2 < y[0] < 0.5 else -y[0]), [0, 4])
    assert (passed(starts) == [passed(start) for start in starts]).all()
    iterated = functools.partial(solve, lambda t, y: (*(by_newton(t, y) if y[1] > 0 else -y[:1]), 0.0), [0, 1])
    starts = [[0.0, 1.0], [0.3, -1.0]]  # the first has switches that cannot be located
    assert (iterated(starts) == [iterated(start) for start in starts]).all()


def test_no_start_is_lucky_at_a_kink():
    starts = np.linspace([0.0, 1.0], [0.5, 1.0], 40)
    ends = solve(lambda t, y: (y[1], -50 * (abs(y[0] - 1) + y[0] - 1)), [0, 3], starts, rtol=RTOL)[:, -1]
    assert ends == pytest.approx(np.column_stack([math.pi / 10 - 1 - starts[:, 0], -np.ones(40)]), rel=100 * RTOL)


def test_a_whole_number_that_the_state_leaves_downwards_is_a_switch():
    duration = 0.0005 + sum(1 / k for k in range(901, 1000))
    end = solve(lambda t, y: (-round(y[0], 3),), [0, duration], [1.0], rtol=RTOL)[-1, 0]
    assert end == pytest.approx(0.9005, abs=RTOL)


@pytest.mark.parametrize(
    ("rate", "end", "method", "most"),
    [
        (lambda t: np.interp(t, GRID, np.cos(GRID)), 2, "auto", 6 * 200),  # entries of a table
        (lambda t: np.cos(GRID)[np.searchsorted(GRID, t)], 2, "auto", 6 * 200),
        (lambda t: 10 * math.cosh(40 * (t - 5)) ** -2, 8, "compiled", 1000),  # a series far from a pulse
    ],
)
def test_it_takes_few_steps(rate, end, method, most):
    report = solve(lambda t, y: (rate(t),), [0, end], [0.0], rtol=RTOL, method=method, report=True).report
    assert report.steps + report.refusals < most


def smooth_window(width):
    """Return a window of t about 6.1 with an integral of 1; it is as smooth as a cubic spline."""
    return lambda t: 315 / 256 / width * max(0.0, 1 - ((t - 6.1) / width) ** 2) ** 4


FROM_ZERO = {  # pulses of t about 6.1 with an integral of 1
    "a window": smooth_window(0.1),
    "a shorter window": smooth_window(1e-3),
    "logistic": lambda t: 1e3 / (1 + math.exp(min(700, 1e5 * (6.0995 - t)))) / (1 + np.exp(1e5 * (t - 6.1005))),
    "a tooth": lambda t: np.interp(t, [0, 6.099, 6.1, 6.101, 10], [0, 0, 1e3, 0, 0]),
}


@pytest.mark.parametrize("rtol", first(1, [RTOL, 1e-6, 1e-12]))
@pytest.mark.parametrize("name", FROM_ZERO)
def test_a_brief_pulse_moves_what_starts_at_zero(name, rtol):
    pulse = FROM_ZERO[name]
    for start in (0.0, 1e-60):
        end = solve(lambda t, y: (y[1], float(pulse(t))), [0, 10], [start, start], rtol=rtol)[-1]
        assert end == pytest.approx([3.9, 1.0], rel=100 * rtol)
        backwards = solve(lambda t, y: (float(pulse(t)),), [10, 0], [start], rtol=rtol)[-1]
        assert backwards == pytest.approx([-1.0], rel=100 * rtol)


@pytest.mark.parametrize("rtol", first(1, [RTOL, 1e-12]))
def test_what_jumps_all_the_time_is_soon_refused(rtol):
    calls = itertools.count()
    with pytest.raises(ArithmeticError, match="no round"):
        solve(lambda t, y: (-round(y[0], 5) + 0.0 * next(calls),), [0, 2], [1.0], rtol=rtol)
    assert next(calls) < 100_000


def test_what_a_function_keeps_are_numbers():
    assert {type(x) for x in WINDOWS["in an object"][0].inputs} <= {float}
    times = []

    def rates(t, y):
        times.append(t)
        return y[1], -y[0] if y[0] < 0.5 else -1.0

    solve(rates, [0, 3], [0.0, 1.0])
    assert {type(t) for t in times} == {float}
    with pytest.raises(ValueError, match="remember"):  # the last stages of a step have one time
        solve(kept_by_time, [0, 3], [1.0, 0.0], rtol=RTOL, dense=True)


def remembers():
    held = [0.0]

    def rates(t, y):
        held[0] += 0.1
        return (-y[0] - held[0],)

    return rates


def hysteresis():
    mode = [1.0]

    def rates(t, y):
        mode[0] = -1.0 if y[0] > 1 else 1.0 if y[0] < -1 else mode[0]
        return y[1], mode[0]

    return rates


def rounded_memory():
    rounded = {}
    return lambda t, y: (-rounded.setdefault(round(float(y[0]), 3), math.sin(y[0])),)


def kept_integral():
    memory = {"t": 0.0, "sum": 0.0}

    def rates(t, y):
        memory["sum"] += (1 - y[0]) * max(t - memory["t"], 0.0)
        memory["t"] = t
        return (memory["sum"] - y[0],)

    return rates


def delay():
    """Return y' = -y(t - 1) from a list of all calls, which becomes slower with every call."""
    history = [(0.0, 1.0)]

    def rates(t, y):
        history.append((t, float(y[0])))
        return (-max(call for call in history if call[0] <= max(t - 1.0, 0.0))[1],)

    return rates


def noise(seed, since=0.0):
    rng = np.random.default_rng(seed)
    return lambda t, y: (-y[0] + (rng.normal() if t >= since else 0.0),)


def kept_by_time(t, y, memory=[math.nan, ()]):  # noqa: B006
    if t != memory[0]:
        memory[:] = t, (y[1], -y[0] - 0.1 * y[0] * y[1])
    return memory[1]


class Mine(ValueError):
    """An exception that a right-hand side raises."""


def own_error(t, y):
    if y[0] < 0.2:
        raise Mine("below the ground")
    return (-1.0,)


def singular(t, y):
    return np.linalg.solve([[y[0] - 0.5 if y[0] > 0.5 else 0.0]], [-1.0])


def circle(t, y):
    return y[1], -y[0] - math.copysign(0.1, y[0] ** 2 + y[1] ** 2 - 0.9) * y[1]


def table(t, y):
    return (1.0 if np.searchsorted(np.cumsum([0.3, 0.3, 0.4]), y[0]) < 1 else -1.0,)


def struck(duration):
    """Return the rates of an oscillator that is struck by an impulse of 1 at t = 1.5."""
    return lambda t, y: (y[1], (1 / duration if abs(t - 1.5) < duration / 2 else 0.0) - y[0])


reciprocal = functools.lru_cache(lambda x: 1 / (x - 1))
AT_1, TO_AND_FRO = r"t = (1|0\.99)", "to and fro at t = "
REFUSED = {  # name: (rates, times, start, words of the message, the exception if it is no ArithmeticError)
    "it remembers": (remembers(), (0, 1), [1.0], "remember", ValueError),
    "a delay": (delay(), (0, 20), [1.0], "remember", ValueError),
    "hysteresis": (hysteresis(), (0, 5), [0.0, 0.0], "remember", ValueError),
    "a memory with rounded keys": (rounded_memory(), (0, 2), [1.0], "remember", ValueError),
    "an integral that it keeps": (kept_integral(), (0, 3), [0.0], "remember", ValueError),
    "noise": (noise(1), (0, 1), [1.0], "random", ValueError),
    "noise that sets in": (noise(17, 0.5), (0, 1), [1.0], "random", ValueError),
    "an error of its own": (own_error, (0, 2), [1.0], "below the ground", Mine),
    "a singular matrix": (singular, (0, 2), [1.0], "finite|Singular", (np.linalg.LinAlgError, ArithmeticError)),
    "two numbers later": (lambda t, y: -y if y[0] > 0.5 else (-y[0], 0.0), (0, 2), [1.0], "must return 1", ValueError),
    "complex later": (lambda t, y: ((y[0] - 0.5 + 0j) ** 0.5 * -1 - 0.1,), (0, 2), [1.0], "real", ValueError),
    "it ends at zero": (lambda t, y: (-math.sqrt(y[0]),), (0, 3), [1.0], r"not finite at t = (2|1\.9)"),
    "infinite": (lambda t, y: (y[0] ** 2,), (0, 2), [1.0], "infinite"),
    "infinite, not traced": (lambda t, y: (y[0] ** 2 if y[0] else 0.0,), (0, 2), [1.0], "infinite"),
    "friction that holds": (lambda t, y: (-np.sign(y[0]),), (0, 3), [1.0], f"{TO_AND_FRO}1"),
    "a pole of time": (lambda t, y: (math.tan(t),), (0, 2), [0.0], r"t = 1\.57"),
    "a pole": (lambda t, y: (1 / math.sin(t),), (1, 4), [0.0], r"t = 3\.14"),
    "two poles": (lambda t, y: (math.tan(t) / (t * t - 2) if y[0] < 99 else 0.0,), (0, 1.6), [0.0], r"t = 1\.41"),
    "an infinite rate": (lambda t, y: (abs(t - 2) ** -0.7 if t != 2 else 0.0,), (1, 4), [0.0], r"t = (2|1\.99)"),
    "a hidden pole of the state": (lambda t, y: (1, reciprocal(float(y[0]))), (0, 2.7), [0.0, 0.0], AT_1),
    "a pole of the state": (lambda t, y: (1, 1 / (y[0] - 1)), (0, 2), [0.0, 0.0], AT_1),
    "a root that holds": (lambda t, y: (np.cbrt(1 - y[0]),), (0, 10), [0.0], rf"{TO_AND_FRO}1\.5"),
    "a column": (lambda t, y: (y[1], -y[0]), (0, 1), [[1.0], [0.0]], "^y0.*ravel", ValueError),
    "a masked start": (Oscillator(1.0), (0, 1), np.ma.array([1.0, 0.0], mask=[0, 1]), "^y0.*masked", ValueError),
    "masked rates": (lambda t, y: np.ma.masked_less([y[1], -y[0]], -0.5), (0, 3), [1.0, 0.0], "masked", ValueError),
    "no rate later": (lambda t, y: (None if t > 0.5 else 1.0,), (0, 1), [0.0], "None", ValueError),
    "a wall far from zero": (wall(1e8), (1e9, 1e9 + 2), [1.0, -1.0], "rounding of time"),
    "a clock without digits": (lambda t, y: (math.sin(3 * t),), (1.7e9, 1.7e9 + 9), [0.0], "^t: .*rounded", ValueError),
    "a generator": (lambda t, y: (-v for v in y), (0, 1), [1.0], "generator", ValueError),
    "a blow from rest": (struck(1e-10), (0, 3), [0.0, 0.0], "pulse"),
    "a brief pulse": (lambda t, y: (math.exp(-((t - 2.2) ** 2) * 1e20) * 1e10,), (0, 5), [1.0], "rounding of time"),
    "a brief pulse from zero": (lambda t, y: (smooth_window(1e-9)(t),), (0, 10), [0.0], "rounding of time"),
    "a brief tooth": (lambda t, y: (max(0, 1e10 - 1e20 * abs(t - 2.2)),), (0, 5), [1.0], "rounding of time"),
    "one rate of seven digits": (lambda t, y: (y[1], -np.float32(y[0])), (0, 3), [1.0, 0.0], "float64", ValueError),
    "three digits": (lambda t, y: (np.float16(y[1]), -y[0]), (0, 3), [1.0, 0.0], "float64", ValueError),
    "seven digits": (lambda t, y: np.array([y[1], -y[0]], dtype=np.float32), (0, 9), [1.0, 0.0], "float64", ValueError),
    "a table that holds": (table, (0, 3), [0.0], f"{TO_AND_FRO}0.3"),
    "friction that holds a start": (lambda t, y: (y[1], -y[0] - 5 * np.sign(y[1])), (0, 3), [1.0, 0.0], TO_AND_FRO),
    "a circle that holds": (circle, (0, 5), [1.0, 0.0], f"{TO_AND_FRO}1.33"),
    "a weak pole": (lambda t, y: (1, abs(y[0] - 1) ** -0.9 if y[0] < 9 else 0), (0, 4), [0, 0], f"{AT_1}.*infinite"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_has_no_answer_is_said(name):
    rhs, span, start, words, *error = REFUSED[name]
    with pytest.raises(*error or [ArithmeticError], match=words):
        solve(rhs, span, start, rtol=RTOL)


def test_constants_of_seven_digits_are_right():
    states = solve(lambda t, y: (np.float32(1.5 if t < 1 else -0.5), 2.0), [0, 3], [0.0, 0.0], rtol=RTOL)
    assert states[-1] == pytest.approx([0.5, 6.0], rel=RTOL)


@pytest.mark.parametrize(("width", "rtol"), [(0.1, 1e-6), (0.1, 1e-12), (1e-3, 1e-6)])
def test_fixed_steps_resolve_a_pulse(width, rtol):
    centred = {"centre": 3.3, "width": width}
    state = solve(narrow, [0, 10], [0.0, 0.0], parameters=centred, method="gauss", rtol=rtol)[-1]
    blow = math.sqrt(math.pi) * math.exp(-(width**2) / 4)
    assert state == pytest.approx([blow * math.sin(6.7), blow * math.cos(6.7)], rel=100 * rtol)
    with pytest.raises(ValueError, match=r'^method: .* too many; try "auto"'):
        solve(narrow, [0, 10], [0.0, 0.0], parameters={"centre": 3.3, "width": 1e-8}, method="gauss", rtol=rtol)


@pytest.mark.parametrize("method", ["gauss", "composition"])
@pytest.mark.parametrize("options", [{"rtol": 1e-6}, {"rtol": RTOL}, {"step": 0.01}])
def test_fixed_steps_end_where_the_solution_becomes_infinite(method, options):
    with pytest.raises(ArithmeticError, match=rf"{AT_1}.*infinite"):
        solve(lambda t, y: (y[1], 6 * y[0] ** 2), [0, 1.5], [1.0, 2.0], method=method, **options)
    with pytest.raises(ArithmeticError, match="steps of 3 s are too long near t = 0: give a shorter"):
        solve(lambda t, y: (y[1], -math.exp(9 * math.sin(y[0]))), [0, 6], [1.0, 0.0], method="gauss", step=3.0)


def test_no_step_is_longer_than_asked_for():
    def blind(t, y):
        return (20.0 if math.cos(t - 1.02) > 0.9996 else 0.0,)  # for 0.0566 s

    width = 2 * math.acos(0.9996)
    for method in ("auto", "python"):
        end = solve(blind, [0, 5], [1.0], max_step=0.01, method=method)[-1, 0]
        assert end == pytest.approx(1 + 20 * width, abs=1e-7)
    report = solve(lambda t, y: (y[1], -y[0]), [0, 5], [1.0, 0.0], max_step=0.01, report=True).report
    assert report.steps >= 500
    assert solve(lambda t, y: (1.0,), [0, 5], [0.0], first_step=1e-3, report=True, method="python").report.steps > 3
