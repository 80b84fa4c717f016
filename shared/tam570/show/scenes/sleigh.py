"""The lecture `sleigh`: pushed with G behind the blade, it turns round; a slider changes its speed."""

from collections.abc import Mapping, Sequence
from types import SimpleNamespace

import numpy as np

from tam570.integrate import solve
from tam570.show.drawing import graph, placed, solid, unit_circle
from tam570.show.live import Handle, Live, drag, energies
from tam570.show.plots import drift_caption, value_plot, values
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, frame_times, moving, with_slider
from tam570.values import Numbers

SHARES = (0.6, 0.8, 1.0, 1.25)  # of the speed
OUTLINE = np.array([[-0.4, -0.35], [1.3, -0.35], [1.7, 0.0], [1.3, 0.35], [-0.4, 0.35]])  # in offsets


def film(lecture: SimpleNamespace, parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    """Return the scene with a slider that scales speed and yaw rate together: the same motion, faster."""
    times, offset, k = frame_times(seconds), parameters["offset"], lecture.gyration(**parameters)
    size = offset or k
    measures, handles = energies(lecture.energy), [drag(0, 2), Handle(_nose, _turn_to)]
    total = 180.0 * k / abs(offset) if offset else float("inf")
    most = f"at most pi k/offset = {total:.4g} degrees" if offset else "G at the blade: it turns for ever"

    def drawing(states: Array, parameters: Mapping[str, float]) -> list[Shape]:
        return _sleigh(states, parameters["offset"], size)

    def scene_at(speed: float) -> Scene:
        share = speed / start[3] if start[3] else 1.0
        begin = (*start[:3], speed, share * start[4])
        states = solve(lecture.rates, times, begin, parameters=parameters, rtol=1e-8)
        rates = {"speed": states[:, 3], "k yaw rate": k * states[:, 4]}
        turned = np.degrees(states[:, 2] - states[0, 2])
        caption = drift_caption(values(lecture.energy, states, **parameters), of="the energy")
        return Scene(
            "Chaplygin's sleigh",
            "A sleigh on ice glides on one blade that cannot slip sideways. It starts with its centre of mass behind "
            "the blade, turns round, and goes on straight with its centre of mass ahead. However fast it is, it turns "
            "by one angle.",
            times,
            [Panel(drawing(states, parameters)), Panel(_phase_plane(states, offset, k), "phase plane", ruler=False)],
            [
                value_plot("turned", times, {"": turned}, "degrees", most),
                value_plot("speed, and k times yaw rate", times, rates, "m/s", *caption),
            ],
            still_time=0.5,
            live=Live(lecture.rates, parameters, begin, drawing, handles, measures),
        )

    speeds = [share * start[3] for share in SHARES] if start[3] else []
    return with_slider(scene_at, "push", "m/s", speeds, start[3])


def _sleigh(states: Array, offset: float, size: float) -> list[Shape]:
    blade, heading = states[:, :2], states[:, 2]
    ahead = np.column_stack([np.cos(heading), np.sin(heading)])
    return [
        Shape("trail", blade[:, None], 2, "path of the blade", width=2),
        *solid(placed(size * OUTLINE, blade, heading), 0, "sleigh"),
        Shape("lines", moving(blade - 0.3 * size * ahead, blade + 0.3 * size * ahead), 1, "blade", width=5),
        Shape("dot", (blade + offset * ahead)[:, None], 4, "G", width=6),
    ]


def _nose(state: Numbers, *, offset: Numbers, **parameters: Numbers) -> list[Numbers]:
    return [state[0] + 1.7 * offset * np.cos(state[2]), state[1] + 1.7 * offset * np.sin(state[2])]


def _turn_to(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
    return [*state[:2], np.arctan2(point[1] - state[1], point[0] - state[0]), *state[3:]]


def _phase_plane(states: Array, offset: float, k: float) -> list[Shape]:
    """Return a graph of speed and yaw rate: a motion follows an ellipse of its energy, from backward to forward."""
    V = float(np.hypot(states[0, 3], k * states[0, 4])) or 1.0
    levels = V * np.array([0.4, 0.7, 1.0, 1.3])[:, None, None] * unit_circle(61) / [1.0, k]
    axes, to_points = graph(levels[..., 0], levels[..., 1], ("speed", "yaw rate"))
    ahead, back = (to_points(levels[:, i, 0], 0.0) for i in (0, 30))  # straight motion: the yaw rate stays 0
    stable, unstable = (ahead, back) if offset >= 0 else (back, ahead)
    way = to_points(states[:, 3], states[:, 4])[:, None]
    return [
        *axes,
        *(Shape("path", to_points(*level.T), GREY, width=1) for level in levels),
        Shape("dot", stable, 2, "straight, G ahead: stable", width=5),
        Shape("dot", unstable, 3, "straight, G behind: unstable", width=5),
        Shape("trail", way, 1, width=2.5),
        Shape("dot", way, 0, "now", width=7),
    ]
