"""5 Oct: Two rotations after each other are one, by a triangle on the unit sphere.

A rotation vector is the axis times the angle. Draw the axes A of the first turn and B of the second on the sphere, and
the great circle through them. Swing it about A by minus half of the first angle, and about B by half of the second: the
two arcs meet at the axis C of the composed turn (Rodrigues, 1840; Hamilton, 1844). For two mirrors through A make the
first turn and two through B the second, and the mirror AB that both share cancels. The law of cosines of the triangle
gives half the angle: cos(c/2) = cos(a/2) cos(b/2) - sin(a/2) sin(b/2) A . B. The sum of the vectors is another turn.
"""

from math import atan2, cos, hypot, pi, sin

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import numbers
from tam570.rotations import exp
from tam570.show.drawing import circle, solid
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times
from tam570.values import Parameters

EXAMPLE: Parameters = {"first": (0.0, 0.0, 1.6), "second": (1.2, 0.3, 0.0)}  # rad
SECONDS = 9.0  # of the scene


def compose(first: ArrayLike, second: ArrayLike) -> Array:
    """Return (3,) the rotation vector of the turn by `first` and then by `second`, its angle in [0, pi].

    first, second : (3,) rotation vectors in space, rad, of any length
    """
    (cos_a, sin_a), (cos_b, sin_b) = _half(numbers(3, first=first)), _half(numbers(3, second=second))
    cosine = cos_a * cos_b - float(sin_a @ sin_b)
    sines = cos_b * sin_a + cos_a * sin_b + np.cross(sin_b, sin_a)  # sin(c/2) C
    size = hypot(*sines)
    if size == 0.0:
        return np.zeros(3)
    half = atan2(size, abs(cosine))  # if the cosine is negative, of the turn in the opposite direction
    return np.copysign(2.0 * half / size, cosine) * sines


def _half(vector: Array) -> tuple[float, Array]:
    """Return the cosine of half the angle, and its sine times the axis; hypot does not underflow for tiny vectors."""
    angle = hypot(*vector)
    return cos(angle / 2), vector * (sin(angle / 2) / angle if angle else 0.5)


def film(parameters: Parameters) -> Scene:
    """Return the scene of a mark that turns twice, then of one that makes the single turn from the triangle."""
    first, second = (numbers(3, **{name: parameters[name]}) for name in ("first", "second"))
    both = compose(first, second)
    times = frame_times(SECONDS)
    u = np.clip(3 * times / SECONDS - np.arange(3)[:, None], 0.0, 1.0)[..., None]  # progress in each third
    one_by_one = exp(u[1] * second) @ exp(u[0] * first)
    direct = exp(u[2] * both)
    corners = [_unit(vector) for vector in (first, second, both)]
    shapes = [
        *(
            Shape("path", circle(np.zeros(3), *np.delete(np.eye(3), i, axis=0)), GREY, width=1, faint=True)
            for i in range(3)
        ),
        *(Shape("arrow", np.array([np.zeros(3), 1.25 * corner]), GREY, width=2) for corner in corners),
        *(Shape("text", 1.33 * corner[None], INK, words=name) for name, corner in zip("ABC", corners, strict=True)),
        *(Shape("path", _arc(corners[i - 1], corners[i]), 3, "triangle of half angles", width=3) for i in (1, 2, 0)),
        *_trail(one_by_one, 0, "about A, then about B"),
        *_trail(direct, 1, "once about C"),
    ]
    return Scene(
        "Two rotations are one",
        "On a sphere a mark turns about the axis A, then about B. Another mark then turns about C alone and comes to "
        "the same place. C is the corner of a triangle whose angles are half the angles of the turns. "
        f"Here the turn about C is one of {np.degrees(hypot(*both)):.1f} degrees.",
        times,
        [Panel(shapes, ruler=False)],
        still_time=0.85,
    )


def _unit(vector: Array) -> Array:
    size = hypot(*vector)
    return vector / size if size else np.array([0.0, 0.0, 1.0])


def _arc(start: Array, end: Array) -> Array:
    """Return (n, 3) the shorter great circle from one point to another."""
    angle = atan2(hypot(*np.cross(start, end)), start @ end)
    if min(angle, pi - angle) < 1e-6:  # equal or opposite points
        return np.array([start, end])
    s = np.linspace(0.0, 1.0, 31)[:, None]
    return (np.sin((1 - s) * angle) * start + np.sin(s * angle) * end) / sin(angle)


def _trail(rotations: Array, color: int, name: str) -> list[Shape]:
    """Return a mark on the sphere with its trail, and the triangle between it and two more points of the body."""
    points = np.array([[0.85, -0.45, 0.27], [0.65, -0.55, 0.52], [0.92, -0.2, 0.33]])
    points = points / np.linalg.norm(points, axis=1)[:, None]
    turned = points @ np.swapaxes(rotations, 1, 2)
    return [*solid(turned, color, name, 3), Shape("trail", turned[:, :1], color, width=2)]
