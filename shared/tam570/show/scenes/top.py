"""The lecture `top`: a top let go, in both steady precessions, and asleep."""

from collections.abc import Mapping, Sequence
from functools import partial
from types import SimpleNamespace

import numpy as np

from tam570.integrate import solve
from tam570.show.drawing import circle, solid
from tam570.show.live import Handle, Live, energies
from tam570.show.plots import drift_caption, value_plot, values
from tam570.show.scene import FASTEST, GREY, INK, Array, Panel, Scene, Shape, frame_times, moving, with_slider
from tam570.values import Numbers, Parameters

LENGTH, HEIGHT, RADIUS = 1.0, 0.6, 0.45  # m, in the picture: of the axis, of its disk
SPINS = (3.5, 8.0)  # rad/s, of the slider
NUDGED = 0.02  # rad, the tilt of a top that may sleep


def film(lecture: SimpleNamespace, parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of a top let go, in steady precession and asleep, with a slider for the rate of its spin."""
    return with_slider(
        lambda spin: _tops(lecture, parameters, (*start[:5], spin), seconds), "rate of phi", "rad/s", SPINS, start[5]
    )


def _tops(lecture: SimpleNamespace, parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    times, (_, tilt, _, _, _, rate) = frame_times(seconds), start
    motion = partial(solve, lecture.rates, times, parameters=parameters)
    spin = rate + start[3] * np.cos(tilt)  # along the axis
    free = motion(start)
    asleep = motion((0.0, NUDGED, 0.0, 0.0, 0.0, spin))
    try:
        both = lecture.steady_precession(tilt, spin, **parameters)
        rates = [W for W in both if abs(W) < FASTEST]  # near a level axis the fast rate has no limit
        title = ("too fast to draw", "slow steady precession", "steady precession, slow and fast")[len(rates)]
    except ValueError:  # too slow a spin
        rates, title = [], "too slow for steady precession"
    steadily = [motion((0.0, tilt, 0.0, W, 0.0, spin - W * np.cos(tilt))) for W in rates]
    precessing = [part for i, states in enumerate(steadily) for part in _top(states, i, ("slow", "fast")[i])]
    constants = {name: values(constant, free, **parameters) for name, constant in lecture.INVARIANTS.items()}
    changes = {name: sizes / (abs(sizes[0]) or 1.0) for name, sizes in constants.items()}
    drift = drift_caption(changes, 1.0, "energy and both momenta")
    return Scene(
        "Heavy top",
        "One top three times. Let go at rest it nods, and the end of its axis draws cusps. Started as it should be it "
        "goes round steadily, slowly or fast. Upright it sleeps, if it spins fast enough, else it falls over.",
        times,
        [
            Panel(_draw(free, parameters), "let go", ruler=False),
            Panel([*_ground(), *precessing], title, ruler=False),
            Panel(_top(asleep, 2, "almost upright"), "almost upright", ruler=False),
        ],
        [
            value_plot("let go: tilt", times, {"": np.degrees(free[:, 1])}, "°", least=90.0),
            value_plot("let go: precession", times, {"": free[:, 3]}, "rad/s", *drift),
        ],
        view=(0.5, 0.3),
        still_time=0.5,
        live=Live(lecture.rates, parameters, start, _draw, [HANDLE], energies(lecture.energy, 3)),
    )


def _ground() -> list[Shape]:
    level = circle(np.zeros(3), [LENGTH, 0.0, 0.0], [0.0, LENGTH, 0.0])
    return [Shape("path", level, GREY, width=1), Shape("dot", np.zeros((1, 3)), INK, width=4)]


def _draw(states: Array, parameters: Parameters) -> list[Shape]:
    return _top(states, 0, "let go")


def _end(state: Numbers, **parameters: Numbers) -> list[Numbers]:
    psi, theta = state[:2]
    return [np.sin(theta) * np.sin(psi), -np.sin(theta) * np.cos(psi), np.cos(theta)]


def _grab(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
    theta = np.arctan2(np.hypot(point[0], point[1]), point[2])
    return [np.arctan2(point[0], -point[1]), theta, state[2], 0.0, 0.0, state[5]]


HANDLE = Handle(_end, _grab)  # the end of the axis


def _top(states: Array, color: int, name: str) -> list[Shape]:
    """Return the axis, its disk and the path of its end; states (n, 6)."""
    psi, theta, phi = states[:, :3].T
    node = np.column_stack([np.cos(psi), np.sin(psi), 0 * psi])
    axis = np.column_stack(_end(states.T))
    other = np.cross(axis, node)
    rim = circle(HEIGHT * axis, RADIUS * node, RADIUS * other, 37)
    spoke = HEIGHT * axis + RADIUS * (np.cos(phi)[:, None] * node + np.sin(phi)[:, None] * other)
    return [
        *_ground(),
        *solid(rim, color),
        Shape("lines", moving(np.zeros(3), LENGTH * axis, HEIGHT * axis, spoke), color, name, width=3),
        Shape("trail", LENGTH * axis[:, None], 1, "end of the axis", width=1.8),
    ]
