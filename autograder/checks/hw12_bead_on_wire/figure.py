"""The figure of hw12: the bead on its wire."""

import numpy as np

from tam570_grader.checks.figures import Figure

from . import reference


def figure(x=0.75, curvature=1.0, v=0.45):
    """Draw the bead, with the bottom of the wire at the origin."""
    places = np.linspace(-1.15, 1.15, 41)
    # the height by the potential energy of 1 kg at g = 1
    height = [reference.energy(position, 0.0, 1.0, curvature, 1.0) for position in places]
    bead = np.array([x, reference.energy(x, 0.0, 1.0, curvature, 1.0)])
    shown = Figure(
        "A bead on a wire",
        "The wire has the shape y = c x squared, x to the right and y up, its lowest point at the origin. The bead "
        "of mass m is at x on it, and v = dx/dt is the horizontal component of its velocity. Gravity acts down.",
        x=(-1.45, 1.6),
        y=(-0.4, 1.6),
    )
    shown.axes((0, 0), 0.4)
    shown.line(np.column_stack([places, height]), "body")
    shown.label((places[0], height[0]), "y = c x²", by=(50, 10))
    shown.line([bead, bead * [1, 0]], "dash")
    shown.dimension((0, 0), (x, 0), "x", aside=-24)
    shown.arrow(bead, bead + [v, 0], "v = dx/dt", by=(10, -15))
    slope = 2 * curvature * x
    along = bead + v * np.array([1.0, slope])
    shown.arrow(bead, along, "", "soft")
    shown.line([along, along * [1, 0] + bead * [0, 1]], "dash")
    shown.point("m", bead, by=(-18, -4), size=8)
    shown.arrow((1.4, 1.4), (1.4, 1.1), "g", "thin")
    return shown
