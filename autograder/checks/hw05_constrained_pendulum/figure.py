"""The figure of hw05: the particle on its circle."""

from tam570.show.drawing import unit_circle
from tam570_grader.checks.figures import Figure

from . import reference


def figure(theta=0.8, omega=0.6, length=1.0):
    """Draw a consistent state of this angle and rate."""
    state = reference.on_circle(theta, omega, length)
    position, velocity = state[:2], state[2:]
    shown = Figure(
        "The pendulum as a constrained particle",
        "A particle m is at x to the right and y up from the hinge at the origin, on the circle of radius l: x "
        "squared plus y squared is l squared. Its velocity (vx, vy) is along the circle. Gravity acts down.",
        x=(-1.25, 1.75),
        y=(-1.2, 1.2),
    )
    shown.line(length * unit_circle(48), "dash", closed=True)
    shown.axes((0, 0), 0.5)
    shown.segments(reference.wireframe(state, length=length))
    shown.line([(position[0], 0), position], "dash")
    shown.label((position[0], position[1] / 2), "y", by=(12, 0))
    shown.dimension((0, 0), (position[0], 0), "x", aside=16)
    shown.label(position / 2, "ℓ", by=(-12, -8))
    shown.arrow(position, position + velocity, "v")
    shown.point("hinge", (0, 0), by=(-32, 0))
    shown.point("m", position, by=(6, -21), size=9)
    shown.arrow((1.55, 0.9), (1.55, 0.45), "g", "thin")
    return shown
