"""The figure of hw02: the path with drag."""

import math

import numpy as np

from tam570_grader.checks.figures import Figure

from . import reference


def figure(angle=0.9, speed=1.0, drag=1.6):
    """Draw the path for m = g = 1 and this drag."""
    parameters = {"mass": 1.0, "drag": drag, "gravity": 1.0}
    end = reference.flight_time(speed, angle, **parameters)
    path = reference.trajectory(np.linspace(0.0, 1.12 * end, 60), speed, angle, **parameters)[:, :2]
    now = reference.trajectory(np.array([0.62 * end]), speed, angle, **parameters)[0]
    reach = reference.horizontal_range(speed, angle, **parameters)
    shown = Figure(
        "A projectile with drag",
        "A particle of mass m is launched from the origin at the given angle above the x axis, to the right; y is "
        "up. Its path is steeper on the way down. The range is the distance along x to where it is back at launch "
        "height; the path goes on below.",
        x=(-0.06, 0.42),
        y=(-0.09, 0.29),
    )
    shown.line([(-0.03, 0), (0.4, 0)], "soft")
    shown.axes((0, 0), 0.12)
    start = np.array([math.cos(angle), math.sin(angle)])
    shown.line(path, "body")
    shown.arrow((0, 0), 0.16 * speed * start, "launch", by=(-10, 16))
    shown.angle((0, 0), 0.07, 0.0, angle, "angle", by=(34, 8))
    shown.arrow(now[:2], now[:2] + 0.2 * now[2:], "v")
    shown.dimension((0, 0), (reach, 0), "range", aside=-26)
    shown.point("m", now[:2], by=(-4, -18), size=6)
    shown.arrow((0.38, 0.24), (0.38, 0.17), "g", "thin")
    return shown
