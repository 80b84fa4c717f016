"""The lecture on chains: a folded one by both of its equations, one lifted from a heap, one poured on a scale."""

from collections.abc import Mapping

import numpy as np

from tam570.show.scene import (
    GREY,
    INK,
    Array,
    Panel,
    Scene,
    Shape,
    TimePlot,
    drift_plot,
    moving,
    plot_samples,
    value_plot,
)

__all__ = ["chains"]

DISTANCE = 0.12  # of the length, between the two sides of a fold


def chains(
    times: Array, fallen: Array, free: Array, risen: Array, pull: Array, scale: Array, parameters: Mapping[str, float]
) -> Scene:
    """Three panels.

    fallen : (n, 2) m and m/s, the end of the folded chain, by energy
    free   : (n,) m, that it, and the poured chain, have fallen freely
    risen  : (n,) m, the end of the lifted chain
    pull, scale : (n,) N, what lifts that end, and the reading of the scale
    """
    length, weight = parameters["length"], parameters["density"] * parameters["gravity"]
    side = DISTANCE * length
    unit = 0.25 * length / max(float(pull.max()), float(scale.max()))  # m/N
    still, up = np.zeros(len(times)), np.array([0.0, 1.0])
    lifted, pulled = np.outer(risen, up), np.outer(risen + unit * pull, up)
    lifting = _upright(lifted, "chain", moving(lifted, pulled), "force that lifts")
    pressed = moving(np.column_stack([still, -unit * scale]), np.zeros(2))
    pouring = _upright(np.outer(length - free, up), "", pressed, "force of the scale")
    heap = Shape("dot", np.zeros((1, 2)), 0, width=14)
    ground = Shape("lines", np.array([[-2 * side, 0.0], [2 * side, 0.0]]), GREY, width=3)
    shown = plot_samples(times)
    forces = {"lifted": pull, "on the scale": scale, "weight on the scale": weight * free}
    return Scene(
        "Chains",
        "A folded chain falls faster than free fall if it keeps its energy, and freely if its links stop "
        "inelastically. A chain is lifted from a heap. A third one falls on a scale, which shows three times what lies"
        " there.",
        times,
        [
            Panel([*_fold(fallen[:, 0], 0, 0.0, length), *_fold(free, 1, 3 * side, length)], "folded"),
            Panel([ground, *lifting, heap], "lifted"),
            Panel([ground, *pouring, heap], "poured"),
        ],
        [
            _energy(times, fallen, free, parameters),
            value_plot("forces", times[shown], {name: force[shown] for name, force in forces.items()}, "N"),
        ],
        still_time=0.72,
    )


def _upright(end: Array, chain: str, force: Array, label: str) -> list[Shape]:
    """A chain from the ground to its end (n, 2), and a force as an arrow."""
    return [Shape("lines", moving(np.zeros(2), end), 0, chain, width=4), Shape("arrow", force, 3, label, width=3)]


def _fold(fallen: Array, color: int, left: float, length: float) -> list[Shape]:
    """A chain hung at one end, its other end fallen by (n,) m."""
    still, side = np.zeros(len(fallen)), DISTANCE * length
    bottom = -(length + fallen) / 2
    corners = [(still, still), (still, bottom), (still + side, bottom), (still + side, -fallen)]
    path = np.stack([np.column_stack([x + left, y]) for x, y in corners], axis=1)
    return [
        Shape("path", path, color, ("by energy", "inelastic")[color], width=3.5),
        Shape("dot", path[:, 3:], color, width=8),
        Shape("dot", path[0, :1], INK, width=6),
    ]


def _energy(times: Array, fallen: Array, free: Array, parameters: Mapping[str, float]) -> TimePlot:
    """Of the folded chain, as long as both fall."""
    length, density, gravity = (parameters[name] for name in ("length", "density", "gravity"))
    speeds = np.append(np.diff(fallen[:, 0]), 0.0)
    falling = np.flatnonzero((speeds > 0) & (free < length))
    shown = falling[plot_samples(times[falling])]

    def energy(x: Array, v: Array) -> Array:
        return density * ((length - x) * v**2 - gravity * (2 * length * x - x**2)) / 4

    right, lost = energy(*fallen[shown].T), energy(free[shown], gravity * times[shown])
    scale = density * gravity * length**2 / 4
    title = "folded: energy, change"
    return drift_plot(
        title, times[shown], {"by energy": right}, scale, "the potential energy", beside={"inelastic": lost}
    )
