"""The lecture `collisions`: a cradle whose balls hit when they hang straight down, and a rod that hits a peg."""

from collections.abc import Callable, Mapping
from functools import partial
from math import inf, pi, sqrt
from types import SimpleNamespace

import numpy as np

from tam570.show.drawing import solid, unit_circle
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times, moving
from tam570.values import Function

SECONDS = 8.0
BALLS, RADIUS, LENGTH, GRAVITY = 5, 0.12, 1.0, 9.81  # 1, m, m, m/s^2
FIRST = np.array([1.6, 1.6, 0.0, 0.0, 0.0])  # m/s, of two balls that arrive straight below their hooks
ROD = {"length": 1.0, "mass": 1.0}  # m, kg
PEG = 0.04  # m, radius
ARM, FALL, TURN, HIT = 0.3, 0.5, 0.4, 2.0  # m from G to the peg, m/s, rad/s, s


def film(lecture: SimpleNamespace, parameters: Mapping[str, float]) -> Scene:
    """Return the scene of Newton's cradle, and of a rod that hits a peg."""
    times, restitution = frame_times(SECONDS), parameters["restitution"]
    angles, speeds = _swings(times, partial(lecture.cradle, restitution=restitution))
    places, about_peg, energies = _rod(times, partial(lecture.collide, restitution=restitution))
    total = about_peg.sum(axis=1)
    momenta = {"of G": about_peg[:, 0], "about G": about_peg[:, 1], "sum": total}
    caption = drift_caption(total, float(np.abs(about_peg).max()), "its largest part")
    of_cradle = (speeds**2 + GRAVITY * LENGTH * angles**2).sum(axis=1) / 2
    loss = {"cradle": 100 * of_cradle / of_cradle[0], "rod": 100 * energies / energies[0]}
    return Scene(
        f"Collisions, restitution {restitution:g}",
        "Two balls of a cradle swing down, and two fly off at the other end, again and again. Beside it a rod without "
        "weight comes down on a peg, which pushes it across its length: it flies off turning.",
        times,
        [Panel(_balls(angles), "cradle"), Panel(places, "rod on a peg")],
        [
            value_plot("rod: angular momentum about the peg", times, momenta, "kg m²/s", *caption),
            value_plot("energy, of that at the start", times, loss, "%"),
        ],
        still_time=0.13,
    )


def _swings(times: Array, cradle: Callable[[Array], Array]) -> tuple[Array, Array]:
    """Return (n, 5) angles, rad, and speeds, m/s: all balls are down together, every half period of a small swing."""
    w = sqrt(GRAVITY / LENGTH)
    rounds = np.floor(w * times / pi + 0.5).astype(int)  # the first quarter is their way down
    starts, now = [FIRST], cradle(FIRST)
    for _ in range(rounds.max()):
        starts.append(now)
        now = cradle(-now)
    phase = (w * times - pi / 2 - pi * np.maximum(rounds - 1, 0))[:, None]  # 0 when they hang straight down
    amplitude = np.array(starts)[rounds]
    return amplitude * np.sin(phase) / (w * LENGTH), amplitude * np.cos(phase)


def _balls(angles: Array) -> list[Shape]:
    hooks = np.column_stack([2 * RADIUS * np.arange(BALLS), np.zeros(BALLS)])
    balls = hooks + LENGTH * np.stack([np.sin(angles), -np.cos(angles)], axis=-1)
    shapes = [Shape("lines", np.array([[-RADIUS, 0.0], [2 * RADIUS * BALLS - RADIUS, 0.0]]), INK, width=3)]
    rim = RADIUS * unit_circle(33)
    for i in range(BALLS):
        shapes += [
            Shape("lines", moving(hooks[i], balls[:, i]), GREY, width=1.5),
            *solid(balls[:, i, None] + rim, 0, "balls"),
        ]
    return shapes


def _rod(times: Array, collide: Function) -> tuple[list[Shape], Array, Array]:
    """Return the picture, the angular momentum about the peg, of G and about G (n, 2), kg m^2/s, and the energy, J."""
    mass, inertia = ROD["mass"], ROD["mass"] * ROD["length"] ** 2 / 12
    before = np.array([[-0.15, -FALL, TURN], [0.0, 0.0, 0.0]])
    arms = np.array([[ARM, 0.0], [0.0, 0.0]])  # the peg is at the second body's centre
    both, _ = collide(before, [0.0, -1.0], arms, masses=(mass, inf), inertias=(inertia, inf))
    late = times >= HIT
    velocities = np.where(late[:, None], both[0], before[0])
    moved = velocities * (times - HIT)[:, None]
    G = moved[:, :2] - arms[0]  # the peg is the origin
    half = 0.5 * ROD["length"] * np.column_stack([np.cos(moved[:, 2]), np.sin(moved[:, 2])])
    across = G[:, 0] * velocities[:, 1] - G[:, 1] * velocities[:, 0]
    shapes = [
        Shape("fill", PEG * (unit_circle(33) - [0.0, 1.0]), GREY, "peg"),
        Shape("trail", G[:, None], 2, "centre of mass", width=1.5),
        Shape("lines", moving(G - half, G + half), 1, "rod", width=5),
        Shape("dot", G[:, None], 2, width=6),
    ]
    energies = mass * (velocities[:, :2] ** 2).sum(axis=1) / 2 + inertia * velocities[:, 2] ** 2 / 2
    return shapes, np.column_stack([mass * across, inertia * velocities[:, 2]]), energies
