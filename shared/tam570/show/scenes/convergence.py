"""The lecture `convergence`: two double pendulums, only one of them right, whose numerical solutions both converge."""

from collections.abc import Callable, Sequence

import numpy as np

from tam570.integrate import solve
from tam570.show.drawing import graph
from tam570.show.plots import drift_note, plot_samples, value_plot
from tam570.show.scene import INK, Array, Panel, Scene, Shape, TimePlot, frame_times, moving
from tam570.values import Function, Parameters

__all__ = ["film"]

METHODS = ("Euler", "Heun", "RK4")
STEPS = 0.02 / 2.0 ** np.arange(5)  # s
COLORS = (0, 1)  # right, wrong


def film(
    equations: Sequence[Function],
    energy: Callable[..., float],
    errors: Function,
    parameters: Parameters,
    start: Sequence[float],
    seconds: float,
) -> Scene:
    """Return the right equations and the wrong ones from one start."""
    times = frame_times(seconds)
    correct, wrong = (solve(rates, times, start, parameters=parameters, rtol=1e-9) for rates in equations)
    lengths = parameters["lengths"]
    return Scene(
        "Convergence is not rightness",
        "Two double pendulums start alike, one by the right equations and one that forgets a centripetal acceleration. "
        "Beside them errors over steps: for both equations each method converges with its order. Only the energy of "
        "the wrong one wanders.",
        times,
        [
            Panel(
                [*_pendulum(correct, lengths, 0, "right equations"), *_pendulum(wrong, lengths, 1, "wrong equations")]
            ),
            Panel(_orders(errors), "error over step: both converge", ruler=False),
        ],
        [_energies(times, correct, wrong, lambda state: energy(state, **parameters))],
        still_time=0.22,
    )


def _pendulum(states: Array, lengths: Sequence[float], color: int, name: str) -> list[Shape]:
    elbow, arm = (
        length * np.column_stack([np.sin(angle), -np.cos(angle)])
        for length, angle in zip(lengths, states[:, :2].T, strict=True)
    )
    tip = elbow + arm
    return [
        Shape("trail", tip[:, None], color, width=1, faint=True),
        Shape("path", moving(np.zeros(2), elbow, tip), color, name, width=3),
        Shape("dot", moving(elbow, tip), color, width=7),
        Shape("dot", np.zeros((1, 2)), INK, width=4),
    ]


def _orders(errors: Function) -> list[Shape]:
    """Return a line for each method and equation, in logarithms: its slope is the order."""
    curves = {method: np.log10(errors(method, STEPS)) for method in METHODS}
    steps = np.log10(STEPS)
    axes, to_points = graph(
        np.append(steps, steps.max() + 0.25), list(curves.values()), ("log step/s", "log error/rad"), height=1.1
    )
    lines, labels = [], []
    for method, both in curves.items():
        for values, color in zip(both, COLORS, strict=True):
            points = to_points(steps, values)
            lines += [Shape("path", points, color, width=2), Shape("dot", points, color, width=4)]
        labels.append(Shape("text", to_points(steps[:1], both[0][:1]), INK, words=method))
    return [*axes, *lines, *labels]


def _energies(times: Array, correct: Array, wrong: Array, energy: Callable[[Array], float]) -> TimePlot:
    shown = plot_samples(times)
    curves = {
        f"{name} equations": np.array([energy(state) for state in states[shown]])
        for name, states in (("right", correct), ("wrong", wrong))
    }
    scale = float(np.abs(curves["right equations"]).max()) or 1.0
    return value_plot(
        "energy", times[shown], curves, "J", *drift_note({"": curves["right equations"]}, scale, "itself, by the right")
    )
