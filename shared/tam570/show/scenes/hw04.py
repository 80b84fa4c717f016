"""hw04: the mass on its spring in space, the ellipse, and the student's own projection of the path."""

from typing import Any

import numpy as np

from tam570.show.drawing import axes, circle
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
)
from tam570.show.student import Student, make_each

__all__ = ["film"]

SPRING: dict[str, Any] = {"mass": 1.0, "stiffness": 8.0, "gravity": 9.81}  # kg, N/m, m/s^2
START = np.array([1.0, 0.2, -0.6])  # m
VELOCITY = np.array([-0.6, 2.2, 1.5])  # m/s
EYE = (0.6, 0.4)  # rad, azimuth and elevation of the projection
SECONDS = 8.0


def film(student: Student) -> Scene:
    """A start in no special direction."""
    times, notes = frame_times(SECONDS), list[str]()
    states = student("simulate", times, START, VELOCITY, **SPRING, shape=(len(times), 6))
    mass = states[:, :3]
    shapes = [
        *axes(0.5),
        *make_each(notes, lambda: _ellipse(student)),
        Shape("trail", mass[:, None], 2, "path", width=2),
        Shape("lines", moving(np.zeros(3), mass), 0, "spring", width=3),
        Shape("dot", np.zeros((1, 3)), INK, width=4),
        Shape("dot", mass[:, None], 1, "mass", width=9),
    ]
    flat = make_each(notes, lambda: _projected(student, mass))
    return Scene(
        "Mass on a zero-rest-length spring",
        "A mass on a spring from the origin goes round an ellipse in space, again and again. Beside it the same path, "
        "projected on a plane.",
        times,
        [Panel(shapes), *flat],
        make_each(notes, lambda: _energy(student, times, states)),
        view=EYE,
        notes=notes,
        still_time=0.2,
    )


def _ellipse(student: Student) -> Shape:
    centre, semi_axes = student.group("orbit", START, VELOCITY, **SPRING, shapes=((3,), (2, 3)))
    return Shape("path", circle(centre, *semi_axes), GREY, "ellipse of orbit()", width=5, faint=True)


def _projected(student: Student, mass: Array) -> Panel:
    path = student("project", mass, *EYE, shape=(len(mass), 2))
    hook = student("project", np.zeros((1, 3)), *EYE, shape=(1, 2))
    shapes = [
        Shape("trail", path[:, None], 2, width=2),
        Shape("lines", moving(hook[0], path), 0, width=3),
        Shape("dot", hook, INK, width=4),
        Shape("dot", path[:, None], 1, width=9),
    ]
    return Panel(shapes, "by project()")


def _energy(student: Student, times: Array, states: Array) -> TimePlot:
    shown = plot_samples(times)
    total = student.each("energy", states[shown], **SPRING)
    at_rest = states[shown] * [1, 1, 1, 0, 0, 0]
    return energy_plot(times[shown], total, student.each("energy", at_rest, **SPRING))
