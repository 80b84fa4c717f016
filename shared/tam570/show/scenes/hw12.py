"""hw12: the bead on the parabolic wire."""

from collections.abc import Sequence
from functools import partial

import numpy as np

from tam570.show.diagrams import force_shapes
from tam570.show.live import Handle, Live, energies, live_if_written
from tam570.show.plots import state_energy_plot, value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, arrow, frame_times
from tam570.show.student import StudentModule
from tam570.values import Numbers, Parameters

EXAMPLE = {"mass": 1.0, "curvature": 0.8, "gravity": 9.81}  # kg, 1/m, m/s^2
STATE = {"x": "m", "v": "m/s"}
START = (1.2, 0.0)
SECONDS = 10.0
ARROW = 0.4  # m, of the weight


def film(student: StudentModule, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the bead, with the forces on it as a polygon that m a closes."""
    times = frame_times(seconds)
    wire = {name: parameters[name] for name in ("curvature", "gravity")}
    states = student("simulate", times, *start, **wire)
    reach = max(1.15 * abs(start[0]), 1.02 * float(np.abs(states[:, 0]).max()))
    shapes = [
        *_draw(reach, states, parameters),
        *(shape for three in student.make_each(lambda: _forces(student, states, parameters)) for shape in three),
        *force_shapes(student, states[:, 0], size=ARROW, **parameters),
    ]

    def energy(rows: Array) -> Array:
        return student.each("energy", *rows.T, **parameters)

    return Scene(
        "Bead on a wire",
        "A bead slides without friction on a wire in the shape of a parabola, from one side to the other and back. "
        "Arrows show its weight, the force of the wire, which is across the wire, and their sum, m a.",
        times,
        [Panel(shapes)],
        [
            *student.make_each(lambda: state_energy_plot(times, states, 1, energy)),
            value_plot("x and v", times, {"x (m)": states[:, 0], "v (m/s)": states[:, 1]}, ""),
        ],
        still_time=0.03,
        live=live_if_written(lambda: _live(student, parameters, start, reach)),
    )


def _live(student: StudentModule, parameters: Parameters, start: Sequence[float], reach: float) -> Live:
    acceleration, energy = student.function("acceleration_newton"), student.function("energy")

    def rates(t: float, state: Numbers, *, mass: Numbers, curvature: Numbers, gravity: Numbers) -> list[Numbers]:
        return [state[1], acceleration(*state, curvature=curvature, gravity=gravity)]

    handle = Handle(
        lambda state, **arguments: [state[0], arguments["curvature"] * state[0] ** 2],
        lambda point, state, **arguments: [point[0], 0.0],
    )
    measures = energies(lambda state, **arguments: energy(*state, **arguments), 1)
    return Live(rates, parameters, start, partial(_draw, reach), [handle], measures)


def _draw(reach: float, states: Array, parameters: Parameters) -> list[Shape]:
    """Draw the bead on its wire, which extends `reach` to both sides, m."""
    bead = _on_wire(states[:, 0], parameters["curvature"])
    wire = _on_wire(np.linspace(-reach, reach, 81), parameters["curvature"])
    return [Shape("path", wire, GREY, "wire", width=3), Shape("dot", bead[:, None], 0, "bead", width=8)]


def _forces(student: StudentModule, states: Array, parameters: Parameters) -> list[Shape]:
    weight = parameters["mass"] * parameters["gravity"] * np.array([0.0, -1.0])
    force = student.each("constraint_force", *states.T, **parameters)
    unit = ARROW / (np.linalg.norm(weight) or 1.0)  # m/N
    bead = _on_wire(states[:, 0], parameters["curvature"])
    return [
        arrow(bead, unit * weight, 2, "weight"),
        arrow(bead + unit * weight, unit * force, 3, "force of the wire"),
        arrow(bead, unit * (weight + force), 1, "sum: m a"),
    ]


def _on_wire(x: Array, curvature: float) -> Array:
    return np.column_stack([x, curvature * x**2])
