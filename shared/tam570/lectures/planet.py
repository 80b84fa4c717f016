"""31 Aug: A planet that the sun attracts, and Newton's polygon of impulses.

The sun is the origin of space. r'' = -gm r/|r|^3 with gm = G times the sun's mass. Bound orbits are ellipses with the
sun at a focus; Kepler's equation E - e sin E = 2 pi (t - t_near)/period gives the planet's place on one. Newton
(Principia, book I, proposition 1) lets the planet move straight on for equal times, with an impulse towards the sun at
the end of each: equal areas follow from the direction of the impulses alone.
"""

from collections.abc import Sequence
from math import atan2, hypot, inf, nan, pi, sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import numbers, positive, sequence
from tam570.show.scene import Array
from tam570.show.scenes import drawn_for, planet

STATE = {"x": "m", "y": "m", "z": "m", "vx": "m/s", "vy": "m/s", "vz": "m/s"}
EXAMPLE = {"gm": 1.0}  # m^3/s^2
START = (1.5, 0.0, 0.0, 0.0, 0.6, 0.2)
SECONDS = 14.0


def rates(t: float, state: Sequence[float], *, gm: float) -> tuple[float, ...]:
    """Return (6,) velocity, m/s, and acceleration, m/s^2."""
    positive(gm=gm)
    sequence(6, state=state)
    x, y, z, vx, vy, vz = state
    square = x * x + y * y + z * z
    try:
        pull = -gm / (square * sqrt(square))  # 1/s^2
    except ZeroDivisionError:  # in the sun, where a trial step may end
        pull = nan
    return vx, vy, vz, pull * x, pull * y, pull * z


def energy(state: ArrayLike, *, gm: float) -> float:
    """Energy of a planet of 1 kg, J; 0 far away and at rest."""
    r, v = _halves(state, gm)
    return float(v @ v / 2 - gm / np.sqrt(r @ r))


def angular_momentum(state: ArrayLike, *, gm: float) -> Array:
    """Angular momentum of a planet of 1 kg about the sun, (3,) kg m^2/s."""
    r, v = _halves(state, gm)
    return np.cross(r, v)


def laplace_runge_lenz(state: ArrayLike, *, gm: float) -> Array:
    """Vector v x (r x v)/gm - r/|r|, (3,): it points to the perihelion, and its length is the eccentricity."""
    r, v = _halves(state, gm)
    return np.cross(v, np.cross(r, v)) / gm - r / np.linalg.norm(r)


INVARIANTS = {"energy": energy, "angular_momentum": angular_momentum, "laplace_runge_lenz": laplace_runge_lenz}


def elements(state: ArrayLike, *, gm: float) -> dict[str, float]:
    """Return semi_major_axis, m, eccentricity, and period, s; of an unbound orbit inf and an axis below zero or inf."""
    total = energy(state, gm=gm)
    axis = -gm / (2 * total) if total else inf
    period = 2 * pi * axis * sqrt(axis / gm) if total < 0 else inf
    eccentricity = float(np.linalg.norm(laplace_runge_lenz(state, gm=gm)))
    return {"semi_major_axis": axis, "eccentricity": eccentricity, "period": period}


def exact(t: ArrayLike, state: ArrayLike, *, gm: float) -> Array:
    """Return (n, 6) states at the times t (n,), s, of the bound orbit that has `state` at t[0], by Kepler's equation.

    By the functions f and g of Gauss, r = f r0 + g v0. Raise ValueError if the orbit is unbound or falls into the sun.
    """
    times, (r0, v0) = numbers(t=t), _halves(state, gm)
    orbit = elements(state, gm=gm)
    a, distance, fall = orbit["semi_major_axis"], float(np.linalg.norm(r0)), float(r0 @ v0)
    if not (0.0 < a < inf and orbit["eccentricity"] < 1.0 and np.cross(r0, v0).any()):
        raise ValueError(f"state: no ellipse at gm = {gm:g}, the eccentricity is {orbit['eccentricity']:g}")
    n = sqrt(gm / a) / a  # rad/s
    e_cos, e_sin = 1.0 - distance / a, fall / (n * a * a)  # of E at t[0]
    e, first = hypot(e_cos, e_sin), atan2(e_sin, e_cos)
    anomaly = _eccentric_anomaly(first - e_sin + n * (times - times[:1]), e)
    c, s = np.cos(anomaly - first), np.sin(anomaly - first)
    r = a * (1.0 - e * np.cos(anomaly))  # the distance
    f, g = 1.0 - a / distance * (1.0 - c), (fall / (n * n * a) * (1.0 - c) + distance / n * s) / a
    f_rate, g_rate = -n * a * a / (r * distance) * s, 1.0 - a / r * (1.0 - c)
    return np.hstack([np.outer(f, r0) + np.outer(g, v0), np.outer(f_rate, r0) + np.outer(g_rate, v0)])


def _eccentric_anomaly(mean: Array, e: float) -> Array:
    """Solve E - e sin E = mean for E by Newton's method, which descends to the root from above, for every e < 1."""
    turns = 2 * pi * np.round(mean / (2 * pi))
    sign, part = np.sign(mean - turns), np.abs(mean - turns)  # part is in [0, pi], where E - e sin E is convex
    E = np.minimum(part + e, pi)
    for _ in range(100):
        step = (E - e * np.sin(E) - part) / (1.0 - e * np.cos(E))
        E = E - step
        if np.abs(step).max(initial=0.0) < 1e-16:
            break
    return turns + sign * E


def _halves(state: ArrayLike, gm: float) -> Array:
    """Return (2, 3) position and velocity."""
    positive(gm=gm)
    halves: Array = numbers(6, state=state).reshape(2, 3)
    if halves.dtype != object and not halves[0].any():
        raise ValueError("state: the planet is where the sun is")
    return halves


film = drawn_for(planet.film, globals())
