"""hw14: the rolling disk on its plane, with the path of the contact point."""

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from tam570.loading import Trouble
from tam570.show.diagrams import force_shapes
from tam570.show.drawing import circle, floor, solid
from tam570.show.live import Handle, Live, energies, live_if_written
from tam570.show.plots import gap_caption, state_energy_plot, value_plot
from tam570.show.scene import Array, Panel, Scene, Shape, TimePlot, frame_times, moving
from tam570.show.student import StudentModule
from tam570.values import Numbers, Parameters

EXAMPLE = {"mass": 1.0, "radius": 0.5, "inertia": (0.0625, 0.125), "gravity": 9.81}  # kg, m, kg m^2, m/s^2
START = (0.0, 0.0, 0.0, math.pi / 2 + 0.3, 0.0, 0.5, 0.0, -5.0)  # m, rad, rad/s: leaning and rolling
STATE = {
    "x": "m",
    "y": "m",
    "yaw": "rad",
    "tilt": "rad",
    "roll": "rad",
    "yaw_rate": "rad/s",
    "tilt_rate": "rad/s",
    "roll_rate": "rad/s",
}
SIDES = 36
SECONDS = 12.0
LARGE = 1e-3  # of the radius, between the two simulations


def film(student: StudentModule, disk: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of a disk that starts to roll with a lean."""
    times = frame_times(seconds)
    states = student("simulate_euler", times, np.array(start), **disk)
    frame = student.each("wireframe", states, radius=disk["radius"], sides=SIDES)
    if frame.shape[1] != SIDES + 2:
        raise Trouble(f"wireframe gives {frame.shape[1]} lines for {SIDES} sides; {SIDES + 2} are asked for")
    rim, diameters = frame[:, :SIDES, 0], frame[:, SIDES:].reshape(-1, 4, 3)
    contact = np.column_stack([states[:, :2], 0.0 * times])
    parameters = {name: disk[name] for name in ("mass", "radius", "gravity")}
    shapes = [
        floor(contact.min(axis=0)[:2] - 0.5, contact.max(axis=0)[:2] + 0.5, 0.5),
        *_disk(contact, rim, diameters),
        *force_shapes(student, states, size=disk["radius"], origin=(0.0, 0.0, 0.0), **parameters),
    ]
    return Scene(
        "Rolling disk",
        "A disk rolls on a plane, leaning, nods as it goes round, and its point of contact draws a path of "
        "loops or waves.",
        times,
        [Panel(shapes)],
        student.make_each(
            lambda: state_energy_plot(times, states, 5, partial(student.each, "energy", **disk)),
            lambda: _tilt(student, times, states, frame, disk),
        ),
        view=(0.4, 0.5),
        live=live_if_written(lambda: _live(student, disk, start, [shapes[0]])),
    )


def _live(student: StudentModule, disk: Parameters, start: Sequence[float], still: list[Shape]) -> Live:
    def drawing(states: Numbers, parameters: Parameters) -> list[Shape]:
        x, y, yaw, tilt, roll = states[:, :5].T
        contact = np.column_stack([x, y, 0 * x])
        ahead = np.column_stack([np.cos(yaw), np.sin(yaw), 0 * yaw])
        up = np.column_stack([-np.sin(yaw) * np.cos(tilt), np.cos(yaw) * np.cos(tilt), np.sin(tilt)])
        centre = contact + parameters["radius"] * up
        first, other = parameters["radius"] * ahead, parameters["radius"] * up
        c, s = np.cos(roll)[:, None], np.sin(roll)[:, None]
        spokes = [c * first + s * other, c * other - s * first]
        ends = [centre + sign * spoke for spoke in spokes for sign in (1.0, -1.0)]
        return _disk(contact, circle(centre, first, other, SIDES + 1), moving(*ends))

    def top(state: Numbers, *, radius: Numbers, **parameters: Numbers) -> list[Numbers]:
        x, y, yaw, tilt = state[:4]
        across = 2 * radius * np.cos(tilt)
        return [x - across * np.sin(yaw), y + across * np.cos(yaw), 2 * radius * np.sin(tilt)]

    def grab(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        x, y, yaw = state[:3]
        aside = (y - point[1]) * -np.cos(yaw) + (x - point[0]) * np.sin(yaw)
        return [x, y, yaw, np.arctan2(point[2], aside), *state[4:]]

    rates, measures = student.function("euler_state_derivative"), energies(student.function("energy"), 5)
    return Live(rates, disk, start, drawing, [Handle(top, grab)], measures, backdrop=still)


def _disk(contact: Array, rim: Array, diameters: Array) -> list[Shape]:
    return [
        Shape("trail", contact[:, None], 1, "path of the contact", width=2),
        *solid(rim, 0, "disk", 3),
        Shape("lines", diameters, 0, width=1.5),
        Shape("dot", contact[:, None], 1, width=4),
    ]


def _tilt(student: StudentModule, times: Array, states_by_angles: Array, frame: Array, disk: Parameters) -> TimePlot:
    """Plot the tilt; the caption compares the centre by matrices with that by Euler angles, middle of a diameter."""
    first = student("matrix_state", states_by_angles[0], radius=disk["radius"])
    states = student("simulate_matrix", times, first, **disk)
    off = np.linalg.norm(states[:, :3] - frame[:, -1].mean(axis=1), axis=1) / disk["radius"]
    caption = gap_caption(float(off.max()), LARGE, " of the radius", "by matrices and by Euler angles: ")
    return value_plot("tilt", times, {"": np.degrees(states_by_angles[:, 3])}, "°", *caption)
