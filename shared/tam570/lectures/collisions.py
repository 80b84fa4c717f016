"""28 Nov: Frictionless collisions of two rigid bodies in the plane.

The impulse J acts along the common normal n, on the second body, and -J n on the first. With the arms r from the
centres of mass to the contact, the relative velocity along n changes by J/mu, 1/mu = 1/m1 + 1/m2 + (r1 x n)^2/I1 + (r2
x n)^2/I2, and by Newton's law they separate at `restitution` times the speed at which they approached: J = (1 + e) mu
v. The loss is (1 - e^2) mu v^2/2. A body of infinite mass and inertia is a wall.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import array, numbers
from tam570.show.scene import Array
from tam570.show.scenes import collisions, drawn_for

EXAMPLE = {"restitution": 0.95}
PARTED = 1e-12  # of the speeds at the contact: rounding of bodies that stay together
SETTLED = 1e-14  # of the largest speed: an approach below this is rounding


def collide(
    velocities: ArrayLike,
    normal: ArrayLike,
    arms: ArrayLike,
    *,
    masses: Sequence[float],
    inertias: Sequence[float],
    restitution: float,
) -> tuple[Array, float]:
    """Return velocities after the collision (2, 3), and the impulse, N s, on the second body along the normal.

    velocities : (2, 3) vx, vy, m/s, and om, rad/s, of both bodies
    normal     : (2,) from the first body to the second, of any length but 0
    arms       : (2, 2) m, from each centre of mass to the contact
    masses, inertias : (2,) kg and kg m^2; either may be infinite
    Raise ValueError if the bodies separate, or neither can move.
    """
    before, r = array((2, 3), velocities=velocities), array((2, 2), arms=arms)
    along = numbers(2, normal=normal)
    size = float(np.hypot(*along))
    if size == 0.0:
        raise ValueError("normal: must not be 0")
    n = along / size
    _check_restitution(restitution)
    turns = r[:, 0] * n[1] - r[:, 1] * n[0]
    ways = np.column_stack([[n, n], turns]) * [[-1.0], [1.0]]  # m vx, m vy, I om of a unit impulse
    softness = ways * np.column_stack([_inverse(masses=masses)] * 2 + [_inverse(inertias=inertias)])
    approach = -float(np.sum(ways * before))
    if approach < -PARTED * float(np.abs(ways * before).sum()):
        raise ValueError(f"velocities: the bodies separate already, at {-approach:g} m/s")
    compliance = float(np.sum(ways * softness))  # 1/kg
    if compliance == 0.0:
        raise ValueError("masses, inertias: one of the bodies must be able to give way")
    impulse = (1.0 + restitution) * max(approach, 0.0) / compliance
    return before + impulse * softness, impulse


def cradle(speeds: ArrayLike, *, restitution: float) -> Array:
    """Return (n,) m/s after all collisions of equal balls that touch in a row, left to right; speeds (n,) to the right.

    They collide in pairs, one pair after the other, until no ball approaches the next.
    """
    now = numbers(speeds=speeds)
    _check_restitution(restitution)
    nothing, smallest = np.zeros((2, 2)), SETTLED * float(np.abs(now).max(initial=0.0))
    while (np.diff(now) < -smallest).any():
        for i in range(len(now) - 1):
            if now[i] > now[i + 1]:
                pair = np.array([[now[i], 0.0, 0.0], [now[i + 1], 0.0, 0.0]])
                equal = {"masses": (1.0, 1.0), "inertias": (1.0, 1.0)}
                after, _ = collide(pair, [1.0, 0.0], nothing, **equal, restitution=restitution)
                now[i : i + 2] = after[:, 0]
    return now


def _inverse(**values: ArrayLike) -> Array:
    """Return (2,) one over each value, 0 for infinity. Raise ValueError unless both are positive."""
    ((name, value),) = values.items()
    try:
        pair = np.array(value, dtype=float)
    except (TypeError, ValueError):
        pair = np.array([])
    if pair.shape != (2,) or not (pair > 0).all():
        raise ValueError(f"{name}: must be two positive numbers, which may be infinite, got {value!r}")
    return 1.0 / pair


def _check_restitution(restitution: float) -> None:
    if not isinstance(restitution, float | int | np.floating | np.integer) or not 0.0 <= restitution <= 1.0:
        raise ValueError(f"restitution: must be from 0 to 1, got {restitution!r}")


film = drawn_for(collisions.film, globals())
