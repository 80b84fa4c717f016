"""The figure of hw06: the car from above, its heading, its axles."""

import cmath
import math

import numpy as np

from tam570_grader.checks.figures import Figure

from . import reference

HALF_TRACK, WHEEL = 0.75, 0.55  # m, of the drawn car


def figure(heading=0.55, front=1.5, rear=1.1):
    """Draw the car with G at (2.6, 1.5)."""
    G = 2.6 + 1.5j

    def at(ahead, leftwards=0.0):
        z = G + (ahead + 1j * leftwards) * cmath.exp(1j * heading)
        return np.array([z.real, z.imag])

    shown = Figure(
        "The car from above",
        "The ground plane with axes x to the right and y up. The centre of mass G of the car is on its centreline; "
        "the heading is the angle from the x axis to the forward direction, counter-clockwise. The front axle is at "
        "the distance front ahead of G, the rear axle at the distance rear behind it. The speed is the forward "
        "component of the velocity.",
        x=(-0.5, 6.4),
        y=(-0.5, 4.0),
    )
    shown.axes((0, 0), 0.9)
    corners = [at(front, HALF_TRACK), at(-rear, HALF_TRACK), at(-rear, -HALF_TRACK), at(front, -HALF_TRACK)]
    shown.line(corners, "solid", closed=True)
    for axle in reference.axles("rear", front, rear):
        shown.line([at(axle, HALF_TRACK), at(axle, -HALF_TRACK)], "body")
        for side in (HALF_TRACK, -HALF_TRACK):
            shown.line([at(axle - WHEEL / 2, side), at(axle + WHEEL / 2, side)], "thick")
    shown.line([at(-rear - 0.5), at(front + 0.3)], "dash")
    shown.arrow(at(front + 0.1), at(front + 1.3), "speed", by=(20, 16))
    shown.line([at(0), at(0) + [2.7, 0]], "dash")
    shown.angle(at(0), 2.25, 0.0, heading, "heading", by=(42, -6))
    shown.dimension(at(0), at(front), "front", aside=78)
    shown.dimension(at(-rear), at(0), "rear", aside=78)
    arc = [at(0.45 * math.cos(a), 0.45 * math.sin(a)) for a in np.linspace(2.2, 3.9, 12)]
    shown.curve(arc, "yaw rate", by=(-32, -12))
    shown.point("G", at(0), by=(4, -17))
    shown.label(at(front), "front axle", by=(52, -80), style="soft")
    shown.label(at(-rear), "rear axle", by=(54, -88), style="soft")
    return shown
