"""The lecture `stopping_car`: cars side by side, with different wheels locked."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from tam570.show.scene import GREY, Array, Panel, Scene, Shape, frame_times, moving

__all__ = ["film"]

LOCKED = ("front", "rear", "both")
SPEED = 12.0  # m/s
WHEEL = 0.3  # m


def film(by_one_point: Any, parameters: Mapping[str, Any]) -> Scene:
    """What cannot brake without lifting an axle is a note."""
    found: dict[str, tuple[float, float, float]] = {}
    notes = []
    for locked in LOCKED:
        try:
            found[locked] = by_one_point(**{**parameters, "locked": locked})
        except ValueError as error:
            if locked == parameters["locked"]:
                raise
            notes.append(f"{locked} locked: {error}")
    slowest = min(d for d, _, _ in found.values())
    times = frame_times(min(1.2 * SPEED / slowest, 10.0) if slowest else 5.0)
    size = 1.6 * (parameters["front"] + parameters["rear"])
    shapes = []
    for row, (locked, motion) in enumerate(found.items()):
        shapes += _car(times, motion, parameters, locked, -row * size / 2 - row * parameters["height"])
    return Scene(
        "Stopping car",
        "Cars brake side by side from one speed, with the front wheels, the rear wheels, or both locked. Upright "
        "arrows show the loads on the axles; the front one carries more the harder the car brakes.",
        times,
        [Panel(shapes)],
        notes=notes,
        still_time=0.2,
    )


def _car(
    times: Array, motion: tuple[float, float, float], parameters: Mapping[str, Any], locked: str, y: float
) -> list[Shape]:
    deceleration, front_load, rear_load = motion
    moves = np.minimum(times, SPEED / deceleration) if deceleration else times
    x = SPEED * moves - deceleration * moves**2 / 2
    at = np.column_stack([x, np.full_like(x, y)])  # below G
    tips = {"front": np.array([parameters["front"], 0.0]), "rear": np.array([-parameters["rear"], 0.0])}
    top = np.array([0.0, 2 * parameters["height"] + WHEEL])
    body = [at + tips["rear"] + [-0.5, WHEEL], at + tips["front"] + [0.5, WHEEL]]
    outline = moving(*body, body[1] + top / 2, at + top, body[0] + top)
    color = LOCKED.index(locked)
    loads = {"front": front_load, "rear": rear_load}
    shapes = [
        Shape(
            "lines", np.array([[-parameters["rear"] - 1.0, y], [x[-1] + parameters["front"] + 1.0, y]]), GREY, width=1
        ),
        Shape("fill", outline, color, faint=True),
        Shape("path", np.concatenate([outline, outline[:, :1]], axis=1), color, f"locked: {locked}", width=2),
        Shape("dot", (at + [0.0, parameters["height"]])[:, None], 4, "G", width=4),
    ]
    for axle, tip in tips.items():
        width = 9 if locked in (axle, "both") else 5
        shapes.append(Shape("dot", (at + tip + [0.0, WHEEL / 2])[:, None], color, width=width))
        lift = np.array([0.0, 2.0 * loads[axle] / parameters["gravity"]])
        shapes.append(Shape("arrow", moving(at + tip, at + tip + lift), 3, "load", width=2.5))
    return shapes
