"""The figure of hw10: a free body and its principal axes."""

import numpy as np

from tam570_grader.checks.figures import Figure, seen_from
from tam570_grader.checks.plots import box_edges

from . import reference

EYE = seen_from(-1.1, 0.35)
SIZE = np.array([1.2, 0.8, 0.4])


def figure(turn=(0.25, -0.35, 0.5), omega=(0.35, 0.9, 0.4)):
    """Draw the body turned by this rotation vector, with omega in its axes."""
    R = reference.turned(np.array(turn))
    shown = Figure(
        "A free rigid body",
        "A body that nothing touches turns about its centre of mass G. Its principal axes 1, 2, 3, with the moments "
        "of inertia A, B, C, are fixed in it; R takes components along them to those along the axes x, y, z of "
        "space. omega is the angular velocity.",
        x=(-1.5, 1.9),
        y=(-1.15, 1.35),
    )
    shown.segments(EYE(box_edges(R, SIZE)))
    corner = np.array([-1.05, -0.75, -0.55])
    for axis, name in zip(np.eye(3), "xyz", strict=True):
        shown.arrow(EYE(corner), EYE(corner + 0.5 * axis), name, "thin")
    beyond = (28, 10), (0, 0), (0, 0)  # the first axis is almost level, and its name would cover its tip
    for axis, name, far, by in zip(R.T, ("1, A", "2, B", "3, C"), (1.1, 1.0, 0.85), beyond, strict=True):
        shown.arrow(EYE(0 * axis), EYE(far * axis), name, "angle", by=by)
    shown.arrow(EYE(np.zeros(3)), EYE(R @ np.array(omega)), "ω")
    shown.point("G", EYE(np.zeros(3)), by=(-13, -10))
    return shown
