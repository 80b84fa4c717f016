"""The figure of hw07: two bars and their angles."""

import math

import numpy as np

from tam570_grader.checks.figures import Figure

from . import reference


def figure(th1=0.5, th2=1.15, l1=1.0, l2=1.0):
    """Draw both bars, with the ceiling hinge at the origin."""
    theta, lengths = np.array([th1, th2]), np.array([l1, l2])
    bars = reference.wireframe(theta, lengths=lengths)
    (ceiling, elbow), (_, tip) = bars
    shown = Figure(
        "The double pendulum",
        "Two uniform bars of lengths l1 and l2. Bar 1 hangs from the ceiling hinge at the origin, x to the right and"
        " y up, bar 2 from the elbow. The angles th1 and th2 both go from straight down to the bar, counter-"
        "clockwise. G1 and G2 are the mass centres.",
        x=(-0.7, 2.0),
        y=(-1.65, 0.7),
    )
    shown.ground((0.35, 0), (-0.35, 0))
    shown.axes((0, 0), 0.45)
    for end, angle, name in ((ceiling, th1, "θ₁"), (elbow, th2, "θ₂")):
        shown.line([end, end - [0, 0.85]], "dash")
        shown.angle(end, 0.72, -math.pi / 2, angle - math.pi / 2, name)
    for bar in bars:
        shown.line(bar, "thick")
    shown.dimension(ceiling, elbow, "ℓ₁", aside=30)
    shown.dimension(elbow, tip, "ℓ₂", aside=30)
    shown.point("ceiling", ceiling, by=(-44, -10))
    shown.point("G₁", (ceiling + elbow) / 2, by=(-19, -2))
    shown.point("elbow", elbow, by=(-34, -4))
    shown.point("G₂", (elbow + tip) / 2, by=(8, -18))
    shown.point("tip", tip, by=(20, 2))
    shown.arrow((1.8, 0.3), (1.8, -0.1), "g", "thin")
    return shown
