"""29 Aug, 5 Sept: A ball thrown through air, with drag in proportion to the square of its speed.

x is level, y up. The drag -c |v| v points against the velocity, so m x'' = -c |v| x', m y'' = -m g - c |v| y'. The path
has no closed form; the velocity has one integral, found by dividing the equations by each other: with the slope
p = vy/vx it is d(1/vx^2)/dp = -2 (c/(m g)) sqrt(1 + p^2), the hodograph (Johann Bernoulli, 1719).
"""

from collections.abc import Mapping, Sequence
from math import asinh, copysign, hypot, inf, isfinite, sqrt

import numpy as np

from tam570.arguments import nonnegative, positive, sequence
from tam570.integrate import solve
from tam570.show.live import Live, drag, energies
from tam570.show.plots import value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, frame_times, with_slider
from tam570.values import Numbers

STATE = {"x": "m", "y": "m", "vx": "m/s", "vy": "m/s"}
EXAMPLE = {"mass": 5.0, "drag": 0.01, "gravity": 9.81}  # kg, kg/m, m/s^2: a cannon ball
START = (0.0, 0.0, 90.0, 90.0)
SECONDS = 20.0
SLIDER = (0.3, 1.0, 3.0, 10.0, 30.0)  # factors on the drag


def rates(t: float, state: Sequence[float], *, mass: float, drag: float, gravity: float) -> tuple[float, ...]:
    """Return (4,) velocity, m/s, and acceleration, m/s^2. Without drag (0) the path is a parabola."""
    _check(mass, drag, gravity)
    sequence(4, state=state)
    _, _, vx, vy = state
    slowing = drag / mass * sqrt(vx * vx + vy * vy)  # 1/s
    return vx, vy, -slowing * vx, -gravity - slowing * vy


def terminal_speed(*, mass: float, drag: float, gravity: float) -> float:
    """Return the speed, m/s, at which the drag equals the weight."""
    positive(mass=mass, drag=drag)
    nonnegative(gravity=gravity)
    return sqrt(mass * gravity / drag)


def hodograph(state: Sequence[float], *, mass: float, drag: float, gravity: float) -> float:
    """1/vx^2 + (drag/(mass gravity)) (p sqrt(1 + p^2) + asinh p), p = vy/|vx|, s^2/m^2; infinite where vx = 0."""
    _check(mass, drag, gravity)
    positive(gravity=gravity)
    sequence(4, state=state)
    across = abs(float(state[2]))
    p = float(state[3]) / across if across else inf
    return across**-2 + drag / (mass * gravity) * (p * hypot(1.0, p) + asinh(p)) if isfinite(p) else inf


INVARIANTS = {"hodograph": hodograph}


def _check(mass: float, drag: float, gravity: float) -> None:
    positive(mass=mass)
    nonnegative(drag=drag, gravity=gravity)


def film(parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of a cannon ball: as the Middle Ages thought, on a parabola, and with drag, with a slider."""
    drag = parameters["drag"]
    drags = [share * drag for share in SLIDER] if drag else []
    return with_slider(lambda c: _three_balls({**parameters, "drag": c}, start, seconds), "drag", "kg/m", drags, drag)


def _three_balls(parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    times = frame_times(seconds)
    states = solve(rates, times, start, parameters=parameters, rtol=1e-8)
    falls = np.outer(times**2 / 2, [0.0, -parameters["gravity"]])
    parabola = np.add(start[:2], np.outer(times, start[2:]) + falls)
    paths = {"parabola": _landed(parabola), "with drag": _landed(states[:, :2])}
    paths["as in the Middle Ages"] = _out_then_down(times, start, paths["with drag"], parameters)
    colors = dict(zip(paths, (0, 2, 1), strict=True))
    caption = f"terminal speed {terminal_speed(**parameters):.3g} m/s" if parameters["drag"] else "no drag"
    ground = Shape("lines", np.array([start[:2], [paths["parabola"][-1, 0], start[1]]]), GREY)
    measures = energies(_energy, 2)
    return Scene(
        "Cannon ball",
        "Three balls leave one point together. One flies on a parabola. One flies through air, where it falls more "
        "steeply than it rose. One flies as in the Middle Ages, straight out and then straight down. The more drag "
        "there is, the more the second looks like the third.",
        times,
        [Panel([ground, *_flights(paths, colors, labelled=True)], "as far as they go"), *_shapes(paths, colors)],
        [value_plot("speed through air", times, {"": np.hypot(*states[:, 2:].T)}, "m/s", caption)],
        still_time=0.45,
        live=Live(rates, parameters, start, _draw, [drag(0, 2)], measures, conserved=False, backdrop=[ground]),
    )


def _draw(states: Array, parameters: Mapping[str, float]) -> list[Shape]:
    ball = states[:, None, :2]
    return [Shape("trail", ball, 2, "with drag", width=2), Shape("dot", ball, 2, width=7)]


def _energy(state: Numbers, *, mass: Numbers, gravity: Numbers, **parameters: Numbers) -> Numbers:
    """Return the energy, J, relative to rest at y = 0, which drag decreases."""
    _, y, vx, vy = state
    return mass * (gravity * y + (vx * vx + vy * vy) / 2)


def _landed(path: Array) -> Array:
    """Return (n, 2) the path, which ends where it comes back to the height of its start."""
    below = np.flatnonzero(path[1:, 1] < path[0, 1]) + 1
    if path[1, 1] <= path[0, 1] or not len(below):
        return path
    before, after = path[below[0] - 1], path[below[0]]
    share = (before[1] - path[0, 1]) / (before[1] - after[1])
    return np.where(np.arange(len(path))[:, None] < below[0], path, before + share * (after - before))


def _out_then_down(times: Array, start: Sequence[float], real: Array, parameters: Mapping[str, float]) -> Array:
    """Return (n, 2) a path straight on at the start's velocity as far as the real ball, then down at terminal speed."""
    x, y, vx, vy = start
    turn = abs((real[-1, 0] - x) / vx) if vx else 0.0
    out = np.minimum(times, turn)
    down = (times - out) * (terminal_speed(**parameters) if parameters["drag"] else 0.0)
    return _landed(np.column_stack([x + vx * out, y + vy * out - down]))


def _flights(paths: Mapping[str, Array], colors: Mapping[str, int], *, labelled: bool) -> list[Shape]:
    trails = [
        Shape("trail", path[:, None], colors[name], name if labelled else "", width=2.5) for name, path in paths.items()
    ]
    return [*trails, *(Shape("dot", path[:, None], colors[name], width=7) for name, path in paths.items())]


def _shapes(paths: Mapping[str, Array], colors: Mapping[str, int]) -> list[Panel]:
    """Return a panel of the paths, each scaled by its range; none if one goes straight up."""
    ranges = {name: path[-1, 0] - path[0, 0] for name, path in paths.items()}
    if not all(ranges.values()):
        return []
    shapes = {name: (path - path[0]) / abs(ranges[name]) for name, path in paths.items()}
    along = copysign(1.0, ranges["parabola"])
    ground = Shape("lines", np.array([[0.0, 0.0], [along, 0.0]]), GREY)
    return [Panel([ground, *_flights(shapes, colors, labelled=False)], "each as a share of its range", ruler=False)]
