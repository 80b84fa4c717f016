"""hw12: the bead on the parabolic wire."""

from typing import Any

import numpy as np

from tam570.show.scene import GREY, Array, Panel, Scene, Shape, TimePlot, energy_plot, frame_times, moving, plot_samples
from tam570.show.student import Student, make_each

__all__ = ["film"]

WIRE: dict[str, Any] = {"curvature": 0.8, "gravity": 9.81}  # 1/m, m/s^2
MASS = 1.0  # kg
START = 1.2  # m
SECONDS = 10.0
ARROW = 0.25  # m, of the weight


def film(student: Student) -> Scene:
    """Let go at rest."""
    times, notes = frame_times(SECONDS), list[str]()
    states = student("simulate", times, START, 0.0, **WIRE, shape=(len(times), 2))
    bead = _on_wire(states[:, 0])
    reach = max(1.15 * START, 1.02 * float(np.abs(states[:, 0]).max()))
    shapes = [
        Shape("path", _on_wire(np.linspace(-reach, reach, 161)), GREY, "wire", width=3),
        *make_each(notes, lambda: _force(student, states)),
        Shape("dot", bead[:, None], 0, "bead", width=10),
    ]
    return Scene(
        "Bead on a wire",
        "A bead slides without friction on a wire in the shape of a parabola, from one side to the other and back. An "
        "arrow, across the wire, shows the force of the wire.",
        times,
        [Panel(shapes)],
        make_each(notes, lambda: _energy(student, times, states)),
        notes=notes,
        still_time=0.03,
    )


def _force(student: Student, states: Array) -> Shape:
    force = student.each("constraint_force", *states.T, mass=MASS, **WIRE, shape=(2,)) / (MASS * WIRE["gravity"])
    bead = _on_wire(states[:, 0])
    return Shape("arrow", moving(bead, bead + ARROW * force), 3, "force of the wire", width=2.5)


def _on_wire(x: Array) -> Array:
    return np.column_stack([x, WIRE["curvature"] * x**2])


def _energy(student: Student, times: Array, states: Array) -> TimePlot:
    shown = plot_samples(times)
    x, v = states[shown].T
    total = student.each("energy", x, v, mass=MASS, **WIRE)
    return energy_plot(times[shown], total, student.each("energy", x, 0 * v, mass=MASS, **WIRE))
