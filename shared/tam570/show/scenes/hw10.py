"""hw10: a box that flips about its middle axis, its polhode, and a symmetric body with its two cones."""

from typing import Any

import numpy as np

from tam570.show.drawing import box_face, cone
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, TimePlot, drift_plot, frame_times, moving, plot_samples
from tam570.show.student import Student, Trouble, make_each

__all__ = ["film"]

SECONDS = 16.0
BOX = np.array([2.4, 1.6, 0.4])  # m: the moments of inertia ascend
FLIP = np.array([0.02, 2.5, 0.0])  # rad/s: almost about the middle axis
ROD = np.array([0.9, 0.9, 2.2])  # m: two moments are equal
WOBBLE = np.array([1.0, 0.0, 2.5])  # rad/s
MASS = 1.0  # kg
UP = np.eye(3)[2]


def film(student: Student) -> Scene:
    """Both bodies are thrown at once."""
    times, notes = frame_times(SECONDS), list[str]()
    inertia = _inertia(BOX)
    omegas, rotations = _motion(student, times, _attitude(FLIP, inertia), FLIP, inertia)
    panels = [Panel(_box(student, notes, rotations, omegas, inertia), "box in space", ruler=False)]
    panels += make_each(notes, lambda: _polhode(student, omegas, inertia), lambda: _cones(student, times))
    return Scene(
        "Free rigid body",
        "A box that spins about its middle axis flips over, and back, again and again, while its angular "
        "momentum stays. Beside it the tip of its angular velocity, in axes of the body, runs along a curve on the "
        "energy ellipsoid. The cone of a symmetric body rolls on the cone in space.",
        times,
        panels,
        make_each(
            notes,
            lambda: _energy(student, times, omegas, inertia),
            lambda: _momentum(student, times, omegas, rotations, inertia),
        ),
        view=(0.6, 0.3),
        notes=notes,
        still_time=0.34,
    )


def _inertia(size: Array) -> Array:
    """(3,) kg m^2 of a uniform box."""
    squares = size**2
    moments: Array = MASS * (squares.sum() - squares) / 12.0
    return moments


def _attitude(omega: Array, inertia: Array) -> Array:
    """R at the start, that has the angular momentum point upwards."""
    along = inertia * omega
    third = along / np.linalg.norm(along)
    first = np.cross(third, np.roll(UP, 1) if abs(third[0]) < 0.9 else UP)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(third, first), third])


def _motion(student: Student, times: Array, R: Array, omega: Array, inertia: Array) -> tuple[Array, Array]:
    shapes = ((len(times), 3), (len(times), 3, 3))
    omegas, rotations = student.group("simulate", times, R, omega, inertia=inertia, shapes=shapes)
    return omegas, rotations


def _box(student: Student, notes: list[str], rotations: Array, omegas: Array, inertia: Array) -> list[Shape]:
    edges = student.each("wireframe", rotations, size=BOX, shape=(12, 2, 3)).reshape(-1, 24, 3)
    omega = _in_space(rotations, omegas)
    reach = 1.5 / np.linalg.norm(FLIP)  # m per rad/s
    return [
        Shape("fill", box_face(rotations, BOX), 0, faint=True),
        Shape("lines", edges, 0, "box", width=2.5),
        *make_each(notes, lambda: _momentum_arrow(student, rotations, omegas, inertia)),
        Shape("arrow", moving(np.zeros(3), reach * omega), 1, "angular velocity", width=2.5),
        Shape("trail", moving(rotations[:, :, 1] * BOX[1] / 2), 4, "end of the middle axis", width=1.2),
    ]


def _momentum_arrow(student: Student, rotations: Array, omegas: Array, inertia: Array) -> Shape:
    H = student.each("angular_momentum", rotations, omegas, inertia=inertia, shape=(3,))
    return Shape("arrow", moving(np.zeros(3), 1.7 * H / np.linalg.norm(H[0])), 2, "angular momentum", width=3)


def _in_space(rotations: Array, vectors: Array) -> Array:
    """(n, 3) vectors given in axes of the body."""
    turned: Array = np.einsum("nij,nj->ni", rotations, vectors)
    return turned


def _polhode(student: Student, omegas: Array, inertia: Array) -> Panel:
    energy = student.each("energy", omegas[:1], inertia=inertia)[0]
    if energy <= 0.0:
        raise Trouble(f"energy gives {energy} J: there is no ellipsoid of it")
    semi_axes = np.sqrt(2.0 * energy / inertia)
    mesh = [Shape("path", line * semi_axes, GREY, width=1, faint=True) for line in _sphere()]
    names = zip("ABC", 1.15 * np.diag(semi_axes), strict=True)
    mesh += [Shape("text", end[None], GREY, words=name) for name, end in names]
    tip = Shape("dot", omegas[:, None], 1, width=6)
    trail = Shape("trail", omegas[:, None], 1, "polhode", width=2.5)
    return Panel([*mesh, trail, tip], "energy ellipsoid", ruler=False)


def _sphere() -> list[Array]:
    """Circles of latitude and longitude."""
    u = np.linspace(0.0, 2.0 * np.pi, 49)
    meridians = [
        np.column_stack([np.sin(u) * np.cos(a), np.sin(u) * np.sin(a), np.cos(u)]) for a in np.arange(6) * np.pi / 6
    ]
    heights = np.sin(np.arange(-2, 3) * np.pi / 6)
    return meridians + [
        np.column_stack([np.sqrt(1 - z * z) * np.cos(u), np.sqrt(1 - z * z) * np.sin(u), 0 * u + z]) for z in heights
    ]


def _cones(student: Student, times: Array) -> Panel:
    """The body cone, of the directions that omega has in the body, and the space cone, of those it has in space."""
    inertia = _inertia(ROD)
    omegas, rotations = _motion(student, times, _attitude(WOBBLE, inertia), WOBBLE, inertia)
    edges = student.each("wireframe", rotations, size=ROD, shape=(12, 2, 3)).reshape(-1, 24, 3)
    length = 1.6 / np.linalg.norm(WOBBLE)
    in_body, in_space = length * omegas, length * _in_space(rotations, omegas)
    body_rim = _once_round(in_body, UP)
    space_rim = _once_round(in_space, UP)
    shapes = [
        Shape("lines", edges, GREY, width=1.5),
        *cone(space_rim, 2, "space cone"),
        *cone(body_rim @ np.swapaxes(rotations, 1, 2), 0, "body cone"),
        Shape("arrow", moving(np.zeros(3), in_space), 1, width=2.5),
    ]
    return Panel(shapes, "symmetric body, in space", ruler=False)


def _once_round(vectors: Array, axis: Array) -> Array:
    """(m, 3) of the vectors (n, 3) as far as they first close a turn about the axis, or all."""
    across = np.unwrap(np.arctan2(vectors[:, 1], vectors[:, 0]))
    beyond = np.flatnonzero(np.abs(across - across[0]) >= 2.0 * np.pi)
    last = beyond[0] if len(beyond) else len(vectors) - 1
    chosen: Array = vectors[np.rint(np.linspace(0, last, 37)).astype(int)]
    return chosen


def _energy(student: Student, times: Array, omegas: Array, inertia: Array) -> TimePlot:
    shown = plot_samples(times)
    energy = student.each("energy", omegas[shown], inertia=inertia)
    return drift_plot("energy of the box, change", times[shown], {"": energy}, abs(energy[0]) or 1.0, "itself")


def _momentum(student: Student, times: Array, omegas: Array, rotations: Array, inertia: Any) -> TimePlot:
    shown = plot_samples(times)
    H = student.each("angular_momentum", rotations[shown], omegas[shown], inertia=inertia, shape=(3,))
    size = float(np.linalg.norm(H[0])) or 1.0
    return drift_plot("angular momentum in space, change", times[shown], {"": H}, size, "itself")
