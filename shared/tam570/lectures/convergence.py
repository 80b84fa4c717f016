"""28 Sept: Convergence of a numerical solution, and why it does not make the equations right.

A double pendulum of two particles on rods without mass; angles from straight down. Along the rods the balance of
forces gives the tensions, T1 = m1 (l1 om1^2 + g cos th1) + T2 cos(d) with d = th2 - th1, and, as rod 2 keeps its
length, T2 (1/m2 + sin(d)^2/m1) = l2 om2^2 + (l1 om1^2 + g cos th1) cos(d); across them it gives the angular
accelerations. The wrong equations forget l1 om1^2, the centripetal acceleration of particle 1, in T2. With half the
step, a method of order p has 2^-p of the error, by the right equations and by the wrong ones; only the energy tells
them apart (Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.1).
"""

from collections.abc import Sequence
from math import cos, sin

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import nonnegative, numbers, positives, sequence
from tam570.integrate import solve
from tam570.invariants import observed_order
from tam570.show.scene import Array
from tam570.show.scenes import convergence, drawn_for
from tam570.values import Function, Parameters

STATE = {"th1": "rad", "th2": "rad", "om1": "rad/s", "om2": "rad/s"}
EXAMPLE: Parameters = {"masses": (1.0, 0.6), "lengths": (1.0, 0.8), "gravity": 9.81}  # kg, m, m/s^2
START = (1.2, 0.4, 0.0, 0.0)
SECONDS = 8.0
DURATION, SHORTEST = 0.5, 1e-6  # s: time at which `errors` compares; shortest step
STAGES: dict[str, tuple[tuple[float, ...], ...]] = {  # weights of the earlier stages in each stage; last, in the step
    "euler": ((), (1.0,)),
    "heun": ((), (1.0,), (1 / 2, 1 / 2)),
    "rk4": ((), (1 / 2,), (0.0, 1 / 2), (0.0, 0.0, 1.0), (1 / 6, 1 / 3, 1 / 3, 1 / 6)),
}


def rates(
    t: float, state: Sequence[float], *, masses: Sequence[float], lengths: Sequence[float], gravity: float
) -> tuple[float, ...]:
    """Return (4,) rates of the angles, rad/s, and accelerations, rad/s^2; masses (2,), kg, lengths (2,), m."""
    return _rates(state, masses, lengths, gravity, forget=False)


def wrong_rates(
    t: float, state: Sequence[float], *, masses: Sequence[float], lengths: Sequence[float], gravity: float
) -> tuple[float, ...]:
    """Return (4,) the same, wrongly without the centripetal acceleration of particle 1 in the tension of rod 2."""
    return _rates(state, masses, lengths, gravity, forget=True)


def _rates(
    state: Sequence[float], masses: Sequence[float], lengths: Sequence[float], gravity: float, forget: bool
) -> tuple[float, ...]:
    (m1, m2), (l1, l2) = _checked(masses, lengths, gravity)
    sequence(4, state=state)
    th1, th2, om1, om2 = state
    c, s = cos(th2 - th1), sin(th2 - th1)
    along = l1 * om1 * om1 + gravity * cos(th1)
    T2 = (l2 * om2 * om2 + (gravity * cos(th1) if forget else along) * c) / (1 / m2 + s * s / m1)
    T1 = m1 * along + T2 * c
    return om1, om2, (T2 * s / m1 - gravity * sin(th1)) / l1, -T1 * s / (m1 * l2)


def energy(state: ArrayLike, *, masses: Sequence[float], lengths: Sequence[float], gravity: float) -> float:
    """Energy, J; 0 when the pendulum hangs straight down at rest."""
    (m1, m2), (l1, l2) = _checked(masses, lengths, gravity)
    th1, th2, om1, om2 = numbers(4, state=state).tolist()
    v1, v2, d = l1 * om1, l2 * om2, th2 - th1
    height1, height2 = 2 * l1 * sin(th1 / 2) ** 2, 2 * l2 * sin(th2 / 2) ** 2
    kinetic = (m1 * v1**2 + m2 * (v1**2 + v2**2 + 2 * v1 * v2 * cos(d))) / 2
    return float(kinetic + gravity * (m1 * height1 + m2 * (height1 + height2)))


INVARIANTS = {"energy": energy}


def errors(method: str, steps: ArrayLike) -> tuple[Array, Array]:
    """Return (right, wrong), (n,) rad each: errors of the angles after half a second, by either equations.

    method : "Euler", "Heun" or "RK4"
    steps  : (n,) s, each at most 0.5; rounded to the nearest that makes a whole number of steps
    Errors are relative to the exact solution of the same equations, from START with the parameters of EXAMPLE.
    """
    if not isinstance(method, str) or method.lower() not in STAGES:
        raise ValueError(f"method: must be one of Euler, Heun, RK4, got {method!r}")
    weights, sizes = STAGES[method.lower()], numbers(steps=steps)
    if not ((sizes >= SHORTEST) & (sizes <= DURATION)).all():
        raise ValueError(f"steps: must be from {SHORTEST:g} to {DURATION:g} s, got {steps!r}")
    both = []
    for equations in (rates, wrong_rates):
        exact = solve(equations, [0.0, DURATION], START, parameters=EXAMPLE, rtol=1e-13)[-1]
        ends = [_stepped(equations, weights, round(DURATION / size)) for size in sizes]
        both.append(np.array([np.abs(end - exact)[:2].max() for end in ends]))
    return both[0], both[1]


def order(method: str, steps: ArrayLike) -> tuple[float, float]:
    """Return (right, wrong) observed orders of a method: slopes of log(error) over log(step), steps (n,), s, n >= 2."""
    correct, wrong = errors(method, steps)
    counts = np.rint(DURATION / numbers(steps=steps))
    return observed_order(DURATION / counts, correct), observed_order(DURATION / counts, wrong)


def _stepped(equations: Function, weights: Sequence[Sequence[float]], count: int) -> Array:
    """Return (4,) the state after `count` equal steps of an explicit Runge-Kutta method."""
    state, h = np.array(START), DURATION / count
    for _ in range(count):
        slopes: list[Array] = []
        for row in weights[:-1]:
            there = state + h * sum((w * k for w, k in zip(row, slopes, strict=True)), np.zeros(4))
            slopes.append(np.array(equations(0.0, there.tolist(), **EXAMPLE)))
        state = state + h * np.array(weights[-1]) @ slopes
    return state


def _checked(
    masses: Sequence[float], lengths: Sequence[float], gravity: float
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    nonnegative(gravity=gravity)
    return positives(2, masses=masses), positives(2, lengths=lengths)


film = drawn_for(convergence.film, globals())
