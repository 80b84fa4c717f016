"""The lecture `convergence`: two double pendulums, only one of them right, whose numerical solutions both converge."""

from collections.abc import Sequence
from types import SimpleNamespace

import numpy as np

from tam570.integrate import solve
from tam570.show.drawing import graph
from tam570.show.live import Live, energies
from tam570.show.plots import drift_caption, value_plot, values
from tam570.show.rods import joints, rod_handles
from tam570.show.scene import INK, Array, Panel, Scene, Shape, frame_times, moving
from tam570.values import Function, Parameters

METHODS = ("Euler", "Heun", "RK4")
STEPS = 0.02 / 2.0 ** np.arange(5)  # s
COLORS = (0, 1)  # right, wrong


def film(lecture: SimpleNamespace, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the right and the wrong equations with the same start.

    lecture : functions of the lecture
    """
    times, equations = frame_times(seconds), (lecture.rates, lecture.wrong_rates)
    correct, wrong = (solve(rates, times, start, parameters=parameters, rtol=1e-9) for rates in equations)
    motions = {"right equations": correct, "wrong equations": wrong}
    totals = {name: values(lecture.energy, states, **parameters) for name, states in motions.items()}
    scale = float(np.abs(totals["right equations"]).max())
    drift = drift_caption(totals["right equations"], scale, "itself, by the right")
    handles = rod_handles(2, lambda parameters: parameters["lengths"])
    return Scene(
        "Convergence is not rightness",
        "Two double pendulums start alike, one by the right equations and one that forgets a centripetal acceleration. "
        "Beside them errors over steps: for both equations each method converges with its order. Only the energy of "
        "the wrong one wanders.",
        times,
        [
            Panel([*_draw(correct, parameters), *_draw(wrong, parameters, 1, "wrong equations")]),
            Panel(_orders(lecture.errors), "error over step: both converge", ruler=False),
        ],
        [value_plot("energy", times, totals, "J", *drift)],
        still_time=0.22,
        live=Live(lecture.rates, parameters, start, _draw, handles, energies(lecture.energy, 2)),
    )


def _draw(states: Array, parameters: Parameters, color: int = 0, name: str = "right equations") -> list[Shape]:
    elbow, tip = joints(states[:, :2].T, parameters["lengths"])
    return [
        Shape("trail", tip[:, None], color, width=1, faint=True),
        Shape("path", moving(np.zeros(2), elbow, tip), color, name, width=3),
        Shape("dot", moving(elbow, tip), color, width=7),
        Shape("dot", np.zeros((1, 2)), INK, width=4),
    ]


def _orders(errors: Function) -> list[Shape]:
    """Return a log-log line of error over step for each method and equation; its slope is the order."""
    curves = {method: np.log10(errors(method, STEPS)) for method in METHODS}
    steps = np.log10(STEPS)
    axes, to_points = graph(
        np.append(steps, steps.max() + 0.25), list(curves.values()), ("log step/s", "log error/rad"), height=1.1
    )
    lines, labels = [], []
    for method, both in curves.items():
        for curve, color in zip(both, COLORS, strict=True):
            points = to_points(steps, curve)
            lines += [Shape("path", points, color, width=2), Shape("dot", points, color, width=4)]
        labels.append(Shape("text", to_points(steps[:1], both[0][:1]), INK, words=method))
    return [*axes, *lines, *labels]
