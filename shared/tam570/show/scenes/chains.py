"""The lecture `chains`: a folded one by both equations, one lifted from a heap, one poured on a scale."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import sqrt
from types import SimpleNamespace

import numpy as np

from tam570.arguments import positive
from tam570.integrate import solve
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, arrow, frame_times, moving

DISTANCE = 0.12  # of the length, between the two sides of a fold
LARGEST = 4.0  # in weights of the chain: the largest reading that is shown; without loss it has no limit
HEAP = 0.09  # of the length: half the width of a heap of the full chain
DOWN = 0.99  # of the length: where a fall ends; at 1 its speed may be infinite
LIMITS = {"textbook": 0, "nothing lost": 1}  # the limits that are drawn, and their colours


def film(lecture: SimpleNamespace, parameters: Mapping[str, float]) -> Scene:
    """Return the scene of all three, each by its two limits; lifted and poured also with the share `supplied`."""
    length, density, speed, gravity, supplied = (parameters[name] for name in lecture.EXAMPLE)
    positive(length=length, density=density, speed=speed, gravity=gravity)
    times = frame_times(1.1 * sqrt(2 * length / gravity))
    shares = {"textbook": 0.0, f"supplied {supplied:g}": supplied, "nothing lost": 0.5}
    folds = [_falls(times, partial(lecture.folded, length=length, gravity=gravity), i, length) for i in (0, 1)]
    pulls, readings, falls = {}, {}, {}
    for name, share in shares.items():
        arguments = {"density": density, "gravity": gravity, "supplied": share}
        pulls[name] = np.array([lecture.lifted(y, speed, **arguments) for y in np.minimum(speed * times, length)])
        falls[name] = _falls(times, partial(_pulled_down, share, length=length, gravity=gravity), 0, length)[:, 0]
        falling = [lecture.poured(x, **arguments, length=length) for x in falls[name][falls[name] < length]]
        readings[name] = np.concatenate([falling, np.full(len(times) - len(falling), density * gravity * length)])
    weight = density * gravity  # N/m
    most = LARGEST * weight * length  # N
    risen = np.minimum(speed * times, length)
    ground = Shape("lines", DISTANCE * length * np.array([[-2.0, 0.0], [6.0, 0.0]]), GREY, width=3)
    lifting, pouring = [ground], [ground]
    for name, color in LIMITS.items():
        shift = 4 * DISTANCE * length * color
        lifting += _upright(shift, risen, 1 - risen / length, length, color, name)
        lifting.append(_arrow(shift, risen, 0.3 * length / float(pulls["textbook"].max()) * pulls[name], "force"))
        pouring += _upright(shift, length - falls[name], falls[name] / length, length, color, "")
        pressed = 0.3 * length / most * np.minimum(readings[name], most)
        pouring.append(_arrow(shift, -pressed, pressed, ""))
    folded = [*_fold(folds[0][:, 0], 0, 0.0, length), *_fold(folds[1][:, 0], 1, 3 * DISTANCE * length, length)]
    on_scale = {**readings, "weight on it": weight * falls["textbook"]}
    return Scene(
        "Chains",
        "A folded chain falls faster than free fall if it keeps its energy, and freely if its links stop "
        "inelastically. A chain is lifted from a heap, another one falls on a scale: the force is that of the textbook "
        "or smaller, by what links that push or pull each other make of it.",
        times,
        [Panel(folded, "folded"), Panel(lifting, "lifted"), Panel(pouring, "poured")],
        [
            _energy(times, folds[0], folds[1], parameters),
            value_plot("force that lifts", times, pulls, "N"),
            replace(value_plot("the scale", times, on_scale, "N"), span=(-0.1 * most, most)),
        ],
        still_time=0.72,
    )


def _pulled_down(share: float, fallen: float, speed: float, *, length: float, gravity: float) -> tuple[float]:
    return (gravity + share * speed * speed / (length - fallen),)


def _falls(times: Array, accelerations: Callable[[float, float], Sequence[float]], which: int, length: float) -> Array:
    """Return (n, 2) m and m/s, a fall from rest by one of these accelerations; at its end the length and 0."""

    def rates(t: float, state: Sequence[float]) -> tuple[float, float]:
        return state[1], accelerations(state[0], state[1])[which]

    def down(t: float, state: Sequence[float]) -> float:
        return state[0] - DOWN * length

    down.terminal = True  # type: ignore[attr-defined]
    motion = solve(rates, times, (0.0, 0.0), events=down)
    falling = motion.states[times[: len(motion.states)] < motion.t[-1]]
    return np.concatenate([falling, np.tile([length, 0.0], (len(times) - len(falling), 1))])


def _arrow(x: float, foot: Array, size: Array, name: str) -> Shape:
    """Return an arrow upwards at x, from heights (n,) m, of lengths (n,) m."""
    return arrow(np.column_stack([np.full_like(foot, x), foot]), np.outer(size, [0.0, 1.0]), 3, name, 3)


def _upright(x: float, height: Array, share: Array, length: float, color: int, name: str) -> list[Shape]:
    """Return a chain from the ground up to its end at (n,) m, and a heap with a share (n,) of it."""
    foot = np.array([x, 0.0])
    size = HEAP * length * np.sqrt(np.maximum(share, 0.0))[:, None, None]
    heap = foot + size * np.array([[-1.0, 0.0], [-0.5, 0.8], [0.0, 1.0], [0.5, 0.8], [1.0, 0.0]])
    end = foot + np.outer(height, [0.0, 1.0])
    return [Shape("fill", heap, color, faint=True), Shape("lines", moving(foot, end), color, name, width=4)]


def _fold(fallen: Array, color: int, shift: float, length: float) -> list[Shape]:
    """Return a chain that hangs at one end, with its other end fallen by (n,) m."""
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
    """Plot the energy of the folded chain by both equations, until the first fall ends."""
    length, density, gravity = (parameters[name] for name in ("length", "density", "gravity"))
    falling = np.flatnonzero((remaining[:, 0] < length) & (lost[:, 0] < length))

    def energy(x: Array, v: Array) -> Array:
        return density * ((length - x) * v**2 - gravity * (2 * length * x - x**2)) / 4

    energies = {"by energy": energy(*remaining[falling].T), "inelastic": energy(*lost[falling].T)}
    scale = density * gravity * length**2 / 4
    caption = drift_caption(energies["by energy"], scale, "the potential energy", "by energy: ")
    return value_plot("folded: energy", times[falling], energies, "J", *caption)
