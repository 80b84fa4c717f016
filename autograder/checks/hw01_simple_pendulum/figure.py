"""The figure of hw01: the pendulum."""

import math

from tam570_grader.checks.figures import Figure

from . import reference


def figure(theta=0.65, length=1.0):
    """Draw the pendulum, with its hinge at the origin."""
    r = reference.vectors(theta, 0.0, 1.0, length, 1.0)[0]
    bob = r.real, r.imag
    shown = Figure(
        "The simple pendulum",
        "A mass m hangs on a rod of length l from a hinge at the origin, x to the right and y up. The angle theta "
        "goes from straight down to the rod, counter-clockwise. Gravity acts down.",
        x=(-0.75, 1.15),
        y=(-1.2, 0.55),
    )
    shown.ground((0.3, 0), (-0.3, 0))
    shown.axes((0, 0), 0.42)
    shown.line([(0, 0), (0, -1.05 * length)], "dash")
    shown.line([(0, 0), bob], "body")
    shown.angle((0, 0), 0.5, -math.pi / 2, theta - math.pi / 2, "θ")
    shown.dimension((0, 0), bob, "ℓ", aside=26)
    shown.point("m", bob, by=(19, -2), size=9)
    shown.arrow((0.95, -0.35), (0.95, -0.65), "g", "thin")
    return shown
