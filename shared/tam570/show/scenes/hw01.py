"""hw01: a large swing by the full equation, and what the small-angle solution makes of it."""

import numpy as np

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

ROD = {"length": 1.0, "gravity": 9.81}  # m, m/s^2
MASS = 1.0  # kg
AMPLITUDE = 2.0  # rad, far from small
SECONDS = 12.0


def film(student: Student) -> Scene:
    """Both let go at rest from the same angle."""
    times, notes = frame_times(SECONDS), list[str]()
    shape = (len(times), 2)
    full = student("simulate", times, AMPLITUDE, 0.0, **ROD, shape=shape)
    small = student("small_angle_solution", times, AMPLITUDE, 0.0, **ROD, shape=shape)
    shapes = [
        Shape("lines", np.array([[-0.3, 0.0], [0.3, 0.0]]), GREY, width=3),
        Shape("path", ROD["length"] * _direction(np.linspace(-AMPLITUDE, AMPLITUDE, 60)), GREY, faint=True),
        *_pendulum(small[:, 0], 1, "small-angle solution"),
        *_pendulum(full[:, 0], 0, "full equation"),
        Shape("dot", np.zeros((1, 2)), INK, width=4),
    ]
    return Scene(
        "Simple pendulum",
        "Two pendulums on one hinge are let go together from far out. The one of the full equation is slower than the "
        "one of the small-angle solution and falls behind it.",
        times,
        [Panel(shapes)],
        make_each(notes, lambda: _energy(student, times, full)),
        notes=notes,
        still_time=0.22,
    )


def _direction(theta: Array) -> Array:
    return np.column_stack([np.sin(theta), -np.cos(theta)])


def _pendulum(theta: Array, color: int, name: str) -> list[Shape]:
    bob = ROD["length"] * _direction(theta)
    return [Shape("lines", moving(np.zeros(2), bob), color, name, width=4), Shape("dot", bob[:, None], color, width=11)]


def _energy(student: Student, times: Array, states: Array) -> TimePlot:
    shown = plot_samples(times)
    _, kinetic, potential = student.each("energy_balance", *states[shown].T, mass=MASS, **ROD, shape=(3,)).T
    title = "energy of the full motion, change since the start"
    return energy_plot(times[shown], kinetic + potential, potential, title)
