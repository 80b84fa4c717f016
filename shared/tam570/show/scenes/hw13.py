"""hw13: a cylinder whose centre of mass is not at its centre, and below it its motion by the wrong M_C = I^C phi''."""

import math
from collections.abc import Sequence

import numpy as np

from tam570.integrate import solve
from tam570.loading import Trouble
from tam570.show.diagrams import force_shapes
from tam570.show.drawing import circle, solid
from tam570.show.live import Handle, Live, energies, live_if_written
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, frame_times, moving
from tam570.show.student import StudentModule
from tam570.values import Numbers, Parameters

EXAMPLE = {
    "mass": 1.0,  # kg
    "radius": 0.3,  # m
    "offset": 0.12,  # m
    "inertia": 0.03,  # kg m^2
    "slope": math.radians(4.0),
    "gravity": 9.81,  # m/s^2
}
STATE = {"phi": "rad", "phi_dot": "rad/s"}
START = (0.0, 8.0)  # rad, rad/s: fast enough that the centre of mass passes its highest point
SECONDS = 2.5


def film(student: StudentModule, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the cylinder, which starts with its centre of mass lowest."""
    times = frame_times(seconds)
    correct = student("simulate", times, *start, **parameters)
    wrong = student.make_each(lambda: _naive(student, times, start, parameters))
    farthest = max(float(np.abs(states[:, 0]).max()) for states in (correct, *wrong))
    shapes = _rolling(correct[:, 0], 0, farthest, parameters) + _forces(student, correct[:, 0], parameters)
    panels = [Panel(shapes, "by the balance about G")]
    panels += [
        Panel(_rolling(states[:, 0], 1, farthest, parameters), "as M_C = I^C φ'' would have it") for states in wrong
    ]
    return Scene(
        "Rolling cylinder",
        "A cylinder rolls down a ramp; its centre of mass, beside its centre, draws a wavy line. Below, the same "
        "cylinder as the naive equation has it rolls otherwise.",
        times,
        panels,
        student.make_each(lambda: _energy(student, times, correct, wrong, parameters)),
        still_time=0.7,
        live=live_if_written(lambda: _live(student, parameters, start, farthest)),
    )


def _live(student: StudentModule, parameters: Parameters, start: Sequence[float], farthest: float) -> Live:
    acceleration, energy = student.function("acceleration"), student.function("energy")

    def rates(t: float, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [state[1], acceleration(*state, **parameters)]

    def drawing(states: Numbers, parameters: Parameters) -> list[Shape]:
        return _rolling(states[:, 0], 0, farthest, parameters)

    def centre(state: Numbers, *, radius: Numbers, slope: Numbers, **parameters: Numbers) -> list[Numbers]:
        ahead = radius * state[0]
        return [ahead * np.cos(slope) + radius * np.sin(slope), radius * np.cos(slope) - ahead * np.sin(slope)]

    def grab(
        point: Numbers, state: Numbers, *, radius: Numbers, slope: Numbers, **parameters: Numbers
    ) -> list[Numbers]:
        return [(point[0] * np.cos(slope) - point[1] * np.sin(slope)) / radius, state[1]]

    measures = energies(lambda state, **arguments: energy(*state, **arguments), 1)
    return Live(rates, parameters, start, drawing, [Handle(centre, grab)], measures)


def _naive(student: StudentModule, times: Array, start: Sequence[float], parameters: Parameters) -> Array:
    """Return (n, 2) the motion by the student's naive acceleration."""

    def rates(t: float, state: Array) -> tuple[float, float]:
        return state[1], float(student("naive_contact_acceleration", state[0], **parameters))

    try:
        return solve(rates, times, start, rtol=1e-8)
    except ArithmeticError as error:
        raise Trouble(f"naive_contact_acceleration cannot be integrated: {error}") from error


def _forces(student: StudentModule, phi: Array, parameters: Parameters) -> list[Shape]:
    """Return the forces that the student draws, in axes down and normal to the ramp, from the cylinder's centre."""
    slope, radius = parameters["slope"], parameters["radius"]
    axes = np.array([[np.cos(slope), -np.sin(slope)], [np.sin(slope), np.cos(slope)]])
    arguments = {name: parameters[name] for name in ("mass", "radius", "offset", "slope", "gravity")}
    origin = np.column_stack([radius * phi, np.full_like(phi, radius)]) @ axes
    return force_shapes(student, phi, size=1.2 * radius, origin=origin, axes=axes, **arguments)


def _rolling(phi: Array, color: int, farthest: float, parameters: Parameters) -> list[Shape]:
    radius, offset, slope = (parameters[name] for name in ("radius", "offset", "slope"))
    ahead = np.array([np.cos(slope), -np.sin(slope)])
    off = np.array([-ahead[1], ahead[0]])
    contact = radius * phi[:, None] * ahead
    centre = contact + radius * off
    across, down = -_turned(ahead, phi), -_turned(off, phi)
    mass = centre + offset * down
    end = radius * (farthest + 1.5)
    return [
        Shape("lines", np.array([-radius * ahead, end * ahead]), GREY, width=3),
        *solid(circle(centre, radius * across, radius * down), color, width=2.5),
        Shape("lines", moving(centre, centre + radius * down), color, width=1.5),
        Shape("trail", mass[:, None], 2, width=2),
        Shape("dot", centre[:, None], INK, width=3),
        Shape("dot", mass[:, None], 2, "centre of mass", width=7),
    ]


def _turned(vector: Array, phi: Array) -> Array:
    """Return (n, 2) a vector turned clockwise by phi, as by a cylinder that rolls to the right."""
    c, s = np.cos(phi), np.sin(phi)
    return np.column_stack([c * vector[0] + s * vector[1], c * vector[1] - s * vector[0]])


def _energy(
    student: StudentModule, times: Array, correct: Array, wrong: list[Array], parameters: Parameters
) -> TimePlot:
    motions = dict(zip(("by G", "naive"), [correct, *wrong], strict=False))
    total = {name: student.each("energy", *states.T, **parameters) for name, states in motions.items()}
    at_rest = student.each("energy", correct[:, 0], 0 * times, **parameters)
    largest = float(np.abs(total["by G"] - at_rest).max())
    caption = drift_caption(total["by G"], largest, "the largest kinetic energy", "by G: ")
    return value_plot("energy", times, total, "J", *caption)
