"""26, 31 Oct: Bearings of a body that turns about a fixed axis.

z is the axis, fixed in the body and in space; the other axes turn with the body. M = I alpha + omega x I omega about a
point of the axis, with omega = (0, 0, spin) and alpha = (0, 0, spin_rate), is (Ixz spin_rate - Iyz spin^2, Iyz
spin_rate + Ixz spin^2, Izz spin_rate): the off-diagonal terms of I cause a moment on the bearings that goes round with
the body (Greenwood, Principles of Dynamics, section 8-2).
"""

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import finite, symmetric
from tam570.rotations import matrix_from_axis_angle
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, arrow, frame_times
from tam570.values import Parameters

EXAMPLE = {
    "inertia": ((1.2, 0.0, -0.4), (0.0, 1.5, 0.0), (-0.4, 0.0, 0.6)),  # kg m^2
    "spin": 3.0,  # rad/s
    "spin_rate": 0.0,  # rad/s^2
}
UP = np.array([0.0, 0.0, 1.0])
SHAFT = 1.5  # m, half its length


def moment(inertia: ArrayLike, spin: float, spin_rate: float) -> Array:
    """Return (3,) N m in the body's axes, from inertia (3, 3), kg m^2, spin, rad/s, and spin_rate, rad/s^2."""
    matrix = symmetric((3, 3), inertia=inertia)
    finite(spin=spin, spin_rate=spin_rate)
    omega, alpha = spin * UP, spin_rate * UP
    return matrix @ alpha + np.cross(omega, matrix @ omega)


def film(parameters: Parameters) -> Scene:
    """Return the scene of the body, and of a balanced one without the off-diagonal terms."""
    spin, spin_rate = parameters["spin"], parameters["spin_rate"]
    matrix = symmetric((3, 3), inertia=parameters["inertia"])
    times = frame_times(8.0)
    speeds = spin + spin_rate * times
    R = matrix_from_axis_angle(UP, times * (spin + speeds) / 2)
    felt = np.array([moment(matrix, speed, spin_rate) for speed in speeds])
    in_space = np.einsum("nij,nj->ni", R, felt)
    across = np.linalg.norm(felt[:, :2], axis=1)
    longest = float(across.max()) or 1.0
    push = arrow(np.zeros(3), 1.2 * in_space * [1, 1, 0] / longest, 1, "moment across the axis", 3)
    if spin_rate:
        # Across the axis M has the size sqrt(Ixz^2 + Iyz^2) sqrt(spin_rate^2 + spin^4) at every angle.
        across = across / np.hypot(spin_rate, speeds**2)
    drift = drift_caption(across, about="size of the moment for it: ")
    curves = dict(zip("xyz", in_space.T, strict=True))
    return Scene(
        "Bearings",
        "Two bodies turn on vertical shafts. One is not balanced: the moment that its bearings must give goes round "
        "with it. The balanced one needs no moment across its axis.",
        times,
        [
            Panel([*_body(matrix, R), push], "with off-diagonal terms", ruler=False),
            Panel(_body(np.diag(np.diag(matrix)), R), "balanced", ruler=False),
        ],
        [
            value_plot("moment on the unbalanced body, in space", times, curves, "N m"),
            value_plot("spin", times, {"": speeds}, "rad/s", *drift),
        ],
        view=(0.6, 0.35),
        still_time=0.3,
    )


def _body(inertia: Array, R: Array) -> list[Shape]:
    """Return six equal masses on the principal axes, as far out as the moments of inertia require, on their shaft."""
    moments, principal = np.linalg.eigh(inertia)
    squares = np.maximum(moments.sum() / 2 - moments, 0.0)
    reach = 1.1 * np.sqrt(squares / (squares.max() or 1.0))
    arms = (R @ (principal * reach)).swapaxes(1, 2)
    ends = np.concatenate([arms, -arms], axis=1)
    pairs = np.stack([arms, -arms], axis=2).reshape(len(R), 6, 3)
    return [
        Shape("lines", SHAFT * np.array([UP, -UP]), INK, width=3),
        Shape("dot", SHAFT * np.array([UP, -UP]), GREY, "bearings", width=12),
        Shape("lines", pairs, 0, width=3),
        Shape("dot", ends, 0, "masses", width=11),
    ]
