"""hw09: the book, turned about z and x in both orders, and the axis of the total rotation."""

import math
from functools import partial

import numpy as np

from tam570.arguments import positives
from tam570.invariants import rotation_defect
from tam570.show.drawing import axes, box_face
from tam570.show.plots import gap_caption, value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, TimePlot, frame_times
from tam570.show.student import StudentModule
from tam570.values import Parameters

EXAMPLE = {"size": (1.2, 1.8, 0.3)}  # m
ORDERS = {"(a) about z, then about x": "zx", "(b) about x, then about z": "xz"}
BEGINS, LASTS = (0.7, 2.7), 1.5  # s, when a turn begins and how long it lasts
SECONDS = 5.5
LARGE = 1e-9


def film(student: StudentModule, parameters: Parameters) -> Scene:
    """Return the scene of both orders side by side; the axes are fixed in space."""
    times, size = frame_times(SECONDS), np.array(positives(3, size=parameters["size"]))
    turned = {title: _turns(student, times, order) for title, order in ORDERS.items()}
    before = student("book_edges", np.eye(3), size=size).reshape(24, 3)
    panels = []
    for i, (title, rotations) in enumerate(turned.items()):
        edges = student.each("book_edges", rotations, size=size).reshape(-1, 24, 3)
        shapes = [
            *axes(1.3),
            Shape("lines", before, GREY, "before", width=1.5),
            Shape("fill", box_face(rotations, size), i, faint=True),
            Shape("lines", edges, i, f"book ({'ab'[i]})", width=2.5),
            *student.make_each(partial(_axis, student, rotations[-1])),
        ]
        panels.append(Panel(shapes, title, ruler=False))
    return Scene(
        "Finite rotations of a book",
        "Two books turn by 90 degrees about two axes fixed in space, in opposite orders, and end in different "
        "positions. Drawn through each is the axis about which one turn would bring it there.",
        times,
        panels,
        [_angles(times, turned)],
        still_time=1.0,
    )


def _turns(student: StudentModule, times: Array, order: str) -> Array:
    """Return (n, 3, 3) rotations, first about one axis, then about the other."""
    shares = [np.clip((times - begin) / LASTS, 0.0, 1.0) for begin in BEGINS]
    angles = [math.pi / 2 * share**2 * (3.0 - 2.0 * share) for share in shares]  # from rest to rest
    steps = [list(zip(order, pair, strict=True)) for pair in zip(*angles, strict=True)]
    return student.each("space_sequence", steps)


def _axis(student: StudentModule, R: Array) -> Shape:
    n, _ = student("axis_angle", R)
    return Shape("arrow", 1.4 * np.array([-n, n]), 2, "axis of the whole turn, by axis_angle()", width=2.5)


def _angles(times: Array, turned: dict[str, Array]) -> TimePlot:
    largest = float(rotation_defect([*turned.values()]).max())
    caption = gap_caption(largest, LARGE, about="RᵀR - I is ", warning="not zero: ")
    cosines = {title[:3]: (np.trace(R, axis1=1, axis2=2) - 1) / 2 for title, R in turned.items()}
    angles = {name: np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))) for name, cosine in cosines.items()}
    return value_plot("angle of the one turn that does the same", times, angles, "°", *caption)
