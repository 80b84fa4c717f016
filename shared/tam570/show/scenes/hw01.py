"""hw01: a large swing by the full equation, and by the small-angle solution."""

from collections.abc import Sequence

import numpy as np

from tam570.show.diagrams import force_shapes
from tam570.show.drawing import graph, unit_circle
from tam570.show.live import Live, live_if_written
from tam570.show.plots import energy_plot, value_plot
from tam570.show.rods import rod_handles
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, frame_times, moving
from tam570.show.student import StudentModule
from tam570.values import Function, Numbers, Parameters

EXAMPLE = {"length": 1.0, "gravity": 9.81}  # m, m/s^2
STATE = {"theta": "rad", "omega": "rad/s"}
START = (2.0, 0.0)  # rad, rad/s: not a small angle
SECONDS = 12.0
MASS = 1.0  # kg


def film(student: StudentModule, rod: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of both pendulums, released from the same angle."""
    times = frame_times(seconds)
    full = student("simulate", times, *start, **rod)
    small = student("small_angle_solution", times, *start, **rod)
    length = rod["length"]
    shapes = [
        Shape("lines", np.array([[-0.3, 0.0], [0.3, 0.0]]) * length, GREY, width=3),
        Shape("path", length * unit_circle(121), GREY, width=1, faint=True),
        Shape("lines", np.array([[0.0, 0.0], [0.0, -1.1 * length]]), GREY, width=1),
        *_pendulum(length, small[:, 0], 1, "small-angle solution"),
        *_draw(full, rod),
        *force_shapes(student, *full.T, mass=MASS, **rod, size=0.3 * length),
    ]
    return Scene(
        "Simple pendulum",
        "Two pendulums on one hinge are let go together from far out. The one of the full equation is slower than the "
        "one of the small-angle solution and falls behind it. Beside them both run round in the phase plane.",
        times,
        [Panel(shapes), Panel(_phase_plane(full, small), "phase plane", ruler=False)],
        [
            value_plot("angle θ", times, {"full": full[:, 0], "small-angle": small[:, 0]}, "rad"),
            *student.make_each(lambda: _energy(student, times, full, rod)),
        ],
        still_time=0.22,
        live=live_if_written(lambda: _live(student, rod, start)),
    )


def _live(student: StudentModule, rod: Parameters, start: Sequence[float]) -> Live:
    """Return the equations, by the student's balance of angular momentum, with energies by that of energy."""
    balance, energies = student.function("angular_momentum_balance"), student.function("energy_balance")

    def rates(t: float, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [state[1], balance(*state, mass=MASS, **parameters)[0]]

    def measure(i: int) -> Function:
        return lambda state, **parameters: energies(*state, mass=MASS, **parameters)[i]

    def total(state: Numbers, **parameters: Numbers) -> Numbers:
        _, kinetic, potential = energies(*state, mass=MASS, **parameters)
        return kinetic + potential

    measures = {"total E": total, "kinetic T": measure(1), "potential V": measure(2)}
    handles = rod_handles(1, lambda parameters: [parameters["length"]])
    return Live(rates, rod, start, _draw, handles, measures)


def _draw(states: Numbers, rod: Parameters) -> list[Shape]:
    hook = Shape("dot", np.zeros((1, 2)), INK, width=4)
    return [*_pendulum(rod["length"], states[:, 0], 0, "full equation"), hook]


def _pendulum(length: float, theta: Array, color: int, name: str) -> list[Shape]:
    bob = length * np.column_stack([np.sin(theta), -np.cos(theta)])
    return [Shape("lines", moving(np.zeros(2), bob), color, name, width=4), Shape("dot", bob[:, None], color, width=11)]


def _phase_plane(full: Array, small: Array) -> list[Shape]:
    axes, to_points = graph([full[:, 0], small[:, 0]], [full[:, 1], small[:, 1]], ("θ", "ω"), height=1.0)
    shapes = [*axes]
    for states, color in ((small, 1), (full, 0)):
        way = to_points(*states.T)[:, None]
        shapes += [Shape("trail", way, color, width=1.5), Shape("dot", way, color, width=6)]
    return shapes


def _energy(student: StudentModule, times: Array, states: Array, rod: Parameters) -> TimePlot:
    _, kinetic, potential = student.each("energy_balance", *states.T, mass=MASS, **rod).T
    return energy_plot(times, kinetic + potential, potential, "energy of the full motion")
