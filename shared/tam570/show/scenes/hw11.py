"""hw11: coins in steady circles: two that roll, and one that shudders, rolling and sliding at once."""

from dataclasses import dataclass

import numpy as np

from tam570.show.drawing import circle, floor, solid
from tam570.show.plots import gap_caption, value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, TimePlot, frame_times, moving
from tam570.show.student import StudentModule
from tam570.values import Parameters

EXAMPLE = {
    "mass": 0.02,  # kg
    "radius": 0.1,  # m
    "inertia": (0.02 * 0.1**2 / 4, 0.02 * 0.1**2 / 2),  # kg m^2, a thin uniform disk
    "gravity": 9.81,  # m/s^2
    "leans": (0.35, 0.8),  # rad, of the coins that roll
    "track_radii": (0.42, 0.24),  # m
    "settling_lean": 1.15,  # rad, of the coin whose centre is at rest
}
COIN, ALL = ("mass", "radius"), ("mass", "radius", "inertia", "gravity")
SECONDS = 6.0
LARGE = 1e-6  # of m g a; rounding is about 1e-15
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Circling:
    """A coin in steady motion: rad, m, rad/s, rad/s."""

    lean: float
    track_radius: float
    precession: float
    spin: float
    name: str


def film(student: StudentModule, parameters: Parameters) -> Scene:
    """Return the scene of three coins on one floor about one centre."""
    times = frame_times(SECONDS)
    arguments, radius = {name: parameters[name] for name in ALL}, parameters["radius"]
    tracks = zip(parameters["leans"], parameters["track_radii"], strict=True)
    coins = [_rolling(student, lean, track_radius, arguments) for lean, track_radius in tracks]
    coins += student.make_each(lambda: _settling(student, parameters["settling_lean"], arguments))
    reach = max(abs(coin.track_radius) for coin in coins) + radius
    shapes = [floor((-reach, -reach), (reach, reach), 0.1)]
    for color, coin in enumerate(coins):
        shapes += _coin(times, coin, radius, color)
    return Scene(
        "Coins in steady circles",
        "Coins roll in circles on a floor, leaning inwards. The more one leans, the faster it goes round; the one in "
        "the middle turns about a diameter, its centre at rest, like a coin that settles.",
        times,
        [Panel(shapes)],
        student.make_each(lambda: _residuals(student, times, coins, arguments)),
        view=(0.5, 0.6),
        still_time=0.1,
    )


def _rolling(student: StudentModule, lean: float, track_radius: float, parameters: Parameters) -> Circling:
    precession = student("rolling_precession", lean, track_radius, **parameters)
    spin = student("rolling_spin", lean, precession, **parameters)
    return Circling(lean, track_radius, precession, spin, f"rolling, lean {lean:g}")


def _settling(student: StudentModule, lean: float, parameters: Parameters) -> Circling:
    precession = student("common_precession", lean, **parameters)
    spin = student("sliding_spin", lean, precession, **parameters)
    track_radius = student("sliding_track_radius", lean, radius=parameters["radius"])
    return Circling(lean, track_radius, precession, spin, f"rolling and sliding, lean {lean:g}")


def _coin(times: Array, coin: Circling, radius: float, color: int) -> list[Shape]:
    """Return a disk with a mark, and its track. The coin's spin includes -sin(lean) times the precession."""
    lean = coin.lean
    turned = coin.precession * times
    outward = np.column_stack([np.cos(turned), np.sin(turned), 0.0 * turned])
    ahead = np.column_stack([-np.sin(turned), np.cos(turned), 0.0 * turned])
    up_the_disk = np.cos(lean) * UP - np.sin(lean) * outward
    contact = coin.track_radius * outward
    centre = contact + radius * up_the_disk
    rolled = (coin.spin + coin.precession * np.sin(lean)) * times
    spoke = np.cos(rolled)[:, None] * up_the_disk + np.sin(rolled)[:, None] * ahead
    rim = circle(centre, radius * up_the_disk, radius * ahead, 37)
    track = circle(np.zeros(3), abs(coin.track_radius) * np.eye(3)[0], abs(coin.track_radius) * np.eye(3)[1])
    return [
        Shape("path", track, GREY, width=1.5),
        *solid(rim, color, coin.name, 2.5),
        Shape("lines", moving(centre, centre + radius * spoke), color, width=2.5),
        Shape("dot", contact[:, None], color, width=4),
    ]


def _residuals(student: StudentModule, times: Array, coins: list[Circling], parameters: Parameters) -> TimePlot:
    disk, inertia, gravity = {name: parameters[name] for name in COIN}, parameters["inertia"], parameters["gravity"]
    off = {}
    for coin in coins:
        motion = coin.lean, coin.precession, coin.spin
        inward, normal = student("contact_force", *motion, **disk, gravity=gravity)
        residual = student("moment_residual", *motion, inward, normal, **disk, inertia=inertia)
        off[f"lean {coin.lean:g}"] = np.full(2, 100.0 * residual / (disk["mass"] * gravity * disk["radius"]))
    largest = max(float(np.abs(residual).max()) for residual in off.values()) / 100.0
    caption = gap_caption(largest, LARGE, " of m g a", warning="not steady: ")
    return value_plot("moment_residual()", times[[0, -1]], off, "%", *caption, least=1.0)
