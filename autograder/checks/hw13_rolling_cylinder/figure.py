"""The figure of hw13: the cylinder on its ramp."""

import math

import numpy as np

from tam570.show.drawing import unit_circle
from tam570_grader.checks.figures import Figure

from . import reference


def figure(phi=0.9, radius=1.0, offset=0.5, slope=0.4):
    """Draw the contact at the origin of the paper, and the ramp down to the right."""
    down_the_ramp, off_it = np.array([math.cos(slope), -math.sin(slope)]), np.array([math.sin(slope), math.cos(slope)])

    def at(x, y):
        """Return the point with these coordinates of the ramp, from the contact."""
        return x * down_the_ramp + y * off_it

    C, centre, G = at(0, 0), at(0, radius), at(*reference.arms(phi, radius, offset)[0])
    shown = Figure(
        "A cylinder on a ramp",
        "The ramp goes down to the right at the angle slope from the horizontal. The cylinder of radius r touches it"
        " at C. The centre of mass G is at the distance e, the offset, from the centre O. The angle phi goes from OC"
        " to OG in the sense in which the cylinder rolls down, clockwise. The axes are x down the ramp and y off it.",
        x=(-2.3, 2.6),
        y=(-1.35, 2.25),
    )
    shown.ground(at(-2.1, 0), at(2.3, 0))
    shown.line([at(2.3, 0), at(2.3, 0) - [1.6, 0]], "dash")
    shown.angle(at(2.3, 0), 1.1, math.pi, math.pi - slope, "slope", by=(-42, 2))
    shown.line(centre + radius * unit_circle(48), "solid", closed=True)
    shown.line([centre, C], "dash")
    shown.line([centre, centre + 1.35 * radius * (G - centre) / offset], "dash")
    to_C = math.atan2(*(C - centre)[::-1])
    shown.angle(centre, 0.36, to_C, to_C - phi, "φ", by=(-9, -27))
    shown.dimension(centre, G, "e", aside=-22)
    rim = centre + radius * np.array([math.cos(0.5), math.sin(0.5)])
    shown.line([centre, rim], "soft")
    shown.label((centre + rim) / 2, "r", by=(-4, 13))
    shown.axes(at(-1.9, 0.55), 0.7, turned=-slope)
    shown.point("O", centre, by=(15, -6))
    shown.point("G", G, by=(-6, -17), size=6)
    shown.point("C", C, by=(-4, -22))
    shown.arrow((2.2, 1.6), (2.2, 0.9), "g", "thin")
    return shown
