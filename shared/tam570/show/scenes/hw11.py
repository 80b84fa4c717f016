"""hw11: coins in steady circles: two that roll, and one that shudders, rolling and sliding at once."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from tam570.show.drawing import circle, floor
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, TimePlot, frame_times, moving, plot_samples, value_plot
from tam570.show.student import Student, make_each

__all__ = ["film"]

COIN: dict[str, Any] = {"mass": 0.02, "radius": 0.1}  # kg, m
INERTIA = (0.02 * 0.1**2 / 4, 0.02 * 0.1**2 / 2)  # kg m^2, a thin uniform disk
GRAVITY = 9.81  # m/s^2
ROLLING = {0.35: 0.42, 0.8: 0.24}  # lean, rad: track radius, m
SHUDDERING = 1.15  # rad, lean of the coin whose centre stays
SECONDS = 6.0
LARGE = 1e-6  # of m g a; a few roundings make 1e-15
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Circling:
    """A coin in steady motion: rad, m, rad/s, rad/s."""

    lean: float
    track_radius: float
    precession: float
    spin: float
    name: str


def film(student: Student) -> Scene:
    """Three coins on one floor about one centre."""
    times, notes = frame_times(SECONDS), list[str]()
    coins = [_rolling(student, lean, radius) for lean, radius in ROLLING.items()]
    coins += make_each(notes, lambda: _shuddering(student))
    reach = max(abs(coin.track_radius) for coin in coins) + COIN["radius"]
    shapes = [floor((-reach, -reach), (reach, reach), 0.1)]
    for color, coin in enumerate(coins):
        shapes += _coin(times, coin, color)
    return Scene(
        "Coins in steady circles",
        "Coins roll in circles on a floor, leaning inwards. The more one leans, the faster it goes round; the one in "
        "the middle turns about a diameter, its centre at rest, like a coin that settles.",
        times,
        [Panel(shapes)],
        make_each(notes, lambda: _residuals(student, times, coins)),
        view=(0.5, 0.6),
        notes=notes,
        still_time=0.1,
    )


def _rolling(student: Student, lean: float, track_radius: float) -> Circling:
    known: dict[str, Any] = {**COIN, "inertia": INERTIA, "gravity": GRAVITY, "shape": ()}
    precession = float(student("rolling_precession", lean, track_radius, **known))
    spin = float(student("rolling_spin", lean, precession, **known))
    return Circling(lean, track_radius, precession, spin, f"rolling, lean {lean:g}")


def _shuddering(student: Student) -> Circling:
    known: dict[str, Any] = {**COIN, "inertia": INERTIA, "gravity": GRAVITY, "shape": ()}
    precession = float(student("common_precession", SHUDDERING, **known))
    spin = float(student("sliding_spin", SHUDDERING, precession, **known))
    track_radius = float(student("sliding_track_radius", SHUDDERING, radius=COIN["radius"], shape=()))
    return Circling(SHUDDERING, track_radius, precession, spin, f"rolling and sliding, lean {SHUDDERING:g}")


def _coin(times: Array, coin: Circling, color: int) -> list[Shape]:
    """Disk, a mark on it, its track. The spin is the total one: the precession has its share, -sin(lean), in it."""
    radius, lean = COIN["radius"], coin.lean
    turned = coin.precession * times
    outward = np.column_stack([np.cos(turned), np.sin(turned), 0.0 * turned])
    ahead = np.column_stack([-np.sin(turned), np.cos(turned), 0.0 * turned])
    up_the_disk = np.cos(lean) * UP - np.sin(lean) * outward
    contact = coin.track_radius * outward
    centre = contact + radius * up_the_disk
    rolled = (coin.spin + coin.precession * np.sin(lean)) * times
    mark = np.cos(rolled)[:, None] * up_the_disk + np.sin(rolled)[:, None] * ahead
    rim = circle(centre, radius * up_the_disk, radius * ahead, 37)
    track = circle(np.zeros(3), abs(coin.track_radius) * np.eye(3)[0], abs(coin.track_radius) * np.eye(3)[1])
    return [
        Shape("path", track, GREY, width=1.5),
        Shape("fill", rim, color, faint=True),
        Shape("path", rim, color, coin.name, width=2.5),
        Shape("lines", moving(centre, centre + radius * mark), color, width=2.5),
        Shape("dot", contact[:, None], color, width=4),
    ]


def _residuals(student: Student, times: Array, coins: list[Circling]) -> TimePlot:
    shown = plot_samples(times)[[0, -1]]  # steady: the same at any time
    weight = COIN["mass"] * GRAVITY * COIN["radius"]
    off = {f"lean {c.lean:g}": np.full(2, 100.0 * _residual(student, c) / weight) for c in coins}
    largest = max(float(np.abs(one).max()) for one in off.values()) / 100.0
    note = f"{'not steady: ' if largest > LARGE else ''}at most {largest:.2g} of m g a"
    return value_plot("moment_residual()", times[shown], off, "%", note, alarm=largest > LARGE, least=1.0)


def _residual(student: Student, coin: Circling) -> float:
    motion = coin.lean, coin.precession, coin.spin
    inward, normal = student("contact_force", *motion, **COIN, gravity=GRAVITY, shape=(2,))
    return float(student("moment_residual", *motion, inward, normal, **COIN, inertia=INERTIA, shape=()))
