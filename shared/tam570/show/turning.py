"""A free body drawn as a box by its rotation matrix, with a handle at the tip of its angular velocity."""

from collections.abc import Sequence

import numpy as np

from tam570.show.drawing import brick
from tam570.show.live import Handle, Live, energies
from tam570.show.scene import Array, Shape, arrow
from tam570.values import Function, Numbers, Parameters


def box_size(moments: Array) -> Array:
    """Return the sides, (3,) m, of a box of 12 kg with these moments of inertia, (3,) kg m^2; enlarge thin sides."""
    return np.sqrt(np.maximum(moments.sum() / 2 - moments, 0.05 * moments.max()))


def in_space(rotations: Array, vectors: Array) -> Array:
    """Convert vectors (n, 3) from components along a body's axes to those in space, by rotations (n, 3, 3)."""
    return np.einsum("nij,nj->ni", rotations, vectors)


def spin_arrow(omega: Array, size: Array, color: int) -> Shape:
    """Return the arrow of the angular velocity, (n, 3) in space, of a body of this size."""
    return arrow(np.zeros(3), _reach(size, omega[0]) * omega, color, "angular velocity")


def _reach(size: Array, omega: Sequence[float]) -> float:
    """Return a scale, m per rad/s, with which the arrow at the start is longer than the body."""
    return 1.8 * float(size.max()) / (float(np.linalg.norm(omega)) or 1.0)


def live_body(
    rates: Function, energy: Function, parameters: Parameters, start: Sequence[float], *, in_body: bool
) -> Live:
    """Return the interactive scene of a free body; its state is R (9, row by row) and omega (3).

    in_body : whether omega has components along the body's axes, not those of space
    """
    size = box_size(np.array(parameters["inertia"]))
    handle = spin_handle(_reach(size, start[9:]), in_body)
    tip = handle.point

    def drawing(states: Array, parameters: Parameters) -> list[Shape]:
        return [
            *brick(np.reshape(states[:, :9], (1, 3, 3)), size, 0, "body"),
            Shape("trail", tip(states[0])[None, None], 1, width=1.2),
            arrow(np.zeros(3), tip(states[0])[None], 1, "angular velocity"),
        ]

    return Live(rates, parameters, start, drawing, [handle], energies(energy))


def spin_handle(reach: float, in_body: bool) -> Handle:
    """Return the handle at the tip of the angular velocity, drawn with the scale `reach`, m per rad/s."""

    def tip(state: Numbers, **parameters: Numbers) -> Numbers:
        omega = np.array(state[9:])
        return reach * (np.reshape(state[:9], (3, 3)) @ omega if in_body else omega)

    def grab(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        omega = np.array(point) / reach
        return [*state[:9], *(np.reshape(state[:9], (3, 3)).T @ omega if in_body else omega)]

    return Handle(tip, grab)
