"""17 Oct: Euler angles 3-1-3 and 3-1-2, as three rings, one in the other.

The first ring turns about an axis of space, each further one about an axis of the ring before it: R = Rz(psi)
Rx(theta) Rz(phi) for "313", R = Rz(psi) Rx(theta) Ry(phi) for "312". The angular velocity is the sum of each rate
along the axis of its ring. Where the first axis and the last are parallel, two of the rates have the same effect, and
no rates turn the body about a third axis: the gimbal locks, at theta = 0 or pi for "313", at +-pi/2 for "312"
(Greenwood, Principles of Dynamics, section 7-13). Space: z is the first axis.
"""

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import numbers, one_of, positive
from tam570.rotations import euler_from_matrix, matrix_from_axis_angle
from tam570.show.drawing import circle, solid
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, frame_times, moving
from tam570.values import Parameters

EXAMPLE = {"sequence": "313", "miss": 0.12}  # rad, by which the scene's body misses the lock
SEQUENCES = ("313", "312")
LOCK = 1e-12  # volume that the three axes span, below which they are in one plane to rounding
SPEED, SECONDS = 0.3, 8.0  # rad/s, s, of the scene


def rings(angles: ArrayLike, sequence: str) -> Array:
    """Return (3, 3, 3) the matrices after the first turn, the first two, all three; angles psi, theta, phi, rad."""
    one_of(SEQUENCES, sequence=sequence)
    single = matrix_from_axis_angle(_own_axes(sequence), numbers(3, angles=angles))
    return np.stack([single[0], single[0] @ single[1], single[0] @ single[1] @ single[2]])


def angular_velocity(angles: ArrayLike, rates: ArrayLike, sequence: str) -> Array:
    """Return omega in space, (3,) rad/s, of angles (3,), rad, that change at these rates (3,), rad/s."""
    return _ring_axes(angles, sequence) @ numbers(3, rates=rates)


def euler_rates(angles: ArrayLike, omega: ArrayLike, sequence: str) -> Array:
    """Return (3,) rates of psi, theta, phi, rad/s, from angles (3,), rad, and omega (3,), rad/s in space.

    Raise ValueError in gimbal lock.
    """
    turning, axes = numbers(3, omega=omega), _ring_axes(angles, sequence)
    if abs(np.linalg.det(axes)) < LOCK:
        theta = float(np.ravel(angles)[1])
        raise ValueError(f"angles: theta = {theta:g} rad locks the gimbal {sequence}; no rates give every omega there")
    return np.asarray(np.linalg.solve(axes, turning), dtype=float)


def _own_axes(sequence: str) -> Array:
    """Return (3, 3) the axes of the three turns as rows, each in the frame of the ring that turns about it."""
    return np.eye(3)[[int(digit) - 1 for digit in sequence]]


def _ring_axes(angles: ArrayLike, sequence: str) -> Array:
    """Return (3, 3) the axes in space about which the three rings turn, as columns."""
    turned = rings(angles, sequence)
    return np.column_stack([R @ axis for R, axis in zip(turned, _own_axes(sequence), strict=True)])


def film(parameters: Parameters) -> Scene:
    """Return the scene of a body that turns steadily past the lock, with its rings."""
    sequence, miss = parameters["sequence"], parameters["miss"]
    one_of(SEQUENCES, sequence=sequence)
    positive(miss=miss)
    times = frame_times(SECONDS)
    aside = matrix_from_axis_angle([0.0, 1.0, 0.0], miss)
    upright = matrix_from_axis_angle([1.0, 0.0, 0.0], np.pi / 2 if sequence == "312" else 0.0)  # last axis to z
    R = aside @ matrix_from_axis_angle([1.0, 0.0, 0.0], SPEED * (times - SECONDS / 2)) @ upright
    angles = np.unwrap(euler_from_matrix(sequence, R), axis=0)
    omega = SPEED * aside[:, 0]
    rates = np.array([euler_rates(row, omega, sequence) for row in angles])
    rebuilt = np.array([angular_velocity(*row, sequence) for row in zip(angles, rates, strict=True)])
    curves = dict(zip(("psi", "theta", "phi"), rates.T, strict=True))
    largest = f"up to {np.abs(rates).max():.3g} rad/s, while the body turns at {SPEED:g} rad/s"
    sums = dict(zip("xyz", rebuilt.T, strict=True))
    return Scene(
        f"Gimbal {sequence}",
        "A disk in two rings turns steadily about a level axis. Its own axis passes close by the axis of the outer "
        "ring. There the outer ring has to whip round by half a turn, and the disk in it by as much the other way.",
        times,
        [Panel(_gimbal(np.array([rings(row, sequence) for row in angles]), sequence), ruler=False)],
        [
            value_plot("rates of the angles", times, curves, "rad/s", largest),
            value_plot("their sum along the axes of the rings", times, sums, "rad/s", *drift_caption(rebuilt, SPEED)),
        ],
        view=(0.9, 0.35),
        still_time=0.44,
    )


def _gimbal(turned: Array, sequence: str) -> list[Shape]:
    """Return both rings and the disk, by the matrices (n, 3, 3, 3) after each turn."""
    outer, middle, body = np.moveaxis(turned, 1, 0)
    first, second, third = _own_axes(sequence)
    aside = np.cross(third, second)
    return [
        Shape("lines", 1.5 * np.array([first, 1.2 * first / 1.5, -first, -1.2 * first / 1.5]), GREY, width=5),
        Shape("path", circle(np.zeros(3), 1.2 * outer @ first, 1.2 * outer @ second), 2, "ring of psi", width=4),
        Shape("lines", moving(*(s * outer @ second for s in (1.2, 1.0, -1.2, -1.0))), 2, width=3),
        Shape("path", circle(np.zeros(3), middle @ second, middle @ third), 1, "ring of theta", width=4),
        Shape("lines", moving(*(s * middle @ third for s in (1.0, -1.0))), 1, width=3),
        *solid(circle(np.zeros(3), 0.7 * body @ second, 0.7 * body @ aside), 0, "disk, turned by phi", 3),
        Shape("lines", moving(np.zeros(3), 0.7 * body @ second), 0, width=3),
    ]
