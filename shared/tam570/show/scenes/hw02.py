"""hw02: throws at several angles, by the numerical solution and by the closed form."""

import math
from collections.abc import Mapping

import numpy as np

from tam570.loading import Trouble
from tam570.show.diagrams import force_shapes
from tam570.show.plots import gap_caption, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times
from tam570.show.student import StudentModule
from tam570.values import Parameters

EXAMPLE = {"speed": 50.0, "mass": 1.0, "drag": 0.2, "gravity": 9.81}  # m/s, kg, kg/s, m/s^2
ANGLES = (15, 30, 60, 75)  # degrees, beside the best
LONGEST = 100.0  # s, of a flight; this ball falls for 8 s at most
LARGE = 1e-3  # of the range: a pixel


def film(student: StudentModule, parameters: Parameters) -> Scene:
    """Return the scene of balls that fly until they are back at launch height."""
    speed, ball = parameters["speed"], {name: parameters[name] for name in ("mass", "drag", "gravity")}
    best = student("best_angle", speed, **ball)
    angles = sorted([*map(math.radians, ANGLES), best])
    flights = [student("flight_time", speed, angle, **ball) for angle in angles]
    times = frame_times(1.1 * max(flights))
    motions = [_both(student, times, angle, flight, speed, ball) for angle, flight in zip(angles, flights, strict=True)]
    pairs = [(numerical[:, :2], closed[:, :2]) for numerical, closed in motions]
    shapes = [part for angle, pair in zip(angles, pairs, strict=True) for part in _throw(*pair, angle == best)]
    farthest = max(closed[:, 0].max() for _, closed in pairs)
    ground = Shape("lines", np.array([[0.0, 0.0], [1.02 * farthest, 0.0]]), GREY, width=2)
    gaps = np.max([np.linalg.norm(numerical - closed, axis=1) for numerical, closed in pairs], axis=0)
    caption = gap_caption(float(gaps.max()) / farthest, LARGE, " of the range", "from the closed form: ")
    heights = {f"{math.degrees(a):.0f}°": numerical[:, 1] for a, (numerical, _) in zip(angles, pairs, strict=True)}
    forces = force_shapes(student, motions[angles.index(best)][0], size=0.08 * farthest, **ball)
    return Scene(
        "Ballistics with drag",
        f"Balls leave one point together at {len(angles)} angles and land one after the other; the farthest is the one "
        f"at {math.degrees(best):.1f} degrees. The numerical solution runs on the curve of the closed form.",
        times,
        [Panel([ground, *shapes, *forces])],
        [value_plot("height", times, heights, "m", *caption)],
        still_time=0.45,
    )


def _both(
    student: StudentModule, times: Array, angle: float, flight: float, speed: float, ball: Mapping[str, float]
) -> tuple[Array, Array]:
    """Return (n, 4) states by each solution; after it has landed, the ball does not move."""
    if not 0.0 < flight < LONGEST:
        raise Trouble(f"flight_time gives {flight} s at {math.degrees(angle):.0f} degrees and {speed} m/s")
    flown = np.append(times[times < flight], flight)
    landed = np.minimum(np.arange(len(times)), len(flown) - 1)
    numerical = student("simulate", flown, speed, angle, **ball)
    closed = student("trajectory", flown, speed, angle, **ball)
    return numerical[landed], closed[landed]


def _throw(numerical: Array, closed: Array, best: bool) -> list[Shape]:
    color, name, size = (2, "numerical, at the best angle", 6) if best else (0, "numerical", 4)
    return [
        Shape("path", closed[::3], INK, width=1, faint=True),
        Shape("trail", numerical[:, None], color, name, width=size / 2.5),
        Shape("dot", closed[:, None], 1, "closed form", width=size + 3),
        Shape("dot", numerical[:, None], color, width=size),
    ]
