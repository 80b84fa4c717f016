"""24 Oct, 9 Nov: Hamilton's principle: a pendulum takes the path of least action, at first.

Angles from straight down, action per unit mass: the integral of l^2 th'^2/2 + g l cos(th), with the potential energy
from the hinge. On a path of n even times it becomes a sum of (difference)^2 l^2/(2 h) + h g l cos(th), where both ends
count half. Its minimum obeys the difference equation of Stoermer and Verlet, with an error of order h^2 (Marsden and
West, Discrete mechanics and variational integrators, Acta Numerica 2001). Its second variation -th'' - (g/l) cos(th)
is positive for all neighbours only until half a period of a small swing has passed (Jacobi).
"""

from math import copysign, pi, sin, sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import finite, nonnegative, numbers, positive, whole_number
from tam570.show.scene import Array
from tam570.show.scenes import drawn_for, least_action

EXAMPLE = {"a": 0.3, "b": 0.5, "duration": 2.6, "points": 241, "length": 10.0, "gravity": 9.81}  # rad, s, 1, m, m/s^2
FINISHED = 1e-11  # rad: a Newton step after which the next would be rounding
ROUNDING = 1e-15  # of a derivative's terms; near half a period the action is too flat for a test of the step
ITERATIONS = 500
SOLVED = 1e-9  # rad: error of the angles of a motion that was solved for
MOTION = 0.05  # of the largest angular acceleration: the error up to which a path counts as a motion


def path(a: float, b: float, duration: float, *, points: int, length: float, gravity: float) -> Array:
    """Return (points,) angles, rad, at even times from 0 to duration, s, from a to b, of locally least action.

    Newton's method is damped until the action decreases. A bump of 0.001 rad in the first guess breaks the symmetry.
    """
    finite(a=a, b=b)
    whole_number(2, points=points)
    share = np.linspace(0.0, 1.0, points)
    angles = a + (b - a) * share + 1e-3 * np.sin(pi * share)
    angles[-1] = b
    scene = {"duration": duration, "length": length, "gravity": gravity}
    for _ in range(ITERATIONS if points > 2 else 0):
        step = _descent(angles, **scene)
        angles[1:-1] += step
        slope, diagonal = _variations(angles, duration / (points - 1), length, gravity)
        if np.abs(step).max() < FINISHED or np.abs(slope).max() < ROUNDING * diagonal.max() * np.abs(angles).max():
            return angles
    if points > 2:
        raise ArithmeticError(f"duration: no path of least action is found for {duration!r} s")
    return angles


def action(path: ArrayLike, duration: float, *, length: float, gravity: float) -> float:
    """Return the action per unit mass, m^2/s, of angles (n,), rad, at even times over duration, s."""
    angles, h = _path(path, duration, length, gravity)
    kinetic = length**2 * np.sum(np.diff(angles) ** 2) / (2 * h)
    return float(kinetic + h * gravity * length * (np.cos(angles).sum() - (np.cos(angles[0]) + np.cos(angles[-1])) / 2))


def is_minimum(path: ArrayLike, duration: float, *, length: float, gravity: float) -> bool:
    """Return whether a path (n,), rad, is a motion and every neighbour with the same ends has more action."""
    angles, h = _path(path, duration, length, gravity)
    if len(angles) == 2:
        return True
    slope, _ = _variations(angles, h, length, gravity)
    turning = np.abs(np.diff(angles, 2)) / h**2 + (gravity / length) * np.abs(np.sin(angles[1:-1]))
    motion = np.abs(slope).max() / (h * length**2) <= MOTION * turning.max() + SOLVED / h**2
    return bool(motion and _newton(angles, h, length, gravity, 0.0) is not None)


def _path(path: ArrayLike, duration: float, length: float, gravity: float) -> tuple[Array, float]:
    """Return the angles and the time between two of them; check every argument."""
    positive(duration=duration, length=length)
    finite(gravity=gravity)
    angles = numbers(path=path)
    if len(angles) < 2:
        raise ValueError(f"path: must have both ends at least, got {angles}")
    return angles, duration / (len(angles) - 1)


def _variations(angles: Array, h: float, length: float, gravity: float) -> tuple[Array, Array]:
    """Return the first derivatives of the action by the inner angles, and the diagonal of the second ones."""
    inner, weight = angles[1:-1], h * gravity * length
    slope = -(length**2 / h) * np.diff(angles, 2) - weight * np.sin(inner)
    return slope, 2 * length**2 / h - weight * np.cos(inner)


def _newton(angles: Array, h: float, length: float, gravity: float, damping: float) -> Array | None:
    """Return Newton's step of the inner angles; None if the action, with the damping, is not convex here."""
    slope, diagonal = _variations(angles, h, length, gravity)
    step, least = _eliminated(diagonal + damping, -(length**2) / h, -slope)
    return step if least > 0 else None


def _eliminated(diagonal: Array, beside: float, rhs: Array) -> tuple[Array, float]:
    """Solve a symmetric tridiagonal system with equal numbers beside its diagonal; also return the least pivot."""
    rows = [(1.0, 0.0)]
    for d, r, near in zip(diagonal.tolist(), rhs.tolist(), [0.0] + [beside] * len(rhs), strict=False):
        pivot, before = rows[-1]
        rows.append((d - near * near / pivot, r - near * before / pivot))
    solution = [0.0]
    for pivot, r in rows[:0:-1]:
        solution.append((r - beside * solution[-1]) / pivot)
    return np.array(solution[:0:-1]), min(pivot for pivot, _ in rows[1:])


def _descent(angles: Array, *, duration: float, length: float, gravity: float) -> Array:
    """Return the step with the least damping that decreases the action."""
    angles, h = _path(angles, duration, length, gravity)
    now = action(angles, duration, length=length, gravity=gravity)
    rounding = 1e-14 * (abs(now) + abs(gravity) * length * duration)
    damping = 0.0
    while True:
        step = _newton(angles, h, length, gravity, damping)
        if step is not None:
            changed = np.concatenate([angles[:1], angles[1:-1] + step, angles[-1:]])
            if action(changed, duration, length=length, gravity=gravity) <= now + rounding:
                return step
        damping = 4 * damping or 1e-13 * length**2 / h


def swing(path: ArrayLike, duration: float, *, length: float, gravity: float) -> Array:
    """Return (n,) rad, the motion nearest to the small swing between the same ends, of least action or not."""
    angles, h = _path(path, duration, length, gravity)
    nonnegative(gravity=gravity)
    w, times = sqrt(gravity / length), np.linspace(0.0, duration, len(angles))
    a, b = angles[0], angles[-1]
    wave = sin(w * duration)
    size = copysign(max(abs(wave), 0.05), wave)  # at half a period the small swing would be infinite
    motion: Array = (a * np.sin(w * (duration - times)) + b * np.sin(w * times)) / size
    motion[[0, -1]] = a, b
    for _ in range(20):
        slope, diagonal = _variations(motion, h, length, gravity)
        motion[1:-1] += _eliminated(diagonal, -(length**2) / h, -slope)[0]
    return motion


film = drawn_for(least_action.film, globals())
