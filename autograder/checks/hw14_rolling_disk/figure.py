"""The figure of hw14: the disk in space, its angles and its frame e1, e2, e3."""

import numpy as np

from tam570_grader.checks.figures import Figure, seen_from

from . import reference

EYE = seen_from(-1.75, 0.4)
X, Y, Z = np.eye(3)


def figure(yaw=0.6, tilt=1.95, roll=0.6, radius=1.0):
    """Draw the disk with its contact at (0.9, 0.6)."""
    state = np.array([0.9, 0.6, yaw, tilt, roll, 0.0, 0.0, 0.0])
    contact, placed = np.array([0.9, 0.6, 0.0]), reference.matrix_state(state, radius)
    centre, R, (e1, e2, e3) = placed[reference.CENTRE], placed[reference.MATRIX].reshape(3, 3), reference.frame(state)
    heading = np.array([-e1[1], e1[0], 0.0])  # on the ground, across the track
    shown = Figure(
        "The rolling disk",
        "The ground with space axes x, y and z up. The disk of radius a touches the ground at C; its centre is G. e1"
        " lies on the ground along the track, at the angle yaw from x. e2 points up along the disk from C to G, at "
        "the angle tilt from the ground, which is pi/2 when the disk is upright. e3 is the axle. A radius fixed in "
        "the disk is at the angle roll from e1, about e3.",
        x=(-0.75, 2.8),
        y=(-0.75, 1.95),
    )

    def arc(middle, size, start, other, end, label, by=(0, 0)):
        turns = np.linspace(0.0, end, 25)[:, None]
        shown.curve(EYE(middle + size * (np.cos(turns) * start + np.sin(turns) * other)), label, by=by)

    corners = np.array([[-0.3, -0.5, 0], [2.3, -0.5, 0], [2.3, 2.0, 0], [-0.3, 2.0, 0]])
    shown.line(EYE(corners), "plane", closed=True)
    for axis, name in ((X, "x"), (Y, "y"), (Z, "z")):
        shown.arrow(EYE(0 * axis), EYE(0.75 * axis), name, "thin")
    turns = np.linspace(0, 2 * np.pi, 49)[:, None]
    shown.line(EYE(centre + radius * (np.cos(turns) * e1 + np.sin(turns) * e2)), "solid", closed=True)
    shown.line(EYE([contact - 0.9 * e1, contact + 1.5 * e1]), "dash")
    shown.line(EYE([contact, contact + 0.8 * X]), "dash")
    arc(contact, 0.6, X, Y, yaw, "yaw", by=(26, -3))
    shown.line(EYE([contact, contact + 0.85 * heading]), "dash")
    arc(contact, 0.5, heading, Z, tilt, "tilt", by=(-8, 15))
    shown.line(EYE([centre, centre + radius * R[:, 0]]), "body")
    arc(centre, 0.62, e1, e2, roll, "roll", by=(20, 8))
    for e, name, by in ((e1, "e₁", (14, 4)), (e2, "e₂", (4, 14)), (e3, "e₃", (14, -6))):
        shown.arrow(EYE(centre), EYE(centre + 0.9 * e), name, by=by)
    shown.label(EYE(contact + radius * e2 / 2), "a", by=(12, -2))
    shown.line(EYE([contact, centre]), "soft")
    shown.point("C", EYE(contact), by=(-10, -14))
    shown.point("G", EYE(centre), by=(-15, 6))
    return shown
