"""The lecture on Hamilton's principle: a pendulum's paths between two angles, drawn over time, and their actions."""

from collections.abc import Callable

import numpy as np

from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, moving, value_plot

__all__ = ["paths"]

SIZE = 1.0  # m, of the picture: width of the graph, length of the pendulums
NEIGHBOURS = np.linspace(-0.3, 0.3, 7)  # rad, bumps added to the swing
SAME = 1e-3  # rad, between two paths that are one


def paths(least: Array, swing: Array, duration: float, action: Callable[[Array], float]) -> Scene:
    """The swing, which is a motion, among its neighbours; and the path of least action.

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
        ],
        [_actions(times, least, swing, action)],
        still_time=0.6,
    )


def _actions(times: Array, least: Array, swing: Array, action: Callable[[Array], float]) -> TimePlot:
    """The actions as steady lines: what each path takes from a to b, more than the least."""
    lowest = action(least)
    more = {
        "swing": action(swing) - lowest,
        "swing + 0.2 bump": action(swing + 0.2 * np.sin(np.pi * times / times[-1])) - lowest,
        "swing - 0.2 bump": action(swing - 0.2 * np.sin(np.pi * times / times[-1])) - lowest,
    }
    same = np.abs(least - swing).max() < SAME
    note = "the swing is the path of least action" if same else "another motion has less action than the swing"
    ends = times[[0, -1]]
    return value_plot(
        "action above the least, for the whole way", ends, {n: [v, v] for n, v in more.items()}, "m²/s", note
    )


def _pendulum(path: Array, color: int) -> list[Shape]:
    bob = SIZE * np.column_stack([np.sin(path), -np.cos(path)])
    return [
        Shape("lines", moving(np.zeros(2), bob), color, width=3),
        Shape("dot", bob[:, None], color, width=11),
        Shape("dot", np.zeros((1, 2)), INK, width=4),
    ]
