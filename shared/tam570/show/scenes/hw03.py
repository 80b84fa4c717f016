"""hw03: the angular momentum by each definition and its rate, as arrows at C, while P and C move."""

import numpy as np

from tam570.show.drawing import axes
from tam570.show.plots import gap_caption, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, arrow, frame_times, moving
from tam570.show.student import StudentModule
from tam570.values import Numbers, Parameters

EXAMPLE = {"mass": 1.0}  # kg
SECONDS = 2 * np.pi
# Harmonics of the two points: frequency, cosine and sine coefficients of x, y, z; rad/s, m
P = [(1.0, (2.0, 0.0, 0.0), (0.0, 1.5, 0.5)), (2.0, (0.0, 0.0, 0.3), (0.2, 0.0, 0.0))]
C = [(1.0, (-0.6, 0.3, 0.0), (0.3, 0.4, 0.0)), (2.0, (0.0, 0.0, 0.1), (0.1, 0.0, 0.0))]
DEFINITIONS = "abc"
COLORS = {"a": 0, "b": 1, "c": 2}
LARGE = 1e-4  # of the largest rate; differences are accurate to 1e-7 of it
STEP = 1e-4  # s, of the differences


def film(student: StudentModule, parameters: Parameters) -> Scene:
    """Return the scene of two points that go round on different paths."""
    times, mass = frame_times(SECONDS), parameters["mass"]
    motion = [*_moves(P, times), *_moves(C, times)]
    r_p, v_p, a_p, r_c, v_c, _ = motion
    momenta = {d: student.each("angular_momentum", [d] * len(times), r_p, v_p, r_c, v_c, mass=mass) for d in "bc"}
    rates = {d: student.each("rate", [d] * len(times), *motion, mass=mass) for d in DEFINITIONS}
    moment = student.each("moment", r_p, a_p, r_c, mass=mass)
    names = {"b": "(a) and (b): r_P/C × m v_P", "c": "(c): r_P/C × m v_P/C"}
    momentum_arrows = [_arrow(r_c, momenta[d], momenta, COLORS[d], names[d]) for d in "bc"]
    moment_arrows = [_arrow(r_c, moment, rates, INK, "moment about C", width=6)]
    moment_arrows += [_arrow(r_c, rates[d], rates, COLORS[d], f"rate of ({d})") for d in DEFINITIONS]
    return Scene(
        "Rate of change of angular momentum",
        "Two points, P and C, go round in space. Arrows at C show the angular momentum of P about C by the three "
        "definitions, and beside them their rates of change and the moment. The rate of definition (a) is the moment, "
        "the rates of (b) and (c) are not.",
        times,
        [
            Panel([*_points(r_p, r_c), *momentum_arrows], "angular momentum"),
            Panel([*_points(r_p, r_c), *moment_arrows], "its rate, and the moment"),
        ],
        student.make_each(
            lambda: _discrepancies(student, times, motion, mass), lambda: _checked(student, times, rates, mass)
        ),
        view=(0.9, 0.5),
        still_time=0.3,
    )


def _moves(harmonics: Numbers, times: Array) -> tuple[Array, Array, Array]:
    """Return position, velocity and acceleration, (n, 3) each."""
    r, v, a = np.zeros((3, len(times), 3))
    for w, cosine, sine in harmonics:
        c, s = np.outer(np.cos(w * times), cosine), np.outer(np.sin(w * times), sine)
        r += c + s
        a -= w**2 * (c + s)
        v += w * (np.outer(np.cos(w * times), sine) - np.outer(np.sin(w * times), cosine))
    return r, v, a


def _points(r_p: Array, r_c: Array) -> list[Shape]:
    return [
        *axes(0.5),
        Shape("path", np.vstack([r_p[::4], r_p[:1]]), GREY, width=1.5, faint=True),
        Shape("path", np.vstack([r_c[::4], r_c[:1]]), GREY, width=1.5, faint=True),
        Shape("lines", moving(r_c, r_p), GREY, width=1),
        Shape("dot", r_p[:, None], 4, width=7),
        Shape("text", r_p[:, None] + [0.0, 0.0, 0.15], 4, words="P"),
        Shape("dot", r_c[:, None], INK, width=5),
        Shape("text", r_c[:, None] - [0.0, 0.0, 0.3], INK, words="C"),
    ]


def _arrow(tail: Array, vector: Array, all_of_them: dict[str, Array], color: int, name: str, width: float = 3) -> Shape:
    """Return an arrow in the scale in which the longest of all has 3 m."""
    longest = max(float(np.linalg.norm(vectors, axis=1).max()) for vectors in all_of_them.values()) or 1.0
    return arrow(tail, 3.0 * vector / longest, color, name, width)


def _discrepancies(student: StudentModule, times: Array, motion: list[Array], mass: float) -> TimePlot:
    sizes = {
        f"({d})": np.linalg.norm(student.each("discrepancy", [d] * len(times), *motion, mass=mass), axis=1)
        for d in DEFINITIONS
    }
    return value_plot("rate less moment, size", times, sizes, "N m")


def _checked(student: StudentModule, times: Array, rates: dict[str, Array], mass: float) -> TimePlot:
    """Plot the rates; the caption compares them with differences of the student's angular momentum."""
    scale = max(float(np.linalg.norm(rate, axis=1).max()) for rate in rates.values()) or 1.0
    off = {
        f"({d})": 100 * np.linalg.norm(rates[d] - _differences(student, d, times, mass), axis=1) / scale
        for d in DEFINITIONS
    }
    largest = max(float(rate.max()) for rate in off.values()) / 100
    caption = gap_caption(largest, LARGE, " of the largest rate", "dH/dt by differences: ")
    sizes = {f"({d})": np.linalg.norm(rates[d], axis=1) for d in DEFINITIONS}
    return value_plot("rate(), size", times, sizes, "N m", *caption)


def _differences(student: StudentModule, definition: str, times: Array, mass: float) -> Array:
    """Return (m, 3) central differences of angular_momentum; by definition (a), C does not move."""

    def momentum(shift: float) -> Array:
        r_p, v_p, _ = _moves(P, times + shift)
        r_c, v_c, _ = _moves(C, times + (0.0 if definition == "a" else shift))
        return student.each("angular_momentum", [definition] * len(times), r_p, v_p, r_c, v_c, mass=mass)

    return (momentum(STEP) - momentum(-STEP)) / (2 * STEP)
