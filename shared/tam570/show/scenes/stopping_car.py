"""The lecture `stopping_car`: cars side by side, with different wheels locked."""

from collections.abc import Mapping
from types import SimpleNamespace

import numpy as np

from tam570.arguments import one_of
from tam570.show.drawing import solid
from tam570.show.plots import value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, arrow, frame_times, moving
from tam570.values import Parameters

LOCKED = ("front", "rear", "both")
SPEED = 12.0  # m/s
WHEEL = 0.3  # m


def film(lecture: SimpleNamespace, parameters: Parameters) -> Scene:
    """Return the scene of braking cars; a note names a car that cannot brake without lifting an axle."""
    one_of(LOCKED, locked=parameters["locked"])
    result: dict[str, tuple[float, float, float]] = {}
    notes = []
    for locked in LOCKED:
        try:
            result[locked] = lecture.by_one_point(**{**parameters, "locked": locked})
        except ValueError as error:
            if locked == parameters["locked"]:
                raise
            notes.append(f"{locked} locked: {error}")
    slowest = min(d for d, _, _ in result.values())
    times = frame_times(min(1.2 * SPEED / slowest, 10.0) if slowest else 5.0)
    panels = [Panel(_car(times, motion, parameters, locked), f"locked: {locked}") for locked, motion in result.items()]
    speeds = {f"locked: {locked}": np.maximum(SPEED - d * times, 0.0) for locked, (d, _, _) in result.items()}
    return Scene(
        "Stopping car",
        "Cars brake side by side from one speed, with the front wheels, the rear wheels, or both locked. Arrows show "
        "the forces of the ground, load and friction, and the weight. Where the lines of the ground forces meet is the "
        "really nice point: about it only the weight and m a have moments.",
        times,
        panels,
        [value_plot("speed", times, speeds, "m/s")],
        notes=notes,
        still_time=0.2,
    )


def _car(times: Array, motion: tuple[float, float, float], parameters: Parameters, locked: str) -> list[Shape]:
    deceleration, front_load, rear_load = motion
    moves = np.minimum(times, SPEED / deceleration) if deceleration else times
    x = SPEED * moves - deceleration * moves**2 / 2
    at = np.column_stack([x, np.zeros_like(x)])  # below G
    front, rear, height = (parameters[name] for name in ("front", "rear", "height"))
    tips = {"front": np.array([front, 0.0]), "rear": np.array([-rear, 0.0])}
    top = np.array([0.0, 2 * height + WHEEL])
    body = [at + tips["rear"] + [-0.5, WHEEL], at + tips["front"] + [0.5, WHEEL]]
    outline = moving(*body, body[1] + top / 2, at + top, body[0] + top)
    color = LOCKED.index(locked)
    loads = {"front": front_load, "rear": rear_load}
    at_rest = {axle: parameters["gravity"] * arm / (front + rear) for axle, arm in (("front", rear), ("rear", front))}
    unit, G = 2.0 / parameters["gravity"], at + [0.0, height]  # s^2
    shapes = [
        Shape("lines", np.array([[-rear - 1.0, 0.0], [x[-1] + front + 1.0, 0.0]]), GREY, width=1),
        *solid(outline, color),
        arrow(G, [0.0, -2.0], 4, "weight"),
        Shape("dot", G[:, None], 4, "G", width=4),
    ]
    for axle, tip in tips.items():
        slides = locked in (axle, "both") and moves is not times
        shapes.append(Shape("dot", (at + tip + [0.0, WHEEL / 2])[:, None], color, width=9 if slides else 5))
        load = np.where(times < moves[-1], loads[axle], at_rest[axle])
        friction = -parameters["friction"] * load * (times < moves[-1]) if slides else 0.0 * x
        force = unit * np.column_stack([friction, load])
        shapes.append(arrow(at + tip, force, 3, "force of the ground"))
    if locked != "both" and parameters["friction"]:
        shapes += _nice_point(at, tips, locked, parameters["friction"])
    return shapes


def _nice_point(at: Array, tips: Mapping[str, Array], locked: str, friction: float) -> list[Shape]:
    """Return the point where the line of the locked axle's force meets the vertical one of the free axle's."""
    free = "rear" if locked == "front" else "front"
    height = (tips[locked][0] - tips[free][0]) / friction
    point = at + tips[free] + [0.0, height]
    lines = moving(at + tips[free], point, at + tips[locked], point)
    return [
        Shape("lines", lines, 3, "lines of the ground forces", width=1, faint=True),
        Shape("dot", point[:, None], 5, "really nice point", width=6),
    ]
