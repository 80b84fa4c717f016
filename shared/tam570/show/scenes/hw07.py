"""hw07: the two bars, and the path of the tip."""

import math
from collections.abc import Sequence

import numpy as np

from tam570.show.diagrams import force_shapes
from tam570.show.live import Handle, Live, live_if_written
from tam570.show.plots import energy_plot, plot_samples, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, frame_times, moving
from tam570.show.student import Student, make_each
from tam570.values import Numbers, Parameters

__all__ = ["film"]

EXAMPLE = {"masses": (1.0, 1.0), "lengths": (1.0, 1.0), "gravity": 9.81}  # kg, m, m/s^2
STATE = {"theta1": "rad", "theta2": "rad", "omega1": "rad/s", "omega2": "rad/s"}
START = (math.pi / 2, math.pi / 2, 0.0, 0.0)  # part (d): at rest, both bars level
SECONDS = 20.0


def film(student: Student, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the motion of part (d)."""
    times, notes = frame_times(seconds), list[str]()
    arguments = {name: np.array(value) for name, value in parameters.items() if name != "gravity"}
    arguments["gravity"] = parameters["gravity"]
    theta, omega = np.array(start[:2]), np.array(start[2:])
    states = student("simulate", times, theta, omega, **arguments, shape=(len(times), 4))
    bars = student.each("wireframe", states[:, :2], lengths=arguments["lengths"], shape=(2, 2, 2))
    hinge, elbow, tip = bars[:, 0, 0], bars[:, 1, 0], bars[:, 1, 1]
    shapes = [
        Shape("lines", np.array([[-0.4, 0.0], [0.4, 0.0]]), GREY, width=3),
        Shape("trail", tip[:, None], 2, "path of the tip", width=1.5),
        Shape("lines", bars[:, 0], 0, "bar 1", width=6),
        Shape("lines", bars[:, 1], 1, "bar 2", width=6),
        Shape("dot", moving(hinge, elbow), INK, width=5),
        Shape("dot", tip[:, None], 2, width=5),
        *_forces(notes, student, states, arguments),
    ]
    return Scene(
        "Double pendulum",
        "Two bars hang one below the other from a hinge. They start level and at rest, fall, and tumble; a trail "
        "shows the path of the tip.",
        times,
        [Panel(shapes)],
        [*make_each(notes, lambda: _energy(student, times, states, arguments)), _angles(times, states)],
        notes=notes,
        live=live_if_written(lambda: _live(student, parameters, start)),
    )


def _forces(notes: list[str], student: Student, states: Array, parameters: Parameters) -> list[Shape]:
    """Return the forces that the student draws on either bar."""
    size, shapes = 0.3 * float(np.mean(parameters["lengths"])), list[Shape]()
    for bar in (1, 2):
        shapes += force_shapes(
            notes,
            student,
            *([bar] * len(states), states[:, :2]),
            size=size,
            color=bar + 2,
            label=f"forces on bar {bar}",
            **parameters,
        )
    return shapes


def _live(student: Student, parameters: Parameters, start: Sequence[float]) -> Live:
    acceleration, energy = student.function("angular_acceleration"), student.function("energy")

    def rates(t: float, state: Numbers, *, masses: Numbers, lengths: Numbers, gravity: Numbers) -> list[Numbers]:
        parameters = {"masses": np.array(masses), "lengths": np.array(lengths), "gravity": gravity}
        return [*state[2:], *acceleration(np.array(state[:2]), np.array(state[2:]), **parameters)]

    def joints(theta: Numbers, lengths: Numbers) -> tuple[Numbers, Numbers]:
        first, second = (
            length * np.array([np.sin(th), -np.cos(th)]) for length, th in zip(lengths, theta, strict=True)
        )
        return first, first + second

    def panels(states: Numbers, parameters: Parameters) -> list[Panel]:
        elbow, tip = (end[None] for end in joints(states[0, :2], parameters["lengths"]))
        shapes = [
            Shape("lines", np.array([[-0.4, 0.0], [0.4, 0.0]]), GREY, width=3),
            Shape("trail", tip[:, None], 2, "path of the tip", width=1.5),
            Shape("lines", moving(np.zeros(2), elbow), 0, "bar 1", width=6),
            Shape("lines", moving(elbow, tip), 1, "bar 2", width=6),
            Shape("dot", moving(np.zeros(2), elbow), INK, width=5),
            Shape("dot", tip[:, None], 2, width=5),
        ]
        return [Panel(shapes)]

    def grab_elbow(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [np.arctan2(point[0], -point[1]), state[1], 0.0, 0.0]

    def grab_tip(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        elbow, _ = joints(state[:2], parameters["lengths"])
        return [state[0], np.arctan2(point[0] - elbow[0], elbow[1] - point[1]), 0.0, 0.0]

    handles = [
        Handle(lambda state, **arguments: joints(state[:2], arguments["lengths"])[0], grab_elbow),
        Handle(lambda state, **arguments: joints(state[:2], arguments["lengths"])[1], grab_tip),
    ]

    def total(state: Numbers, *, masses: Numbers, lengths: Numbers, gravity: Numbers) -> Numbers:
        parameters = {"masses": np.array(masses), "lengths": np.array(lengths), "gravity": gravity}
        return energy(np.array(state[:2]), np.array(state[2:]), **parameters)

    def at_rest(state: Numbers, **parameters: Numbers) -> Numbers:
        return total([*state[:2], 0.0, 0.0], **parameters)

    return Live(rates, parameters, STATE, start, panels, handles, {"total E": total, "potential V": at_rest})


def _energy(student: Student, times: Array, states: Array, parameters: Parameters) -> TimePlot:
    shown = plot_samples(times)
    theta, omega = states[shown, :2], states[shown, 2:]
    total = student.each("energy", theta, omega, **parameters)
    return energy_plot(times[shown], total, student.each("energy", theta, 0 * omega, **parameters))


def _angles(times: Array, states: Array) -> TimePlot:
    shown = plot_samples(times)
    return value_plot("angles", times[shown], {"θ1": states[shown, 0], "θ2": states[shown, 1]}, "rad")
