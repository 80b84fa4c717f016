"""The lecture `planet`: an orbit, and beside it Newton's polygon of impulses with a slider for their number."""

from collections.abc import Mapping, Sequence
from math import sqrt
from types import SimpleNamespace

import numpy as np
from numpy.typing import NDArray

from tam570.integrate import solve
from tam570.show.live import Handle, Live, energies
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, drawable_rate, frame_times, moving, with_slider
from tam570.values import Numbers, Parameters

IMPULSES = (12, 18, 30, 60)  # in the time of one orbit, or of the scene if that is shorter
FIRST = 18


def film(lecture: SimpleNamespace, parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    """Return the scene in the plane of the orbit, with the x axis towards the planet at the start."""
    period = min(lecture.elements(start, **parameters)["period"], seconds)
    drawable_rate("gm at this start", sqrt(parameters["gm"] / float(np.linalg.norm(start[:3])) ** 3))
    times = frame_times(seconds)
    states = solve(lecture.rates, times, start, parameters=parameters, rtol=1e-9)
    plane = _plane(states[0])
    flat = np.hstack([states[:, :3] @ plane.T, states[:, 3:] @ plane.T])
    orbit, measures = flat[:, :2], energies(lecture.energy, 3)
    rate = float(flat[0, 0] * flat[0, 3] - flat[0, 1] * flat[0, 2]) / 2  # m^2/s, of the area

    def drawing(states: Array, parameters: Parameters) -> list[Shape]:
        return _planet(states[:, :3] @ plane.T, 0, "planet")

    def grab(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [*(np.array(point[:2]) @ plane), *state[3:]]

    handle = Handle(lambda state, **parameters: plane @ np.array(state[:3]), grab)

    def scene_with(count: float) -> Scene:
        step = period / count
        corners = _polygon(flat[0], step, int(times[-1] / step) + 2, parameters["gm"])
        part, share = np.divmod(times / step, 1.0)
        last = part.astype(int)
        newton = corners[last] + share[:, None] * (corners[last + 1] - corners[last])
        swept = {"attracted": _swept(orbit), "polygon": _swept(newton)}
        off = {name: area - rate * times for name, area in swept.items()}
        caption = drift_caption(off, abs(rate) * times[-1] or 1.0, "all of it", "from equal areas: ")
        passed = np.column_stack([np.interp(step * np.arange(last[-1] + 1), times, x) for x in orbit.T])
        attracted = _scene(passed, int(count), last, orbit, 0, "planet")
        still = [shape for shape in attracted if shape.points.ndim == 2]
        return Scene(
            "Planet, and Newton's polygon of impulses",
            "On the left a planet goes round the sun on an ellipse. On the right it moves straight on for equal times "
            "and gets an impulse towards the sun after each. Rays from the sun at these times cut off equal areas on "
            "both sides. With more impulses the polygon comes closer to the ellipse.",
            times,
            [
                Panel(attracted, "attracted at all times"),
                Panel(_scene(corners[:-1], int(count), last, newton, 1, "planet of the polygon"), "by impulses"),
            ],
            [value_plot("area swept", times, swept, "m²", *caption)],
            still_time=0.3,
            live=Live(lecture.rates, parameters, start, drawing, [handle], measures, backdrop=still),
        )

    return with_slider(scene_with, "impulses", "", IMPULSES, FIRST)


def _plane(state: Array) -> Array:
    """Return (2, 3) unit vectors that span the plane of the orbit, the first towards the planet."""
    r, v = state[:3], state[3:]
    along = r / np.linalg.norm(r)
    across = v - (v @ along) * along
    size = np.linalg.norm(across)
    return np.array([along, across / size if size else np.zeros(3)])


def _polygon(start: Array, step: float, count: int, gm: float) -> Array:
    """Return (count, 2) corners. The first impulse is halved, so that the mean velocity there is that of the start."""
    r, v, corners = start[:2], start[2:], []
    for number in range(count):
        corners.append(r)
        impulse = -gm * step * r / np.linalg.norm(r) ** 3
        v = v + (impulse if number else impulse / 2)
        r = r + step * v
    return np.array(corners)


def _scene(corners: Array, count: int, last: NDArray[np.int64], planet: Array, color: int, name: str) -> list[Shape]:
    """Return the planet, rays to the corners, and the area swept since the last corner."""
    seen = corners[: count + 1]  # of the first orbit
    rays = np.stack([np.zeros_like(seen), seen], axis=1).reshape(-1, 2)
    return [
        Shape("lines", rays, GREY, width=1, faint=True),
        Shape("fill", moving(np.zeros(2), corners[last], planet), color, faint=True),
        Shape("dot", np.zeros((1, 2)), 4, "sun", width=9),
        *_planet(planet, color, name),
    ]


def _planet(path: Array, color: int, name: str) -> list[Shape]:
    return [Shape("trail", path[:, None], color, width=2), Shape("dot", path[:, None], color, name, width=7)]


def _swept(path: Array) -> Array:
    """Return (n,) the area that the ray from the sun has swept, as a sum of triangles."""
    (x, y), (nx, ny) = path[:-1].T, path[1:].T
    return np.concatenate([[0.0], np.cumsum(x * ny - y * nx) / 2])
