"""The lecture `planet`: an orbit, and beside it Newton's polygon of impulses with a slider for their number."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from tam570.integrate import solve
from tam570.show.plots import drift_plot, plot_samples
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, frame_times, moving, with_slider
from tam570.values import Function, Numbers

__all__ = ["film"]

IMPULSES = (12, 18, 30, 60)  # in the time of one orbit, or of the scene if that is shorter
FIRST = 18


def film(
    rates: Function, elements: Function, parameters: Mapping[str, float], start: Sequence[float], seconds: float
) -> Scene:
    """Return all in the plane of the orbit, its x axis towards the planet at the start."""
    times = frame_times(seconds)
    states = solve(rates, times, start, parameters=parameters, rtol=1e-9)
    period = min(elements(start, **parameters)["period"], seconds)
    return with_slider(
        lambda count: _one(times, _in_plane(states), period, int(count), parameters["gm"]),
        "impulses",
        "",
        IMPULSES,
        FIRST,
    )


def _in_plane(states: Array) -> Array:
    """(n, 4) positions and velocities in the plane of the first ones."""
    r, v = states[0, :3], states[0, 3:]
    along = r / np.linalg.norm(r)
    across = v - (v @ along) * along
    size = np.linalg.norm(across)
    plane = np.array([along, across / size if size else np.zeros(3)]).T
    return np.hstack([states[:, :3] @ plane, states[:, 3:] @ plane])


def _one(times: Array, states: Array, period: float, count: int, gm: float) -> Scene:
    step = period / count
    corners = _polygon(states[0], step, int(times[-1] / step) + 2, gm)
    part, share = np.divmod(times / step, 1.0)
    last = part.astype(int)
    newton = corners[last] + share[:, None] * (corners[last + 1] - corners[last])
    orbit = states[:, :2]
    passed = np.column_stack([np.interp(step * np.arange(last[-1] + 1), times, x) for x in orbit.T])
    return Scene(
        "Planet, and Newton's polygon of impulses",
        "On the left a planet goes round the sun on an ellipse. On the right it moves straight on for equal times and "
        "gets an impulse towards the sun after each. Rays from the sun at these times cut off equal areas on both "
        "sides. With more impulses the polygon comes closer to the ellipse.",
        times,
        [
            Panel(_scene(passed, count, last, orbit, 0, "planet"), "attracted at all times"),
            Panel(_scene(corners[:-1], count, last, newton, 1, "planet of the polygon"), "by impulses"),
        ],
        [_areas(times, orbit, newton, states)],
        still_time=0.3,
    )


def _polygon(start: Array, step: float, count: int, gm: float) -> Array:
    """(count, 2) corners. Half an impulse at the first makes the velocity there that of the start."""
    r, v, corners = start[:2], start[2:], []
    for number in range(count):
        corners.append(r)
        impulse = -gm * step * r / np.linalg.norm(r) ** 3
        v = v + (impulse if number else impulse / 2)
        r = r + step * v
    return np.array(corners)


def _scene(corners: Array, count: int, last: NDArray[np.int64], planet: Array, color: int, name: str) -> list[Shape]:
    """Return the planet, rays to the corners, and the area that has been swept since the last of them."""
    seen = corners[: count + 1]  # of the first orbit
    rays = np.stack([np.zeros_like(seen), seen], axis=1).reshape(-1, 2)
    return [
        Shape("lines", rays, GREY, width=1, faint=True),
        Shape("fill", moving(np.zeros(2), corners[last], planet), color, faint=True),
        Shape("trail", planet[:, None], color, width=2),
        Shape("dot", np.zeros((1, 2)), 4, "sun", width=9),
        Shape("dot", planet[:, None], color, name, width=7),
    ]


def _areas(times: Array, orbit: Array, newton: Array, states: Array) -> Numbers:
    shown = plot_samples(times)
    swept = {name: _swept(path)[shown] for name, path in {"attracted": orbit, "polygon": newton}.items()}
    rate = float(states[0, 0] * states[0, 3] - states[0, 1] * states[0, 2]) / 2
    total = abs(rate) * times[-1] or 1.0
    off = {name: area - rate * times[shown] for name, area in swept.items()}
    return drift_plot("area swept, less equal areas", times[shown], off, total, "all of it")


def _swept(path: Array) -> Array:
    """(n,) area that the ray from the sun has swept, by triangles."""
    (x, y), (nx, ny) = path[:-1].T, path[1:].T
    return np.concatenate([[0.0], np.cumsum(x * ny - y * nx) / 2])
