"""hw05: the particle on its circle, by Cartesian coordinates."""

from typing import Any

import numpy as np

from tam570.show.drawing import unit_circle
from tam570.show.scene import (
    GREY,
    INK,
    Array,
    Panel,
    Scene,
    Shape,
    TimePlot,
    drift_plot,
    energy_plot,
    frame_times,
    moving,
    plot_samples,
)
from tam570.show.student import Student, make_each

__all__ = ["film"]

MASS, LENGTH, GRAVITY = 1.0, 1.0, 9.81  # kg, m, m/s^2
ABOVE = 0.1  # rad from the very top
SECONDS = 12.0
ARROW = 0.15  # m, of the weight


def film(student: Student) -> Scene:
    """Let go at rest next to the top."""
    times, notes = frame_times(SECONDS), list[str]()
    start = np.array([LENGTH * np.sin(ABOVE), LENGTH * np.cos(ABOVE), 0.0, 0.0])
    known: dict[str, Any] = {"mass": MASS, "length": LENGTH, "gravity": GRAVITY}
    states = student("simulate", times, start, **known, shape=(len(times), 4))
    rod = student.each("wireframe", states, length=LENGTH, shape=(1, 2, 2))[:, 0]
    shapes = [
        Shape("path", LENGTH * unit_circle(121), GREY, "the circle", width=1.5),
        Shape("lines", rod, GREY, "rod", width=2),
        *make_each(notes, lambda: _force(student, states, known)),
        Shape("dot", np.zeros((1, 2)), INK, width=5),
        Shape("dot", rod[:, 1:], 1, "particle", width=10),
    ]
    return Scene(
        "Pendulum as a constrained particle",
        "A particle on a rod falls from next to the top of its circle, swings through the bottom almost back to "
        "the top and returns. An arrow shows the force of the rod.",
        times,
        [Panel(shapes)],
        make_each(notes, lambda: _energy(student, times, states), lambda: _radius(times, states)),
        notes=notes,
        still_time=0.13,
    )


def _force(student: Student, states: Array, known: dict[str, Any]) -> Shape:
    force = student.each("constraint_force", states, **known, shape=(2,)) / (MASS * GRAVITY)
    return Shape("arrow", moving(states[:, :2], states[:, :2] + ARROW * force), 3, "constraint force", width=4)


def _energy(student: Student, times: Array, states: Array) -> TimePlot:
    shown = plot_samples(times)
    at_rest = states[shown] * [1, 1, 0, 0]
    known: dict[str, Any] = {"mass": MASS, "gravity": GRAVITY}
    total, potential = (student.each("energy", rows, **known) for rows in (states[shown], at_rest))
    return energy_plot(times[shown], total, potential)


def _radius(times: Array, states: Array) -> TimePlot:
    shown = plot_samples(times)
    distance = np.hypot(*states[shown, :2].T)
    return drift_plot("distance from the hinge, change", times[shown], {"": distance}, LENGTH, "the length")
