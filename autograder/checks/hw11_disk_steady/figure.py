"""The figure of hw11: the disk seen along its track, in the vertical plane of the circle's axis and the contact."""

import math

import numpy as np

from tam570_grader.checks.figures import Figure

from . import reference


def figure(lean=0.45, radius=1.0, track_radius=1.9):
    """Draw the axis of the circle at x = 0, and the contact at the track radius to its right."""
    C = np.array([track_radius, 0.0])
    up, axle = _in_the_plane(reference.rim(lean, radius)), _in_the_plane(reference.axle(lean))
    G, top = C + up, C + 2 * up
    shown = Figure(
        "A disk that rolls in a circle",
        "A vertical section through the axis of the circle and the contact C. The disk is seen edge on; it leans "
        "from the vertical towards the axis by the angle lean. Its centre G is at the distance a, the radius, from "
        "C. R is the track radius, from the axis to C. The axle points towards the axis and, where lean is positive,"
        " down. The precession is about the upward vertical, the spin about the axle.",
        x=(-0.75, 3.3),
        y=(-0.65, 2.55),
    )
    shown.ground((-0.6, 0), (3.1, 0))
    shown.line([(0, -0.15), (0, 2.2)], "dash")
    shown.arrow((0, 1.75), (0, 2.3), "")
    turns = np.linspace(0.25, 2 * math.pi - 0.75, 30)
    shown.curve(np.column_stack([0.3 * np.sin(turns), 1.75 - 0.09 * np.cos(turns)]), "", "vector")
    shown.label((0, 2.1), "Ω, precession", by=(70, 8), style="vector")
    shown.line([C, top], "thick")
    shown.line([C, C + [0, 2.1]], "dash")
    shown.angle(C, 1.45, math.pi / 2, math.pi / 2 + lean, "lean")
    shown.arrow(G, G + 0.85 * axle, "axle, spin", by=(-10, -18))
    shown.dimension(G, C, "a", aside=34)
    shown.dimension((0, 0), C, "R, track radius", aside=-34)
    shown.point("G", G, by=(19, 8))
    shown.point("C", C, by=(15, 13))
    shown.label((0, 0), "axis", by=(-24, 14), style="soft")
    shown.arrow((2.95, 1.6), (2.95, 0.95), "g", "thin")
    return shown


def _in_the_plane(vector):
    """Return (right, up) of a vector with components towards the centre, along the track and up."""
    inward, _, upward = vector
    return np.array([-inward, upward])
