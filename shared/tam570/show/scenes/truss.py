"""The lecture `truss`: particles on springs over the rigid body that they make, with a slider for the stiffness."""

from collections.abc import Sequence

import numpy as np

from tam570.integrate import solve
from tam570.show.plots import plot_samples, value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, TimePlot, frame_times, with_slider
from tam570.values import Function, Parameters

__all__ = ["film"]

SHARES = (0.1, 0.3, 1.0, 4.0)  # of the stiffness


def film(rates: Function, rigid: Function, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return a truss that is thrown and turns."""
    times = frame_times(seconds)
    body = rigid(times, start, **parameters)
    stiffness = parameters["stiffness"]

    def scene_with(value: float) -> Scene:
        states = solve(rates, times, start, parameters={**parameters, "stiffness": value}, rtol=1e-6)
        return _one(times, states, body, parameters["bars"])

    return with_slider(scene_with, "stiffness", "N/m", [share * stiffness for share in SHARES], stiffness)


def _one(times: Array, states: Array, body: Array, bars: Sequence[Sequence[int]]) -> Scene:
    half = states.shape[1] // 2
    particles, rigid = (history[:, :half].reshape(len(times), -1, 2) for history in (states, body))
    ends = np.ravel(bars)
    shapes = [
        Shape("lines", rigid[:, ends], GREY, "rigid body", width=7, faint=True),
        Shape("lines", particles[:, ends], 0, "bars", width=2),
        Shape("trail", particles[:, :1], 2, width=1.5),
        Shape("dot", particles, 1, "particles", width=6),
    ]
    return Scene(
        "Truss as a rigid body",
        "Particles that are joined by springs fly and turn. Behind them the rigid body of the same start. The stiffer "
        "the springs, the longer they stay together.",
        times,
        [Panel(shapes)],
        [_apart(times, particles - rigid)],
        still_time=0.3,
    )


def _apart(times: Array, gaps: Array) -> TimePlot:
    shown = plot_samples(times)
    farthest = np.linalg.norm(gaps[shown], axis=2).max(axis=1)
    return value_plot("farthest particle from the rigid body", times[shown], {"": farthest}, "m")
