"""The figure of hw08: a vector turned about an axis."""

import numpy as np

from tam570_grader.checks.figures import Figure, seen_from

from . import reference

EYE = seen_from(-1.2, 0.35)


def figure(angle=1.9, axis=(0.25, -0.1, 1.0), r=(0.85, -0.35, 0.75)):
    """Draw everything from the origin O."""
    n, r = np.array(axis) / np.linalg.norm(axis), np.array(r)
    turned = reference.rotate(r, n, angle)
    shown = Figure(
        "A vector turned about an axis",
        "The vector r is turned about the unit vector n by the angle theta, by the right hand, and becomes r'. Its "
        "tip moves on a circle around the axis.",
        x=(-1.35, 1.5),
        y=(-0.45, 1.75),
    )
    around = np.array([reference.rotate(r, n, turn) for turn in np.linspace(0.0, 2 * np.pi, 49)])
    middle = (n @ r) * n
    shown.line(EYE(around), "dash", closed=True)
    shown.line(EYE([-0.3 * n, 1.6 * n]), "dash")
    shown.line(EYE([middle, r]), "soft")
    shown.line(EYE([middle, turned]), "soft")
    some = np.array([reference.rotate(middle + 0.55 * (r - middle), n, turn) for turn in np.linspace(0.0, angle, 25)])
    shown.curve(EYE(some), "θ", by=(8, -14))
    shown.arrow(EYE(0 * n), EYE(1.35 * n), "n", "thin", by=(14, 2))
    shown.arrow(EYE(0 * n), EYE(r), "r", "body", by=(16, -4))
    shown.arrow(EYE(0 * n), EYE(turned), "r′", by=(16, 6))
    shown.point("O", EYE(0 * n), by=(-14, -8))
    return shown
