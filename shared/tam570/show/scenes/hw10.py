"""hw10: a box that flips, the curve of its angular velocity on two ellipsoids, and a disk that wobbles."""

from collections.abc import Sequence

import numpy as np

from tam570.lectures.inertia import of_box
from tam570.loading import Trouble
from tam570.show.drawing import box_face, brick, circle, cone, solid
from tam570.show.live import Live, live_if_written
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, arrow, frame_times, moving
from tam570.show.student import StudentModule
from tam570.show.turning import in_space, spin_handle
from tam570.values import Numbers, Parameters

EXAMPLE = {"mass": 1.0, "size": (2.4, 1.6, 0.4)}  # kg, m: the moments of inertia ascend
STATE = {"omega_a": "rad/s", "omega_b": "rad/s", "omega_c": "rad/s"}
START = (0.02, 2.5, 0.0)  # almost about the middle axis
SECONDS = 16.0
RADIUS, DISK = 1.0, np.array([0.25, 0.25, 0.5])  # m, kg m^2: of 1 kg, two moments are equal
WOBBLE = np.array([0.5, 0.0, 2.0])  # rad/s
UP = np.eye(3)[2]


def film(student: StudentModule, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the box and the disk, thrown at the same time."""
    times, spin = frame_times(seconds), np.array(start)
    inertia = np.diag(of_box(parameters["mass"], parameters["size"]))
    if not spin.any():
        raise Trouble("start: a body at rest shows nothing; set start.omega_b, say")
    omegas, rotations = student("simulate", times, _attitude(spin, inertia), spin, inertia=inertia)
    momenta = student.make_each(lambda: student.each("angular_momentum", rotations, omegas, inertia=inertia))
    box = _box(student, rotations, omegas, momenta, np.array(parameters["size"]))
    panels = [Panel(box, "box in space", ruler=False)]
    panels += student.make_each(lambda: _ellipsoids(student, omegas, inertia), lambda: _disk(student, times))
    return Scene(
        "Free rigid body",
        "A box that spins about its middle axis flips over, and back, again and again, while its angular "
        "momentum stays. Beside it the tip of its angular velocity, in axes of the body, runs along the curve in which "
        "two ellipsoids meet, those of energy and of angular momentum. A disk wobbles twice as fast as it spins, and "
        "two points of its rim run on tilted circles.",
        times,
        panels,
        [
            *student.make_each(lambda: _energy(student, times, omegas, inertia)),
            *(_momentum(times, H, inertia * omegas) for H in momenta),
        ],
        view=(0.6, 0.3),
        still_time=0.34,
        live=live_if_written(lambda: _live(student, inertia, np.array(parameters["size"]), spin)),
    )


def _live(student: StudentModule, inertia: Array, size: Array, spin: Array) -> Live:
    """Return the equations of the box: R, row by row, and omega in the body; a handle moves the tip of omega."""
    euler, attitude, energy = (student.function(name) for name in ("euler_equations", "attitude_rate", "energy"))
    reach = 1.5 / float(np.linalg.norm(spin))  # m per rad/s
    handle = spin_handle(reach, in_body=True)
    tip = handle.point
    start = (*_attitude(spin, inertia).ravel().tolist(), *spin.tolist())

    def rates(t: float, state: Numbers, *, inertia: Numbers) -> list[Numbers]:
        R, omega = np.reshape(state[:9], (3, 3)), np.array(state[9:])
        return [*np.ravel(attitude(R, omega)), *euler(omega, inertia=np.array(inertia))]

    def drawing(states: Numbers, parameters: Parameters) -> list[Shape]:
        R, omega = np.reshape(states[:, :9], (1, 3, 3)), states[0, 9:]
        H = 0.7 * reach * (R[0] @ (np.array(parameters["inertia"]) / inertia.mean() * omega))
        return [
            *brick(R, size, 0, "box"),
            arrow(np.zeros(3), H[None], 2, "angular momentum", 3),
            arrow(np.zeros(3), tip(states[0])[None], 1, "angular velocity"),
            Shape("trail", tip(states[0])[None, None], 1, width=1.2),
        ]

    def kinetic(state: Numbers, *, inertia: Numbers) -> Numbers:
        return energy(np.array(state[9:]), inertia=np.array(inertia))

    arguments = {"inertia": tuple(inertia.tolist())}
    return Live(rates, arguments, start, drawing, [handle], {"energy": kinetic})


def _attitude(omega: Array, inertia: Array) -> Array:
    """Return R at the start, for which the angular momentum points upwards."""
    along = inertia * omega
    third = along / np.linalg.norm(along)
    first = np.cross(third, np.roll(UP, 1) if abs(third[0]) < 0.9 else UP)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(third, first), third])


def _box(student: StudentModule, rotations: Array, omegas: Array, momenta: list[Array], size: Array) -> list[Shape]:
    edges = student.each("wireframe", rotations, size=size).reshape(-1, 24, 3)
    reach = 1.5 / np.linalg.norm(omegas[0])  # m per rad/s
    return [
        Shape("fill", box_face(rotations, size), 0, faint=True),
        Shape("lines", edges, 0, "box", width=2.5),
        *(arrow(np.zeros(3), 1.7 * H / np.linalg.norm(H[0]), 2, "angular momentum", 3) for H in momenta),
        arrow(np.zeros(3), reach * in_space(rotations, omegas), 1, "angular velocity"),
        Shape("trail", moving(rotations[:, :, 1] * size[1] / 2), 4, "end of the middle axis", width=1.2),
    ]


def _ellipsoids(student: StudentModule, omegas: Array, inertia: Array) -> Panel:
    """Return the ellipsoids of energy and of |H|, on both of which omega stays, and the curve in which they meet."""
    energy = student.each("energy", omegas[:1], inertia=inertia)[0]
    momentum = float(np.linalg.norm(inertia * omegas[0]))
    if energy <= 0.0:
        raise Trouble(f"energy gives {energy} J: there is no ellipsoid of it")
    of_energy, of_momentum = np.sqrt(2.0 * energy / inertia), momentum / inertia
    mesh = [Shape("path", line * of_energy, GREY, width=1, faint=True) for line in _sphere()]
    mesh += [Shape("path", line * of_momentum, 3, width=1, faint=True) for line in _sphere()]
    names = zip("ABC", 1.15 * np.diag(np.maximum(of_energy, of_momentum)), strict=True)
    mesh += [Shape("text", end[None], GREY, words=name) for name, end in names]
    curves = [Shape("path", curve, INK, "both ellipsoids", width=1.5) for curve in _meeting(energy, momentum, inertia)]
    tip = Shape("dot", omegas[:, None], 1, width=6)
    trail = Shape("trail", omegas[:, None], 5, "tip of the angular velocity", width=2.5)
    return Panel([*mesh, *curves, trail, tip], "ellipsoids of energy and of momentum", ruler=False)


def _meeting(energy: float, momentum: float, inertia: Array) -> list[Array]:
    """Return the two closed curves (n, 3) on which omega has this energy and |H|, straight lines in omega's squares."""
    order = np.argsort(inertia)
    a, b, c = inertia[order]
    if c - a < 1e-9 * c:
        return []
    u = np.linspace(0.0, 2.0 * np.pi, 181)
    outer = c if momentum**2 > 2.0 * energy * b else a  # moment about the axis inside the curves
    inner = a + c - outer
    largest = max((momentum**2 - 2.0 * energy * inner) / (outer * (outer - inner)), 0.0)  # square of omega along it

    def across(moment: float) -> float:
        return float(np.sqrt(max((2.0 * energy * outer - momentum**2) / (moment * (outer - moment)), 0.0)))

    first, other = across(inner) * np.cos(u), across(b) * np.sin(u)
    along = np.sqrt(np.maximum((2.0 * energy - inner * first**2 - b * other**2) / outer, 0.0) if largest else 0.0 * u)
    curves = []
    for sign in (1.0, -1.0):
        curve = np.zeros((len(u), 3))
        curve[:, order[2 if outer == c else 0]] = sign * along
        curve[:, order[0 if outer == c else 2]], curve[:, order[1]] = first, other
        curves.append(curve)
    return curves


def _sphere() -> list[Array]:
    """Return circles of latitude and longitude on the unit sphere."""
    u = np.linspace(0.0, 2.0 * np.pi, 49)
    lines = [(u, a) for a in np.arange(6) * np.pi / 6]  # angles from z, and about it
    lines += [(a, u) for a in np.arange(5, 0, -1) * np.pi / 6]
    points = [(np.sin(down) * np.cos(turn), np.sin(down) * np.sin(turn), np.cos(down)) for down, turn in lines]
    return [np.column_stack(np.broadcast_arrays(*xyz)) for xyz in points]


def _disk(student: StudentModule, times: Array) -> Panel:
    """Return a disk with two points of its rim, a quarter turn apart, and the body cone and space cone of omega."""
    omegas, rotations = student("simulate", times, _attitude(WOBBLE, DISK), WOBBLE, inertia=DISK)
    length = 1.6 / np.linalg.norm(WOBBLE)
    omega = length * in_space(rotations, omegas)
    first, other = RADIUS * rotations[:, :, 0], RADIUS * rotations[:, :, 1]
    shapes = [
        *solid(circle(np.zeros(3), first, other, 37), GREY, "disk"),
        *cone(_once_round(omega), 2, "space cone"),
        *cone(_once_round(length * omegas) @ np.swapaxes(rotations, 1, 2), 3, "body cone"),
        arrow(np.zeros(3), omega, 1),
    ]
    for point, color in ((first, 4), (other, 5)):
        shapes += [
            Shape("trail", point[:, None], color, "points of the rim", width=1.5),
            Shape("dot", point[:, None], color, width=6),
        ]
    return Panel(shapes, "disk in space, C = 2 A", ruler=False)


def _once_round(vectors: Array) -> Array:
    """Return (m, 3) of the vectors (n, 3) up to their first full turn about z, or all."""
    across = np.unwrap(np.arctan2(vectors[:, 1], vectors[:, 0]))
    beyond = np.flatnonzero(np.abs(across - across[0]) >= 2.0 * np.pi)
    last = beyond[0] if len(beyond) else len(vectors) - 1
    return vectors[np.rint(np.linspace(0, last, 37)).astype(int)]


def _energy(student: StudentModule, times: Array, omegas: Array, inertia: Array) -> TimePlot:
    energy = student.each("energy", omegas, inertia=inertia)
    curves = {f"omega {name}": part for name, part in zip("ABC", omegas.T, strict=True)}
    return value_plot("angular velocity in the body", times, curves, "rad/s", *drift_caption(energy, about="energy: "))


def _momentum(times: Array, in_space: Array, in_body: Array) -> TimePlot:
    curves = {f"H {name}": part for name, part in zip("ABC", in_body.T, strict=True)}
    caption = drift_caption(in_space, about="in space: ")
    return value_plot("angular momentum in the body", times, curves, "kg m²/s", *caption)
