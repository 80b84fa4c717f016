"""The lecture on chains: a folded one by both of its equations, one lifted from a heap, one poured on a scale."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from tam570.show.plots import drift_plot, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, moving

__all__ = ["chains"]

DISTANCE = 0.12  # of the length, between the two sides of a fold
LARGEST = 4.0  # times the chain's weight, of the scale's reading that is shown: without loss it grows without limit
HEAP = 0.09  # of the length: half the width of the whole chain in a heap
LIMITS = {"textbook": 0, "nothing lost": 1}  # those that are drawn, and their colours


def chains(
    times: Array,
    folds: Sequence[Array],
    falls: Mapping[str, Array],
    pulls: Mapping[str, Array],
    readings: Mapping[str, Array],
    parameters: Mapping[str, float],
) -> Scene:
    """Draw three panels.

    folds    : (n, 2) m and m/s, fallen by the end of a folded chain, by energy and inelastic
    falls    : (n,) m, that a poured chain has fallen, for each share that is supplied
    pulls    : (n,) N, that lift a chain from a heap
    readings : (n,) N, of the scale
    """
    length, weight = parameters["length"], parameters["density"] * parameters["gravity"]
    most = LARGEST * weight * length  # N
    risen = np.minimum(parameters["speed"] * times, length)
    ground = Shape("lines", DISTANCE * length * np.array([[-2.0, 0.0], [6.0, 0.0]]), GREY, width=3)
    lifting, pouring = [ground], [ground]
    for name, color in LIMITS.items():
        shift = 4 * DISTANCE * length * color
        lifting += _upright(shift, risen, 1 - risen / length, length, color, name)
        lifting.append(_arrow(shift, risen, 0.3 * length / float(pulls["textbook"].max()) * pulls[name], "force"))
        pouring += _upright(shift, length - falls[name], falls[name] / length, length, color, "")
        pressed = 0.3 * length / most * np.minimum(readings[name], most)
        pouring.append(_arrow(shift, -pressed, pressed, ""))
    on_scale = {**readings, "weight on it": weight * falls["textbook"]}
    return Scene(
        "Chains",
        "A folded chain falls faster than free fall if it keeps its energy, and freely if its links stop "
        "inelastically. A chain is lifted from a heap, another one falls on a scale: the force is that of the textbook "
        "or smaller, by what links that push or pull each other make of it.",
        times,
        [
            Panel(
                [*_fold(folds[0][:, 0], 0, 0.0, length), *_fold(folds[1][:, 0], 1, 3 * DISTANCE * length, length)],
                "folded",
            ),
            Panel(lifting, "lifted"),
            Panel(pouring, "poured"),
        ],
        [
            _energy(times, folds[0], folds[1], parameters),
            value_plot("force that lifts", times, pulls, "N"),
            replace(value_plot("the scale", times, on_scale, "N"), span=(-0.1 * most, most)),
        ],
        still_time=0.72,
    )


def _arrow(x: float, foot: Array, size: Array, name: str) -> Shape:
    """Return an arrow upwards at x, from (n,) m, of the length (n,) m."""
    across = np.full_like(foot, x)
    tail, tip = np.column_stack([across, foot]), np.column_stack([across, foot + size])
    return Shape("arrow", moving(tail, tip), 3, name, width=3)


def _upright(x: float, height: Array, share: Array, length: float, color: int, name: str) -> list[Shape]:
    """Return a chain from the ground up to its end at (n,) m, and the (n,) share of it that lies in a heap."""
    foot = np.array([x, 0.0])
    size = HEAP * length * np.sqrt(np.maximum(share, 0.0))[:, None, None]
    heap = foot + size * np.array([[-1.0, 0.0], [-0.5, 0.8], [0.0, 1.0], [0.5, 0.8], [1.0, 0.0]])
    end = foot + np.outer(height, [0.0, 1.0])
    return [Shape("fill", heap, color, faint=True), Shape("lines", moving(foot, end), color, name, width=4)]


def _fold(fallen: Array, color: int, shift: float, length: float) -> list[Shape]:
    """Return a chain hung at one end, its other end fallen by (n,) m."""
    still, side = np.zeros(len(fallen)), DISTANCE * length
    bottom = -(length + fallen) / 2
    corners = [(still, still), (still, bottom), (still + side, bottom), (still + side, -fallen)]
    path = np.stack([np.column_stack([x + shift, y]) for x, y in corners], axis=1)
    return [
        Shape("path", path, color, ("by energy", "inelastic")[color], width=3.5),
        Shape("dot", path[:, 3:], color, width=8),
        Shape("dot", path[0, :1], INK, width=6),
    ]


def _energy(times: Array, remaining: Array, lost: Array, parameters: Mapping[str, float]) -> TimePlot:
    """Of the folded chain, as long as both fall."""
    length, density, gravity = (parameters[name] for name in ("length", "density", "gravity"))
    falling = np.flatnonzero((remaining[:, 0] < length) & (lost[:, 0] < length))

    def energy(x: Array, v: Array) -> Array:
        return density * ((length - x) * v**2 - gravity * (2 * length * x - x**2)) / 4

    scale = density * gravity * length**2 / 4
    return drift_plot(
        "folded: energy, change",
        times[falling],
        {"by energy": energy(*remaining[falling].T)},
        scale,
        "the potential energy",
        beside={"inelastic": energy(*lost[falling].T)},
    )
