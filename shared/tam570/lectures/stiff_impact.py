"""28 Nov: A collision as the limit of a stiff spring, and what two contacts leave open.

x is the height of a ball over a floor that yields like a spring: below 0 it pushes with -k x, above not at all; m v' =
-m g + push. It pushes a ball that hits it at the speed v for 2 (pi - atan(w v/g))/w, w = sqrt(k/m), with the impulse
2 m v + m g times this duration. A stiffer floor pushes for a shorter time, as 1/sqrt(k), until the weight's part is
negligible and 2 m v is left. With two contacts there is no such limit: how a rod that falls level on two springs
leaves them depends on their ratio, however stiff both are. If the rod is rigid only before and after (weak rigidity),
the balances leave one number unknown; if it is rigid throughout, with springs at its contacts (strong rigidity), they
leave none (Chatterjee and Ruina, Journal of Applied Mechanics 65, 1998).
"""

from collections.abc import Sequence
from math import atan2, pi, sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import nonnegative, numbers, positive, positives, sequence
from tam570.integrate import solve
from tam570.show.scene import Array
from tam570.show.scenes import drawn_for, stiff_impact

STATE = {"x": "m", "v": "m/s"}
EXAMPLE = {"mass": 1.0, "stiffness": 400.0, "gravity": 9.81}  # kg, N/m, m/s^2
START = (0.0, -2.5)
SECONDS = 2.0


def rates(t: float, state: Sequence[float], *, mass: float, stiffness: float, gravity: float) -> tuple[float, float]:
    """Return (2,) v, m/s, and v', m/s^2."""
    _check(mass, stiffness, gravity)
    sequence(2, state=state)
    x, v = state
    return v, stiffness / mass * (abs(x) - x) / 2 - gravity


def push(state: ArrayLike, *, mass: float, stiffness: float, gravity: float) -> float:
    """Return the force of the floor on the ball, N."""
    _check(mass, stiffness, gravity)
    return stiffness * max(-float(numbers(2, state=state)[0]), 0.0)


def energy(state: ArrayLike, *, mass: float, stiffness: float, gravity: float) -> float:
    """Energy, J: kinetic, potential from x = 0, and that of the floor."""
    _check(mass, stiffness, gravity)
    x, v = numbers(2, state=state).tolist()
    return float(mass * (v**2 / 2 + gravity * x) + stiffness * ((x - abs(x)) / 2) ** 2 / 2)


INVARIANTS = {"energy": energy}


def rebound(stiffness: float, *, mass: float, speed: float, gravity: float) -> tuple[float, float]:
    """Return (impulse, duration), N s and s, of the floor on a ball that hits it and leaves it at `speed`, m/s."""
    _check(mass, stiffness, gravity)
    positive(speed=speed)
    w = sqrt(stiffness / mass)
    duration = 2 * (pi - atan2(w * speed, gravity)) / w
    return 2 * mass * speed + mass * gravity * duration, duration


def two_contacts(
    stiffnesses: Sequence[float], *, mass: float, inertia: float, arms: Sequence[float], speed: float
) -> tuple[Array, Array]:
    """Return the motion of a rod after it has fallen level on two springs at `speed`, m/s, and their impulses.

    stiffnesses : (2,) N/m; only their ratio matters
    inertia     : about the centre of mass G, kg m^2
    arms        : (2,) m, from G to the contacts along the rod, to the right positive
    Returns (2,) the speed of G upwards, m/s, and the yaw rate, rad/s; and (2,) N s.
    """
    states = rod_states(stiffnesses, mass=mass, inertia=inertia, arms=arms, speed=speed)
    return states[-1, 2:4], states[-1, 4:]


def rod_states(
    stiffnesses: Sequence[float], *, mass: float, inertia: float, arms: Sequence[float], speed: float
) -> Array:
    """Return (n, 6) y, angle, their rates and the impulses so far, from the first touch until both contacts part."""
    positive(mass=mass, inertia=inertia, speed=speed)
    pair, (a, b) = positives(2, stiffnesses=stiffnesses), numbers(2, arms=arms).tolist()
    stiff, other = (stiffness / max(pair) * mass for stiffness in pair)  # scaled: the larger over the mass is 1/s^2

    def falling(t: float, state: Sequence[float]) -> tuple[float, ...]:
        y, angle, up, turning, _, _ = state
        first, second = y + a * angle, y + b * angle
        p, q = stiff * (abs(first) - first) / 2, other * (abs(second) - second) / 2
        return up, turning, (p + q) / mass, (a * p + b * q) / inertia, p, q

    seconds, softest = 1.0, min(stiff, other) / mass
    while True:
        seconds *= 2.0
        states = solve(falling, np.linspace(0.0, seconds, 801), [0.0, 0.0, -speed, 0.0, 0.0, 0.0], rtol=1e-11)
        gaps, parting = (states[:, [i]] + states[:, [i + 1]] * [a, b] for i in (0, 2))
        separated = (gaps >= 0.0).all(axis=1) & (parting >= 0.0).all(axis=1)
        if separated.any():
            return states[: int(separated.argmax()) + 1]
        if seconds > 1e3 / sqrt(softest):
            raise ArithmeticError("the rod does not leave both contacts")


def _check(mass: float, stiffness: float, gravity: float) -> None:
    positive(mass=mass, stiffness=stiffness)
    nonnegative(gravity=gravity)


film = drawn_for(stiff_impact.film, globals())
