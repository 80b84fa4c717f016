"""19, 21 Sept: Chaplygin's sleigh, a body on ice with one blade that cannot slip sideways.

x, y of the blade, the heading from x, the speed u of the blade along it, the yaw rate om. G is `offset` = a ahead of
the blade, so its acceleration along the body is u' - a om^2. No force acts in this direction: u' = a om^2. About the
blade the blade's force has no moment: (I + m a^2) om' + m a u om = 0. With k^2 = (I + m a^2)/m and the energy's speed
V^2 = u^2 + k^2 om^2 the solution is u = V tanh s, om = (V/k) sech s, s' = a V/k^2: in the end the sleigh goes straight
with G in front, turned by pi k/a at most (Chaplygin, 1911; Neimark and Fufaev, Dynamics of Nonholonomic Systems).
"""

from collections.abc import Sequence
from math import asinh, copysign, cos, hypot, pi, sin, sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import finite, numbers, positive, sequence
from tam570.show.scene import Array
from tam570.show.scenes import drawn_for, sleigh

STATE = {"x": "m", "y": "m", "heading": "rad", "speed": "m/s", "yaw_rate": "rad/s"}
EXAMPLE = {"mass": 1.0, "inertia": 0.1, "offset": 0.4}  # kg, kg m^2, m
START = (0.0, 0.0, 0.0, -1.0, 0.02)
SECONDS = 7.0
STRAIGHT = 40.0  # |s| from which tanh and sech are 1 and 0 to rounding
NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)


def rates(t: float, state: Sequence[float], *, mass: float, inertia: float, offset: float) -> tuple[float, ...]:
    """Return (5,) velocity of the blade, m/s, yaw rate, rad/s, and rates of speed, m/s^2, and yaw rate, rad/s^2."""
    square = gyration(mass, inertia, offset) ** 2
    sequence(5, state=state)
    _, _, heading, speed, yaw_rate = state
    across = offset * yaw_rate
    return speed * cos(heading), speed * sin(heading), yaw_rate, across * yaw_rate, -across * speed / square


def energy(state: Sequence[float], *, mass: float, inertia: float, offset: float) -> float:
    """Kinetic energy, J."""
    k = gyration(mass, inertia, offset)
    _, _, _, speed, yaw_rate = map(float, numbers(5, state=state))
    return mass * (speed * speed + (k * yaw_rate) ** 2) / 2


INVARIANTS = {"energy": energy}


def straight_growth_rate(speed: float, *, mass: float, inertia: float, offset: float) -> float:
    """Return the rate, 1/s, in exp(rate t), with which a small yaw rate grows in straight motion at `speed`."""
    finite(speed=speed)
    k = gyration(mass, inertia, offset)
    return -offset * speed / k**2


def exact(t: ArrayLike, state: ArrayLike, *, mass: float, inertia: float, offset: float) -> Array:
    """Return (n, 5) states at the times t (n,), s, of the motion that has `state` at t[0].

    Heading, speed and yaw rate are closed forms; the position is their integral, by Gauss's rule to rounding.
    """
    k = gyration(mass, inertia, offset)
    times, start = numbers(t=t), numbers(5, state=state)
    since = times - times[:1]
    if offset == 0.0 or start[4] == 0.0:
        return _in_a_circle(since, start)
    ends = np.unique(np.concatenate([since, _panels(since, start, k, offset)]))
    middles, halves = (ends[1:] + ends[:-1]) / 2, np.diff(ends) / 2
    heading, speed, _ = _turned((middles[:, None] + halves[:, None] * NODES).ravel(), start, k, offset)
    steps = [halves * ((speed * wave(heading)).reshape(-1, len(NODES)) @ WEIGHTS) for wave in (np.cos, np.sin)]
    path = np.concatenate([[[0.0, 0.0]], np.cumsum(np.transpose(steps), axis=0)])
    at = np.searchsorted(ends, since)
    return np.column_stack([start[:2] + path[at] - path[at[:1]], *_turned(since, start, k, offset)])


def _in_a_circle(since: Array, start: Array) -> Array:
    x, y, heading, speed, yaw_rate = start
    turned = yaw_rate * since
    chord, middle = speed * since * np.sinc(turned / (2 * pi)), heading + turned / 2
    path = x + chord * np.cos(middle), y + chord * np.sin(middle)
    return np.column_stack([*path, heading + turned, *np.broadcast_arrays(speed, yaw_rate, since)[:2]])


def _turned(since: Array, start: Array, k: float, offset: float) -> tuple[Array, Array, Array]:
    """Return (n,) heading, speed, yaw rate. The heading is the difference of two gudermannians, by its half angle."""
    V, first = _shape(start, k)
    grown = offset * V / k**2 * since
    sign, size = np.sign(grown), np.abs(grown)
    half = sign * -np.expm1(-size) / (np.exp(sign * first) + np.exp(-sign * first - size))
    way = copysign(1.0, start[4])
    s = np.clip(first + grown, -700.0, 700.0)  # beyond, cosh overflows
    return start[2] + way * 2 * k / offset * np.arctan(half), V * np.tanh(s), way * V / k / np.cosh(s)


def _panels(since: Array, start: Array, k: float, offset: float) -> Array:
    """Return times between which the path bends by no more than a radian or two."""
    V, first = _shape(start, k)
    bends = sorted((side * STRAIGHT - first) * k**2 / (offset * V) for side in (-1, 1))
    low, high = np.clip(bends, since.min(initial=0.0), since.max(initial=0.0))
    return np.linspace(low, high, 2 + int((high - low) * (V / k + abs(offset) * V / k**2)))


def _shape(start: Array, k: float) -> tuple[float, float]:
    """Return V, and s at the start."""
    return hypot(start[3], k * start[4]), asinh(start[3] / (k * abs(start[4])))


def gyration(mass: float, inertia: float, offset: float) -> float:
    """Return k, m, the radius of gyration about the blade."""
    positive(mass=mass, inertia=inertia)
    finite(offset=offset)
    return sqrt(inertia / mass + offset * offset)


film = drawn_for(sleigh.film, globals())
