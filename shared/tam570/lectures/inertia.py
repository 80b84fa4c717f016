"""19 Oct: The moment of inertia matrix of a body, and its principal axes.

For a rigid body, the sum of r x m (omega x r) is I omega with I = sum of m (r.r 1 - r r^T), r from the centre of mass.
n.I n is the moment of inertia about the axis n. About a parallel axis at the arm d it is larger by m (d.d 1 - d d^T). I
is symmetric: there are three axes at right angles about which H is parallel to omega, and no moment of inertia exceeds
the sum of the other two (Goldstein, Classical Mechanics, sections 5.3 and 5.4). A body turned by R has R I R^T.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import SYMMETRIC, array, numbers, positive, positives, symmetric
from tam570.rotations import matrix_from_axis_angle
from tam570.show.plots import value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, arrow, frame_times, moving
from tam570.values import Parameters

EXAMPLE: Parameters = {  # m, kg
    "points": ((1.0, 0.3, 0.2), (-0.9, 0.4, 0.0), (0.2, -1.0, 0.3), (0.1, 0.5, -0.7), (-0.3, -0.3, 0.5)),
    "masses": (1.0, 1.5, 1.0, 2.0, 1.0),
}
SECONDS = 12.0


def inertia(points: ArrayLike, masses: Sequence[float]) -> Array:
    """Return (3, 3) kg m^2 about the centre of mass, of particles at `points` (n, 3), m, of `masses` (n,), kg."""
    m = np.array(positives(masses=masses))
    r = array((len(m), 3), points=points)
    return _moments(m, r - m @ r / m.sum())


def of_box(mass: float, size: Sequence[float]) -> Array:
    """Return (3, 3) kg m^2 of a uniform box about its centre; its sides (3,), m, are along the axes."""
    positive(mass=mass)
    squares = np.array(positives(3, size=size)) ** 2
    return np.diag(mass * (squares.sum() - squares) / 12)


def of_disk(mass: float, radius: float) -> Array:
    """Return (3, 3) kg m^2 of a uniform thin disk about its centre; its axle is z."""
    positive(mass=mass, radius=radius)
    return mass * radius**2 / 4 * np.diag([1.0, 1.0, 2.0])


def parallel_axis(I: ArrayLike, mass: float, arm: ArrayLike) -> Array:  # noqa: E741
    """Return (3, 3) kg m^2 about a point at `arm` (3,), m, from the centre of mass; I (3, 3) is about the latter."""
    positive(mass=mass)
    return symmetric((3, 3), I=I) + _moments(np.array([mass]), numbers(3, arm=arm)[None])


def principal(I: ArrayLike) -> tuple[Array, Array]:  # noqa: E741
    """Return (moments, axes): (3,) kg m^2, ascending, and (3, 3) whose columns are the axes, right-handed.

    Raise ValueError if I is not that of a body: not symmetric, a moment negative or above the sum of the other two.
    """
    moments, axes = np.linalg.eigh(symmetric((3, 3), I=I))
    rounding = SYMMETRIC * abs(moments[2])
    if moments[0] < -rounding or moments[2] > moments[0] + moments[1] + rounding:
        raise ValueError(f"I: no body has the principal moments of inertia {moments.tolist()}")
    axes[:, 2] *= np.sign(np.linalg.det(axes))
    return moments, axes


def _moments(m: Array, r: Array) -> Array:
    return (m @ (r**2).sum(axis=1)) * np.eye(3) - (m * r.T) @ r


def film(parameters: Parameters) -> Scene:
    """Return the scene of an axis that turns from one principal axis to the next; only on these H is along omega."""
    m = np.array(positives(masses=parameters["masses"]))
    matrix = inertia(parameters["points"], parameters["masses"])
    r = array((len(m), 3), points=parameters["points"])
    moments, axes = principal(matrix)
    times = frame_times(SECONDS)
    n = _round(times, axes)
    about = np.einsum("ni,ij,nj->n", n, matrix, n)
    H = n @ matrix
    aside = np.degrees(np.arctan2(np.linalg.norm(np.cross(H, n), axis=1), about))
    levels = {f"principal {i + 1}": np.full(len(times), moment) for i, moment in enumerate(moments)}
    reach = 1.3 * float(np.linalg.norm(r - m @ r / m.sum(), axis=1).max())
    return Scene(
        "Moments of inertia and principal axes",
        "Five particles are one rigid body. An axis through its centre of mass turns from each principal axis to the "
        "next. The angular momentum of a spin about it leans away from the axis, except on the principal ones.",
        times,
        [Panel([*_body(r - m @ r / m.sum(), m, n), *_arrows(axes, n, H, reach)], ruler=False)],
        [
            value_plot("moment of inertia about the axis", times, {"": about, **levels}, "kg m²"),
            value_plot("angle from the axis to H", times, {"": aside}, "degrees"),
        ],
        view=(0.6, 0.35),
        still_time=0.86,
    )


def _round(times: Array, axes: Array) -> Array:
    """Return (n, 3) a unit vector that turns from each principal axis to the next in a third of the time."""
    part = np.minimum((3 * times / times[-1]).astype(int), 2)
    angle = np.pi / 2 * (3 * times / times[-1] - part)
    first, last = axes.T[part], axes.T[(part + 1) % 3]
    R = matrix_from_axis_angle(np.cross(first, last), angle)
    return np.einsum("nij,nj->ni", R, first)


def _body(r: Array, m: Array, n: Array) -> list[Shape]:
    feet = np.einsum("ni,pi->np", n, r)[..., None] * n[:, None]
    arms = np.stack([feet, np.broadcast_to(r, feet.shape)], axis=2).reshape(len(n), -1, 3)
    sizes = 5 + 4 * m / m.max()
    dots = [Shape("dot", r[[i]], 0, "particles", width=float(size)) for i, size in enumerate(sizes)]
    return [Shape("lines", arms, GREY, "distances from the axis", width=1.5), *dots]


def _arrows(axes: Array, n: Array, H: Array, reach: float) -> list[Shape]:
    lines = reach * np.stack([axes.T, -axes.T], axis=1).reshape(6, 3)
    unit = 0.9 * reach / float(np.linalg.norm(H, axis=1).max())
    return [
        Shape("lines", lines, 4, "principal axes", width=1),
        *(Shape("text", reach * axis[None], 4, words=str(i + 1)) for i, axis in enumerate(axes.T)),
        Shape("lines", moving(-reach * n, reach * n), 1, "axis", width=3),
        arrow(np.zeros(3), unit * H, 2, "angular momentum H", 3),
    ]
