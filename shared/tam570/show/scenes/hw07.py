"""hw07: the two bars, and the path of the tip."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from tam570.show.diagrams import force_shapes
from tam570.show.scene import (
    GREY,
    INK,
    Array,
    Panel,
    Scene,
    Shape,
    TimePlot,
    energy_plot,
    frame_times,
    moving,
    plot_samples,
    value_plot,
)
from tam570.show.student import Student, make_each

__all__ = ["film"]

EXAMPLE = {"masses": (1.0, 1.0), "lengths": (1.0, 1.0), "gravity": 9.81}  # kg, m, m/s^2
STATE = {"theta1": "rad", "theta2": "rad", "omega1": "rad/s", "omega2": "rad/s"}
START = (math.pi / 2, math.pi / 2, 0.0, 0.0)  # part (d): at rest, both bars level
SECONDS = 20.0


def film(student: Student, parameters: Mapping[str, Any], start: Sequence[float], seconds: float) -> Scene:
    """The motion of part (d)."""
    times, notes = frame_times(seconds), list[str]()
    known = {name: np.array(value) for name, value in parameters.items() if name != "gravity"}
    known["gravity"] = parameters["gravity"]
    theta, omega = np.array(start[:2]), np.array(start[2:])
    states = student("simulate", times, theta, omega, **known, shape=(len(times), 4))
    bars = student.each("wireframe", states[:, :2], lengths=known["lengths"], shape=(2, 2, 2))
    hinge, elbow, tip = bars[:, 0, 0], bars[:, 1, 0], bars[:, 1, 1]
    shapes = [
        Shape("lines", np.array([[-0.4, 0.0], [0.4, 0.0]]), GREY, width=3),
        Shape("trail", tip[:, None], 2, "path of the tip", width=1.5),
        Shape("lines", bars[:, 0], 0, "bar 1", width=6),
        Shape("lines", bars[:, 1], 1, "bar 2", width=6),
        Shape("dot", moving(hinge, elbow), INK, width=5),
        Shape("dot", tip[:, None], 2, width=5),
        *(one for shapes in make_each(notes, lambda: _forces(student, states, known)) for one in shapes),
    ]
    return Scene(
        "Double pendulum",
        "Two bars hang one below the other from a hinge. They start level and at rest, fall, and tumble; a trail "
        "shows the path of the tip.",
        times,
        [Panel(shapes)],
        [*make_each(notes, lambda: _energy(student, times, states, known)), _angles(times, states)],
        notes=notes,
    )


def _forces(student: Student, states: Array, known: Mapping[str, Any]) -> list[Shape]:
    """The forces that the student draws on either bar."""
    length, shapes = 0.3 * float(np.mean(known["lengths"])), list[Shape]()
    for bar in (1, 2):
        rows = [bar] * len(states), states[:, :2]
        shapes += force_shapes(student, *rows, length=length, color=bar + 2, label=f"forces on bar {bar}", **known)
    return shapes


def _energy(student: Student, times: Array, states: Array, known: Mapping[str, Any]) -> TimePlot:
    shown = plot_samples(times)
    theta, omega = states[shown, :2], states[shown, 2:]
    total = student.each("energy", theta, omega, **known)
    return energy_plot(times[shown], total, student.each("energy", theta, 0 * omega, **known))


def _angles(times: Array, states: Array) -> TimePlot:
    shown = plot_samples(times)
    return value_plot("angles", times[shown], {"θ1": states[shown, 0], "θ2": states[shown, 1]}, "rad")
