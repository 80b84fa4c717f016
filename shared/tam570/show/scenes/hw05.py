"""hw05: the particle on its circle, in Cartesian coordinates."""

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from tam570.show.diagrams import force_shapes
from tam570.show.drawing import unit_circle
from tam570.show.live import Handle, Live, energies, live_if_written
from tam570.show.plots import drift_caption, state_energy_plot, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, arrow, frame_times, moving
from tam570.show.student import StudentModule
from tam570.values import Numbers, Parameters

EXAMPLE = {"mass": 1.0, "length": 1.0, "gravity": 9.81}  # kg, m, m/s^2
STATE = {"x": "m", "y": "m", "vx": "m/s", "vy": "m/s"}
START = (math.sin(0.1), math.cos(0.1), 0.0, 0.0)  # 0.1 rad from the top
SECONDS = 12.0
ARROW = 0.15  # length of the weight's arrow, relative to the rod


def film(student: StudentModule, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the particle, released at rest next to the top."""
    times, length = frame_times(seconds), parameters["length"]
    states = student("simulate", times, np.array(start), **parameters)
    energy = {name: parameters[name] for name in ("mass", "gravity")}
    rod = student.each("wireframe", states, length=length)[:, 0]
    forces = student.make_each(lambda: student.each("constraint_force", states, **parameters))
    shapes = [*_draw(rod, length), *force_shapes(student, states, **parameters, size=0.3 * length)]
    weight = parameters["mass"] * parameters["gravity"] * np.array([0.0, -1.0])
    unit = ARROW * length / (np.linalg.norm(weight) or 1.0)  # m/N
    for force in forces:
        shapes.append(arrow(states[:, :2], unit * weight, 2, "weight", 3))
        shapes.append(arrow(states[:, :2], unit * force, 3, "force of the rod", 4))
    return Scene(
        "Pendulum as a constrained particle",
        "A particle on a rod falls from next to the top of its circle, swings through the bottom almost back to "
        "the top and returns. An arrow shows the force of the rod.",
        times,
        [Panel(shapes)],
        [
            *student.make_each(lambda: state_energy_plot(times, states, 2, partial(student.each, "energy", **energy))),
            *(_pull(times, force, states[:, :2], length) for force in forces),
        ],
        still_time=0.13,
        live=live_if_written(lambda: _live(student, parameters, start)),
    )


def _live(student: StudentModule, parameters: Parameters, start: Sequence[float]) -> Live:
    acceleration, energy = student.function("acceleration"), student.function("energy")

    def rates(t: float, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [*state[2:], *acceleration(state, **parameters)]

    def grab(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        angle = np.arctan2(point[0], point[1])
        return [parameters["length"] * np.sin(angle), parameters["length"] * np.cos(angle), 0.0, 0.0]

    def total(state: Numbers, *, mass: Numbers, length: Numbers, gravity: Numbers) -> Numbers:
        return energy(state, mass=mass, gravity=gravity)

    def drawing(states: Numbers, parameters: Parameters) -> list[Shape]:
        return _draw(moving(np.zeros(2), states[:, :2]), parameters["length"])

    handle = Handle(lambda state, **arguments: state[:2], grab)
    return Live(rates, parameters, start, drawing, [handle], energies(total, 2))


def _draw(rod: Array, length: Numbers) -> list[Shape]:
    """Draw the rod, (n, 2, 2) from the hinge to the particle, and the circle."""
    return [
        Shape("path", length * unit_circle(121), GREY, "the circle", width=1.5),
        Shape("lines", rod, GREY, "rod", width=2),
        Shape("dot", np.zeros((1, 2)), INK, width=5),
        Shape("dot", rod[:, 1:], 1, "particle", width=10),
    ]


def _pull(times: Array, force: Array, particle: Array, length: float) -> TimePlot:
    """Plot the pull of the rod, negative where it pushes; the caption tells if the particle stays on its circle."""
    distance = np.hypot(*particle.T)
    pull = -np.einsum("ni,ni->n", force, particle) / distance
    caption = drift_caption(distance, length, "the length", "distance from the hinge: ")
    return value_plot("pull of the rod", times, {"": pull}, "N", *caption)
