"""The lecture `least_action`: a pendulum's paths between two angles, drawn over time, and their actions."""

from collections.abc import Callable
from functools import partial
from math import pi, sqrt
from types import SimpleNamespace

import numpy as np

from tam570.arguments import positive
from tam570.show.drawing import graph
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, moving, with_slider
from tam570.values import Parameters

SIZE = 1.0  # m, of the picture: width of the graph, length of the pendulums
NEIGHBOURS = np.linspace(-0.3, 0.3, 7)  # rad, bumps added to the swing
SAME = 1e-3  # rad, below which two paths are the same


def film(lecture: SimpleNamespace, parameters: Parameters) -> Scene:
    """Return the scene with a slider for the time in which the pendulum goes from a to b."""
    pendulum = {name: parameters[name] for name in ("length", "gravity")}
    positive(**pendulum)
    half = pi * sqrt(parameters["length"] / parameters["gravity"])  # s
    values = [round(share * half, 1) for share in (0.5, 0.95, 1.05, 1.4)]

    def make(duration: float) -> Scene:
        ends = parameters["a"], parameters["b"]
        least = lecture.path(*ends, duration, points=parameters["points"], **pendulum)
        swing = lecture.swing(least, duration, **pendulum)
        return _paths(least, swing, duration, partial(lecture.action, duration=duration, **pendulum))

    return with_slider(make, "time from a to b", "s", values, parameters["duration"])


def _paths(least: Array, swing: Array, duration: float, action: Callable[[Array], float]) -> Scene:
    """Return the scene of the swing, which is a motion, among its neighbours, and of the path of least action.

    least, swing : (n,) rad at even times over duration, s
    action       : of such a path, m^2/s
    """
    times = np.linspace(0.0, duration, len(least))
    bump = np.sin(np.pi * times / duration)
    tallest = max(float(np.abs(path).max()) for path in (least, swing)) + float(NEIGHBOURS.max())
    neighbours = [swing + size * bump for size in NEIGHBOURS]

    def drawn(path: Array) -> Array:
        return np.column_stack([SIZE * times / duration, 0.5 * SIZE * path / tallest])

    graph = [
        Shape("lines", np.array([[0.0, 0.0], [SIZE, 0.0]]), GREY, width=1),
        *(Shape("path", drawn(path), GREY, width=1) for path in neighbours),
        Shape("path", drawn(swing), 1, "the swing", width=3),
        Shape("path", drawn(least), 0, "path of least action", width=3),
        Shape("dot", drawn(least)[[0, -1]], INK, width=6),
        Shape("dot", drawn(swing)[:, None], 1, width=8),
        Shape("dot", drawn(least)[:, None], 0, width=8),
    ]
    return Scene(
        "Path of least action",
        "Left, angles over time: a pendulum's swing between two angles, and neighbours of it with the same ends. "
        "Before half a period the swing has the least action of all. Later another path has less, and is a motion too.",
        times,
        [
            Panel(graph, "angle over time", ruler=False),
            Panel([*_pendulum(swing, 1), *_pendulum(least, 0)], "the pendulums", ruler=False),
            _actions(times, least, swing, action),
        ],
        still_time=0.6,
    )


def _actions(times: Array, least: Array, swing: Array, action: Callable[[Array], float]) -> Panel:
    """Return a graph of the action over the size of a bump that is added to the swing."""
    sizes, bump = np.linspace(-1.0, 1.0, 41), np.sin(np.pi * times / times[-1])
    values = np.array([action(swing + size * bump) for size in sizes])
    axes, to_points = graph(sizes, values, ("size of the bump (rad)", "action"))
    same = np.abs(least - swing).max() < SAME
    shapes = [
        *axes,
        Shape("path", to_points(sizes, values), 1, width=2.5),
        Shape("dot", to_points([0.0], [action(swing)]), 1, width=6),
    ]
    title = "action: the swing has the least" if same else "action: the swing has not the least"
    return Panel(shapes, title, ruler=False)


def _pendulum(path: Array, color: int) -> list[Shape]:
    bob = SIZE * np.column_stack([np.sin(path), -np.cos(path)])
    return [
        Shape("lines", moving(np.zeros(2), bob), color, width=3),
        Shape("dot", bob[:, None], color, width=11),
        Shape("dot", np.zeros((1, 2)), INK, width=4),
    ]
