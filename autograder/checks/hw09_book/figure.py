"""The figure of hw09: the book and the axes fixed in space."""

import numpy as np

from tam570_grader.checks.figures import Figure, seen_from
from tam570_grader.checks.plots import box_edges

from . import reference

EYE = seen_from(0.55, 0.4)


def figure(size=(1.1, 1.5, 0.3), angle=1.3):
    """Draw the book, and arcs that turn by `angle`, which is positive."""
    half = np.array(size) / 2
    shown = Figure(
        "A book and its axes",
        "A box of the given size along x, y and z is centred on the origin. A positive rotation about an axis turns "
        "by the right hand: about z from x to y, about x from y to z, about y from z to x.",
        x=(-1.75, 1.75),
        y=(-1.35, 1.5),
    )
    shown.segments(EYE(box_edges(np.eye(3), np.array(size))))
    top = np.array([[1, 1, 1], [-1, 1, 1], [-1, -1, 1], [1, -1, 1]]) * half
    shown.line(EYE(top), "solid", closed=True)
    for axis, name in zip(np.eye(3), "xyz", strict=True):
        far = 1.45 * axis
        shown.arrow(EYE(0 * axis), EYE(far), name, "thin")
        start = np.roll(axis, 1) * 0.28 + 1.15 * axis
        turns = np.linspace(0.0, angle, 20)
        shown.curve(EYE(np.array([reference.axis_rotation(name, turn) @ start for turn in turns])), "+", by=(14, 10))
    places = ([0, -1, 1], (-36, 12)), ([1, 0.4, -1], (10, -18)), ([1, -1, 0], (-36, 0))
    for number, (at, by) in enumerate(places):
        shown.label(EYE(np.array(at) * half), f"size[{number}]", by=by, style="soft")
    return shown
