"""hw13: a cylinder whose centre of mass is not at its centre, and below it what M_C = I^C phi'' would make of it."""

import math
from typing import Any

import numpy as np

from tam570.integrate import solve
from tam570.show.drawing import circle
from tam570.show.scene import (
    GREY,
    INK,
    Array,
    Panel,
    Scene,
    Shape,
    TimePlot,
    drift_plot,
    frame_times,
    moving,
    plot_samples,
)
from tam570.show.student import Student, Trouble, make_each

__all__ = ["film"]

BODY: dict[str, Any] = {"mass": 1.0, "radius": 0.3, "offset": 0.12, "inertia": 0.03}  # kg, m, m, kg m^2
RAMP: dict[str, Any] = {"slope": math.radians(4.0), "gravity": 9.81}  # rad, m/s^2
START = (0.0, 8.0)  # rad, rad/s: enough to roll over the place where the centre of mass is highest
SECONDS = 2.5
DOWN = np.array([math.cos(RAMP["slope"]), -math.sin(RAMP["slope"])])
OFF = np.array([-DOWN[1], DOWN[0]])


def film(student: Student) -> Scene:
    """Pushed off with the centre of mass lowest."""
    times, notes = frame_times(SECONDS), list[str]()
    right = student("simulate", times, *START, **BODY, **RAMP, shape=(len(times), 2))
    wrong = make_each(notes, lambda: _naive(student, times))
    farthest = max(float(np.abs(states[:, 0]).max()) for states in (right, *wrong))
    panels = [Panel(_rolling(right[:, 0], 0, farthest), "by the balance about G")]
    panels += [Panel(_rolling(states[:, 0], 1, farthest), "as M_C = I^C φ'' would have it") for states in wrong]
    return Scene(
        "Rolling cylinder",
        "A cylinder rolls down a ramp; its centre of mass, beside its centre, draws a wavy line. Below, the same "
        "cylinder as the naive equation has it rolls otherwise.",
        times,
        panels,
        make_each(notes, lambda: _energy(student, times, right, wrong)),
        notes=notes,
        still_time=0.7,
    )


def _naive(student: Student, times: Array) -> Array:
    """(n, 2) the motion by the student's naive acceleration."""

    def rates(t: float, state: Array) -> tuple[float, float]:
        return state[1], float(student("naive_contact_acceleration", state[0], **BODY, **RAMP, shape=()))

    try:
        return solve(rates, times, START, rtol=1e-8)
    except ArithmeticError as error:
        raise Trouble(f"naive_contact_acceleration cannot be integrated: {error}") from error


def _rolling(phi: Array, color: int, farthest: float) -> list[Shape]:
    radius, offset = BODY["radius"], BODY["offset"]
    contact = radius * phi[:, None] * DOWN
    centre = contact + radius * OFF
    across, down = -_turned(DOWN, phi), -_turned(OFF, phi)
    mass = centre + offset * down
    end = radius * (farthest + 1.5)
    return [
        Shape("lines", np.array([-radius * DOWN, end * DOWN]), GREY, width=3),
        Shape("fill", circle(centre, radius * across, radius * down), color, faint=True),
        Shape("path", circle(centre, radius * across, radius * down), color, width=2.5),
        Shape("lines", moving(centre, centre + radius * down), color, width=1.5),
        Shape("trail", mass[:, None], 2, width=2),
        Shape("dot", centre[:, None], INK, width=3),
        Shape("dot", mass[:, None], 2, "centre of mass", width=7),
    ]


def _turned(vector: Array, phi: Array) -> Array:
    """(n, 2) a vector turned clockwise, as what rolls down to the right turns."""
    c, s = np.cos(phi), np.sin(phi)
    return np.column_stack([c * vector[0] + s * vector[1], c * vector[1] - s * vector[0]])


def _energy(student: Student, times: Array, right: Array, wrong: list[Array]) -> TimePlot:
    shown = plot_samples(times)
    motions = dict(zip(("by G", "naive"), [right, *wrong], strict=False))
    total = {name: student.each("energy", *states[shown].T, **BODY, **RAMP) for name, states in motions.items()}
    at_rest = student.each("energy", right[shown, 0], 0 * shown, **BODY, **RAMP)
    scale = float(np.abs(total["by G"] - at_rest).max()) or 1.0
    title, of = "energy, change since the start", "the largest kinetic energy"
    return drift_plot(title, times[shown], {"by G": total.pop("by G")}, scale, of, beside=total)
