"""The figure of hw03: P and C move, O is fixed."""

import numpy as np

from tam570_grader.checks.figures import Figure

from . import reference


def figure(r_p=(2.4, 1.7, 0.0), v_p=(0.5, -0.7, 0.0), r_c=(1.0, 0.45, 0.0), v_c=(0.8, 0.35, 0.0)):
    """Draw two parabolas in the plane of the paper, at t = 0."""
    shown = Figure(
        "A particle P and a point C",
        "The frame F has its origin O, x to the right and y up. The particle P of mass m moves with the velocity "
        "v_P, the point C in its own way with v_C. C', fixed in F, is where C is now. r_P/C is the vector from C to "
        "P.",
        x=(-0.4, 3.6),
        y=(-0.4, 2.6),
    )
    shown.axes((0, 0), 0.7)
    t = np.linspace(-1.2, 1.2, 30)
    bends = ((-0.5, -0.9, 0.0), (0.3, 1.0, 0.0))
    for r, v, a in ((r_p, v_p, bends[0]), (r_c, v_c, bends[1])):
        powers = t[:, None] ** np.arange(3)
        shown.line(powers @ np.array(reference.path(r, v, a))[:, :2], "dash")
    P, C = np.array(r_p[:2]), np.array(r_c[:2])
    shown.arrow((0, 0), P, "r_P", "thin", by=(-120, -66))
    shown.arrow((0, 0), C, "r_C", "thin", by=(-44, -36))
    shown.arrow(C, P, "r_P/C", "body", by=(-62, -104))
    shown.arrow(P, P + 0.9 * np.array(v_p[:2]), "v_P")
    shown.arrow(C, C + 0.9 * np.array(v_c[:2]), "v_C", by=(24, -6))
    shown.point("P", P, by=(4, 19), size=7)
    shown.point("C, C′", C, by=(10, -17))
    shown.point("O", (0, 0), by=(-12, -12))
    return shown
