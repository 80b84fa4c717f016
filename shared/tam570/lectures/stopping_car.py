"""14 Sept: How fast a car stops, with its front wheels, its rear wheels, or both locked, found in three ways.

In the plane, x ahead, y up, per unit mass. Locked wheels slide with friction mu N against the motion; free ones roll
without any. Momentum and the moment about G are three equations for the deceleration d and the loads Nf, Nr:
d = mu (N of locked wheels), Nf + Nr = g, front Nf - rear Nr = height d. Moments about other points give simpler ones,
and about the point in which the forces of the ground meet a single one, for d alone. All hold while no axle lifts.
"""

import numpy as np

from tam570.arguments import nonnegative, one_of, positive
from tam570.show.scenes import drawn_for, stopping_car
from tam570.values import Parameters

EXAMPLE: Parameters = {  # m, m, m, -, m/s^2
    "height": 0.6,
    "front": 1.2,
    "rear": 1.5,
    "friction": 0.8,
    "gravity": 9.81,
    "locked": "both",
}
LOCKED = ("front", "rear", "both")
ROUNDING = 1e-12


def by_centre_of_mass(
    *, height: float, front: float, rear: float, friction: float, gravity: float, locked: str
) -> tuple[float, float, float]:
    """Return (deceleration, front_load, rear_load), m/s^2, by momentum and the moment about G: three messy equations.

    height, front, rear : of G above the ground, behind the front axle, ahead of the rear one, m
    friction            : coefficient
    locked              : "front", "rear" or "both"
    Raise ValueError if an axle would lift.
    """
    mu_f, mu_r = _checked(height, front, rear, friction, gravity, locked)
    equations = [[1.0, -mu_f, -mu_r], [0.0, 1.0, 1.0], [-height, front, -rear]]
    return _on_the_ground(*np.linalg.solve(equations, [0.0, gravity, 0.0]).tolist())


def by_three_points(
    *, height: float, front: float, rear: float, friction: float, gravity: float, locked: str
) -> tuple[float, float, float]:
    """Return the same by moments about both contacts, and a point over the front one, a wheelbase higher than G."""
    mu_f, mu_r = _checked(height, front, rear, friction, gravity, locked)
    base = front + rear
    arm = height + base  # of the friction about the third point
    equations = [[height, 0.0, base], [-height, base, 0.0], [base, -arm * mu_f, -arm * mu_r - base]]
    moments = [gravity * front, gravity * rear, -gravity * front]
    return _on_the_ground(*np.linalg.solve(equations, moments).tolist())


def by_one_point(
    *, height: float, front: float, rear: float, friction: float, gravity: float, locked: str
) -> tuple[float, float, float]:
    """Return the same by the moment about the point where the forces of the ground meet; then loads about the contacts.

    The force at a locked wheel leans back by its friction. It meets the free wheel's vertical force at a height of
    (front + rear)/friction above the ground if the front is locked, and as far below if the rear is. With both locked
    the two are parallel: the moment about a point at infinity is the force across them.
    """
    mu_f, mu_r = _checked(height, front, rear, friction, gravity, locked)
    base = front + rear
    both = locked == "both"
    arm, lean = (front, height * mu_r) if mu_r else (rear, -height * mu_f)
    deceleration = friction * gravity * (1.0 if both else arm / (base + lean))
    shift = height * deceleration
    return _on_the_ground(deceleration, (gravity * rear + shift) / base, (gravity * front - shift) / base)


def _checked(
    height: float, front: float, rear: float, friction: float, gravity: float, locked: str
) -> tuple[float, float]:
    """Return the friction coefficients of the front and the rear wheels; check every argument."""
    nonnegative(height=height, front=front, rear=rear, friction=friction)
    positive(**{"gravity": gravity, "front and rear, together": front + rear})
    one_of(LOCKED, locked=locked)
    mu_f, mu_r = (friction if locked in (axle, "both") else 0.0 for axle in ("front", "rear"))
    lever = mu_f * height
    if lever > front * (1 + ROUNDING) or (locked == "front" and lever >= front + rear):
        raise ValueError(f"the rear axle lifts: friction times height, {lever:g} m, reaches over front, {front:g} m")
    return mu_f, mu_r


def _on_the_ground(deceleration: float, front_load: float, rear_load: float) -> tuple[float, float, float]:
    """Return the same, with 0 for a load that rounding makes negative."""
    return deceleration, max(front_load, 0.0), max(rear_load, 0.0)


film = drawn_for(stopping_car.film, globals())
