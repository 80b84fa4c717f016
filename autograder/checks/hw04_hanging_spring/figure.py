"""The figure of hw04: the mass on its spring, in space."""

import numpy as np

from tam570_grader.checks.figures import Figure

from . import reference

AZIMUTH, ELEVATION = -0.9, 0.3


def figure(position=(0.75, 0.35, -1.1)):
    """Draw the mass as seen by the projection of the problem."""

    def seen(point):
        return reference.project(np.atleast_2d(np.asarray(point, float)), AZIMUTH, ELEVATION)[0]

    shown = Figure(
        "A mass on a spring",
        "A spring of stiffness k and rest length zero is hung at the origin O of the axes x, y, and z up. It holds a"
        " mass m at the position r, which may be anywhere in space. Gravity acts along minus z.",
        x=(-1.0, 1.7),
        y=(-1.6, 0.75),
    )
    r = np.array(position)
    for axis, name in zip(np.eye(3), "xyz", strict=True):
        shown.arrow(seen(0 * axis), seen(0.6 * axis), name, "thin")
    foot = r * [1, 1, 0]
    shown.line([seen(0 * r), seen(foot), seen(r)], "dash")
    shown.spring(seen(0 * r), seen(r))
    shown.label(seen(r / 2), "k, r", by=(-30, -8))
    shown.point("O", seen(0 * r), by=(-15, 6))
    shown.point("m", seen(r), by=(20, -2), size=9)
    shown.arrow((1.45, -0.35), (1.45, -0.75), "g", "thin")
    return shown
