"""hw04: the mass on its spring in space, the ellipse, and the student's projections of the path."""

from collections.abc import Sequence
from functools import partial
from math import pi

import numpy as np

from tam570.show.diagrams import force_shapes
from tam570.show.drawing import axes, circle
from tam570.show.live import Live, drag, energies, live_if_written
from tam570.show.plots import state_energy_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times, moving
from tam570.show.student import StudentModule
from tam570.values import Numbers, Parameters

EXAMPLE = {"mass": 1.0, "stiffness": 8.0, "gravity": 9.81}  # kg, N/m, m/s^2
STATE = {"x": "m", "y": "m", "z": "m", "vx": "m/s", "vy": "m/s", "vz": "m/s"}
START = (1.0, 0.2, -0.6, -0.6, 2.2, 1.5)  # in no special direction
SECONDS = 8.0
VIEWS = {"by project(), along x": (0.0, 0.0), "by project(), from above": (-pi / 2, pi / 2)}  # rad


def film(student: StudentModule, spring: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the mass in space, and of two projections at right angles."""
    times = frame_times(seconds)
    r, v = np.array(start[:3]), np.array(start[3:])
    states = student("simulate", times, r, v, **spring)
    shapes = [
        *student.make_each(lambda: _ellipse(student, r, v, spring)),
        *_draw(states, spring),
        *force_shapes(student, states, **spring, size=0.5, origin=(0.0, 0.0, 0.0)),
    ]
    flat = student.make_each(*(lambda title=title: _projected(student, states[:, :3], title) for title in VIEWS))
    return Scene(
        "Mass on a zero-rest-length spring",
        "A mass on a spring from the origin goes round an ellipse in space, again and again. Beside it the same path, "
        "projected on two planes at right angles.",
        times,
        [Panel(shapes), *flat],
        student.make_each(lambda: state_energy_plot(times, states, 3, partial(student.each, "energy", **spring))),
        view=(0.6, 0.4),
        still_time=0.2,
        live=live_if_written(lambda: _live(student, spring, start)),
    )


def _live(student: StudentModule, spring: Parameters, start: Sequence[float]) -> Live:
    measures = energies(student.function("energy"), 3)
    return Live(student.function("state_derivative"), spring, start, _draw, [drag(0, 3)], measures)


def _draw(states: Numbers, spring: Parameters) -> list[Shape]:
    mass = states[:, :3]
    return [
        *axes(0.5),
        Shape("trail", mass[:, None], 2, "path", width=2),
        Shape("lines", moving(np.zeros(3), mass), 0, "spring", width=3),
        Shape("dot", np.zeros((1, 3)), INK, width=4),
        Shape("dot", mass[:, None], 1, "mass", width=9),
    ]


def _ellipse(student: StudentModule, r: Array, v: Array, spring: Parameters) -> Shape:
    centre, semi_axes = student("orbit", r, v, **spring)
    return Shape("path", circle(centre, *semi_axes), GREY, "ellipse of orbit()", width=5, faint=True)


def _projected(student: StudentModule, mass: Array, title: str) -> Panel:
    path = student("project", mass, *VIEWS[title])
    hook = student("project", np.zeros((1, 3)), *VIEWS[title])
    shapes = [
        Shape("trail", path[:, None], 2, width=2),
        Shape("lines", moving(hook[0], path), 0, width=3),
        Shape("dot", hook, INK, width=4),
        Shape("dot", path[:, None], 1, width=9),
    ]
    return Panel(shapes, title)
