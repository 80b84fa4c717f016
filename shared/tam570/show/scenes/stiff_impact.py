"""The lecture `stiff_impact`: a ball on an elastic floor, then on stiffer ones, and a rod on two springs."""

from collections.abc import Mapping, Sequence
from types import SimpleNamespace

import numpy as np

from tam570.integrate import solve
from tam570.show.drawing import coil, graph, unit_circle
from tam570.show.live import Handle, Live, energies
from tam570.show.plots import state_energy_plot, value_plot, values
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times, moving
from tam570.values import Parameters

RADIUS, DEPTH = 0.08, 0.35  # m, of the ball, and of the floor's spring
STIFFER = (1.0, 4.0, 16.0)  # factors on the stiffness
ROD: Parameters = {"mass": 1.0, "inertia": 0.12, "arms": (-0.5, 0.3), "speed": 1.0}  # kg, kg m^2, m, m/s
RATIOS = (0.05, 1.0, 20.0)  # of the second spring's stiffness to the first


def film(lecture: SimpleNamespace, parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the bouncing ball, with graphs of the pushes and of the rod's impulses.

    lecture : functions of the lecture
    """
    times = frame_times(seconds)
    states = solve(lecture.rates, times, start, parameters=parameters, rtol=1e-9)
    floor = [Shape("lines", np.array([[-0.3, -DEPTH], [0.3, -DEPTH]]), GREY, width=3)]
    measures = energies(lecture.energy, 1)
    return Scene(
        "Collisions as stiff springs",
        "A ball bounces on a plate that a spring holds. Beside it are the pushes of ever stiffer springs, higher and "
        "shorter, with one area below each. A rod falls on two springs: all impulses that keep the energy are on an "
        "ellipse, and the ratio of the springs chooses one.",
        times,
        [
            Panel([*floor, *_draw(states, parameters)], "ball"),
            Panel(_pushes(lecture, parameters, abs(start[1]) or 1.0), "push over time: one area", ruler=False),
            Panel(_impulses(lecture), "impulses of a rod's two contacts", ruler=False),
        ],
        [
            state_energy_plot(times, states, 1, lambda rows: values(lecture.energy, rows, **parameters)),
            value_plot("push of the floor", times, {"": values(lecture.push, states, **parameters)}, "N"),
        ],
        still_time=0.04,
        live=Live(lecture.rates, parameters, start, _draw, [HANDLE], measures, backdrop=floor),
    )


def _draw(states: Array, parameters: Mapping[str, float]) -> list[Shape]:
    x = states[:, 0]
    plate = np.column_stack([0 * x, (x - np.abs(x)) / 2])
    ball = np.column_stack([0 * x, x + RADIUS])
    return [
        Shape("path", coil(np.array([[0.0, -DEPTH]]), plate, 0.04), GREY, "spring", width=2),
        Shape("lines", moving(plate - [0.15, 0.0], plate + [0.15, 0.0]), INK, width=3),
        Shape("fill", ball[:, None] + RADIUS * unit_circle(33), 0, "ball"),
    ]


HANDLE = Handle(
    lambda state, **parameters: [0.0 * state[0], state[0] + RADIUS],
    lambda point, state, **parameters: [point[1] - RADIUS, 0.0],
)


def _pushes(lecture: SimpleNamespace, parameters: Mapping[str, float], speed: float) -> list[Shape]:
    mass, gravity = parameters["mass"], parameters["gravity"]
    curves = []
    for times in STIFFER:
        k = times * parameters["stiffness"]
        _, duration = lecture.rebound(k, mass=mass, speed=speed, gravity=gravity)
        t = np.linspace(0.0, duration, 60)
        states = solve(lecture.rates, t, [0.0, -speed], parameters={**parameters, "stiffness": k}, rtol=1e-9)
        curves.append((t, k * np.maximum(-states[:, 0], 0.0), k))
    axes, to_points = graph([0.0, curves[0][0][-1]], [0.0, curves[-1][1].max()], ("t", "push"))
    labels = [
        Shape("text", to_points([t[push.argmax()]], [push.max()]), color, words=f"{k:g} N/m")
        for color, (t, push, k) in enumerate(curves)
    ]
    return [*axes, *labels, *(Shape("path", to_points(t, p), i, width=2.5) for i, (t, p, _) in enumerate(curves))]


def _impulses(lecture: SimpleNamespace) -> list[Shape]:
    """Return a graph of both impulses: the ellipse that keeps the energy, and the path to it for each ratio."""
    ways = [lecture.rod_states((1.0, ratio), **ROD)[:, 4:] for ratio in RATIOS]
    ellipse = _ellipse()
    both = np.concatenate([ellipse, *ways])
    axes, to_points = graph(both[:, 0], both[:, 1], ("impulse 1", "impulse 2"))
    shapes = [*axes, Shape("path", to_points(*ellipse.T), GREY, "weak rigidity: all that keep the energy", width=1.5)]
    for color, (ratio, way) in enumerate(zip(RATIOS, ways, strict=True), 3):
        shapes += [
            Shape("path", to_points(*way.T), color, f"springs 1 : {ratio:g}", width=2.5),
            Shape("dot", to_points(*way[-1:].T), color, width=5),
        ]
    return shapes


def _ellipse() -> Array:
    """Return (n, 2) impulses J that keep the rod's energy: J.S J/2 = speed (J1 + J2)."""
    arms = np.array(ROD["arms"])
    S = 1.0 / ROD["mass"] + np.outer(arms, arms) / ROD["inertia"]
    middle = np.linalg.solve(S, ROD["speed"] * np.ones(2))
    values, axes = np.linalg.eigh(S)
    size = np.sqrt(middle @ S @ middle / values)
    return middle + unit_circle(91) * size @ axes.T
