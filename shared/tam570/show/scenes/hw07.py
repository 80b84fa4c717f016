"""hw07: the two bars, and the path of the tip."""

import math
from collections.abc import Sequence

import numpy as np

from tam570.show.diagrams import force_shapes
from tam570.show.live import Live, energies, live_if_written
from tam570.show.plots import state_energy_plot, value_plot
from tam570.show.rods import joints, rod_handles
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times, moving
from tam570.show.student import StudentModule
from tam570.values import Json, Numbers, Parameters

EXAMPLE = {"masses": (1.0, 1.0), "lengths": (1.0, 1.0), "gravity": 9.81}  # kg, m, m/s^2
STATE = {"theta1": "rad", "theta2": "rad", "omega1": "rad/s", "omega2": "rad/s"}
START = (math.pi / 2, math.pi / 2, 0.0, 0.0)  # part (d): at rest, both bars level
SECONDS = 20.0


def film(student: StudentModule, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the motion of part (d)."""
    times = frame_times(seconds)
    arguments = _as_arrays(**parameters)
    theta, omega = np.array(start[:2]), np.array(start[2:])
    states = student("simulate", times, theta, omega, **arguments)
    bars = student.each("wireframe", states[:, :2], lengths=arguments["lengths"])

    def energy(rows: Array) -> Array:
        return student.each("energy", rows[:, :2], rows[:, 2:], **arguments)

    shapes, size = _bars(bars[:, 0], bars[:, 1]), 0.3 * float(np.mean(arguments["lengths"]))
    for bar in (1, 2):
        rows = [bar] * len(times), states[:, :2]
        shapes += force_shapes(student, *rows, size=size, color=bar + 2, label=f"forces on bar {bar}", **arguments)
    return Scene(
        "Double pendulum",
        "Two bars hang one below the other from a hinge. They start level and at rest, fall, and tumble; a trail "
        "shows the path of the tip.",
        times,
        [Panel(shapes)],
        [
            *student.make_each(lambda: state_energy_plot(times, states, 2, energy)),
            value_plot("angles", times, {"θ1": states[:, 0], "θ2": states[:, 1]}, "rad"),
        ],
        live=live_if_written(lambda: _live(student, parameters, start)),
    )


def _as_arrays(*, masses: Numbers, lengths: Numbers, gravity: Numbers) -> Json:
    return {"masses": np.array(masses), "lengths": np.array(lengths), "gravity": gravity}


def _live(student: StudentModule, parameters: Parameters, start: Sequence[float]) -> Live:
    acceleration, energy = student.function("angular_acceleration"), student.function("energy")

    def rates(t: float, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [*state[2:], *acceleration(np.array(state[:2]), np.array(state[2:]), **_as_arrays(**parameters))]

    def drawing(states: Numbers, parameters: Parameters) -> list[Shape]:
        elbow, tip = joints(states[:, :2].T, parameters["lengths"])
        hinge = np.zeros_like(elbow)
        return _bars(*(moving(*ends) for ends in ((hinge, elbow), (elbow, tip))))

    def total(state: Numbers, **parameters: Numbers) -> Numbers:
        return energy(np.array(state[:2]), np.array(state[2:]), **_as_arrays(**parameters))

    handles = rod_handles(2, lambda parameters: parameters["lengths"])
    return Live(rates, parameters, start, drawing, handles, energies(total, 2))


def _bars(first: Array, second: Array) -> list[Shape]:
    """Draw both bars, (n, 2, 2) from upper to lower end."""
    hinge, elbow, tip = first[:, 0], second[:, 0], second[:, 1]
    return [
        Shape("lines", np.array([[-0.4, 0.0], [0.4, 0.0]]), GREY, width=3),
        Shape("trail", tip[:, None], 2, "path of the tip", width=1.5),
        Shape("lines", first, 0, "bar 1", width=6),
        Shape("lines", second, 1, "bar 2", width=6),
        Shape("dot", moving(hinge, elbow), INK, width=5),
        Shape("dot", tip[:, None], 2, width=5),
    ]
