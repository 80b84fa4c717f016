"""The lecture `truss`: particles joined by springs, over a rigid body of the same shape, with a stiffness slider."""

from collections.abc import Sequence
from types import SimpleNamespace

import numpy as np

from tam570.integrate import solve
from tam570.show.live import Live, drag, energies
from tam570.show.plots import value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, frame_times, with_slider
from tam570.values import Parameters

SHARES = (0.1, 0.3, 1.0, 4.0)  # of the stiffness


def film(lecture: SimpleNamespace, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of a truss that is thrown and turns."""
    times = frame_times(seconds)
    body = lecture.rigid(times, start, **parameters)
    stiffness, half = parameters["stiffness"], len(start) // 2
    rigid = body[:, :half].reshape(len(times), -1, 2)
    rigid_body = Shape("lines", rigid[:, np.ravel(parameters["bars"])], GREY, "rigid body", width=7, faint=True)
    handles, measures = [drag(i, 2) for i in range(0, half, 2)], energies(lecture.energy, half)

    def scene_with(value: float) -> Scene:
        arguments = {**parameters, "stiffness": value}
        states = solve(lecture.rates, times, start, parameters=arguments, rtol=1e-6)
        farthest = np.linalg.norm(states[:, :half].reshape(rigid.shape) - rigid, axis=2).max(axis=1)
        return Scene(
            "Truss as a rigid body",
            "Particles that are joined by springs fly and turn. Behind them the rigid body of the same start. The "
            "stiffer the springs, the longer they stay together.",
            times,
            [Panel([rigid_body, *_draw(states, arguments)])],
            [value_plot("farthest particle from the rigid body", times, {"": farthest}, "m")],
            still_time=0.3,
            live=Live(lecture.rates, arguments, start, _draw, handles, measures),
        )

    return with_slider(scene_with, "stiffness", "N/m", [share * stiffness for share in SHARES], stiffness)


def _draw(states: Array, parameters: Parameters) -> list[Shape]:
    particles = np.reshape(states[:, : states.shape[1] // 2], (len(states), -1, 2))
    return [
        Shape("lines", particles[:, np.ravel(parameters["bars"])], 0, "bars", width=2),
        Shape("trail", particles[:, :1], 2, width=1.5),
        Shape("dot", particles, 1, "particles", width=6),
    ]
