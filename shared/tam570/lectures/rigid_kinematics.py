"""12 Sept: Velocity and acceleration of points of a rigid body.

A vector e that turns with a body has the rate omega x e and a constant length. So a point at the arm r from a point A
of the body has v = v_A + omega x r and a = a_A + alpha x r + omega x (omega x r). A point that moves in the body, with
v_rel and a_rel as seen from it, has two more terms: 2 omega x v_rel and a_rel, five in all (Ruina and Pratap,
Introduction to Mechanics, on general planar motion). All vectors have components in space.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import finite, numbers, positive
from tam570.show.plots import value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, arrow, frame_times, moving

EXAMPLE = {"length": 1.0, "spin": 1.6, "spin_rate": -0.5, "slide": 1.6}  # m, rad/s, rad/s^2, m/s
TERMS = ("origin", "euler", "centripetal", "coriolis", "relative")
SECONDS, SWAY = 4.0, 0.5  # s, m, of the scene: duration, amplitude of A
UP = np.array([0.0, 0.0, 1.0])


def turning_vector(omega: ArrayLike, e: ArrayLike) -> Array:
    """Return (3,) the rate of a vector e (3,) that turns with a body at omega (3,), rad/s: omega x e."""
    return np.cross(numbers(3, omega=omega), numbers(3, e=e))


def velocity(v_a: ArrayLike, omega: ArrayLike, arm: ArrayLike) -> Array:
    """Return (3,) m/s, of the body's point at `arm` (3,), m, from A, which has v_a (3,), m/s; omega (3,), rad/s."""
    return numbers(3, v_a=v_a) + np.cross(numbers(3, omega=omega), numbers(3, arm=arm))


def acceleration(a_a: ArrayLike, omega: ArrayLike, alpha: ArrayLike, arm: ArrayLike) -> Array:
    """Return (3,) m/s^2, of the body's point at `arm` (3,), m, from A, which has a_a (3,); alpha (3,) is omega'."""
    still = np.zeros(3)
    return sum(five_terms(a_a, omega, alpha, arm, still, still).values(), start=still)


def five_terms(
    a_a: ArrayLike, omega: ArrayLike, alpha: ArrayLike, arm: ArrayLike, v_rel: ArrayLike, a_rel: ArrayLike
) -> dict[str, Array]:
    """Split the acceleration of a point that moves in a turning body into terms by name, (3,) m/s^2 each.

    a_a          : (3,) m/s^2, of the body's point A: the term "origin"
    omega, alpha : (3,) rad/s and rad/s^2, of the body
    arm          : (3,) m, from A to the moving point
    v_rel, a_rel : (3,) m/s and m/s^2, of the point as seen from the body
    "euler" is alpha x arm, "centripetal" omega x (omega x arm), "coriolis" 2 omega x v_rel, "relative" a_rel.
    """
    w, r = numbers(3, omega=omega), numbers(3, arm=arm)
    parts = (
        numbers(3, a_a=a_a),
        np.cross(numbers(3, alpha=alpha), r),
        np.cross(w, np.cross(w, r)),
        2 * np.cross(w, numbers(3, v_rel=v_rel)),
        numbers(3, a_rel=a_rel),
    )
    return dict(zip(TERMS, parts, strict=True))


def film(parameters: Mapping[str, float]) -> Scene:
    """Return the scene of a bar whose end A goes to and fro, and of a bead that slides along it."""
    positive(length=parameters["length"])
    finite(**parameters)
    times = frame_times(SECONDS)
    length, slide = parameters["length"], parameters["slide"]
    angle = parameters["spin"] * times + parameters["spin_rate"] * times**2 / 2
    omega = np.outer(parameters["spin"] + parameters["spin_rate"] * times, UP)
    rate = 2 * np.pi / SECONDS  # rad/s, of A's motion
    A, v_a, a_a = (np.outer(wave, [SWAY, 0.0, 0.0]) for wave in _sway(times, rate))
    e = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    out, speed, quicker = (0.4 * length * wave[:, None] for wave in _sway(times, slide / length))
    out += 0.6 * length  # so the bead goes to and fro between .2 and 1 of the bar
    bead = A + out * e
    histories = zip(a_a, omega, out * e, speed * e, quicker * e, strict=True)
    each = [five_terms(a, w, parameters["spin_rate"] * UP, r, v, b) for a, w, r, v, b in histories]
    parts = {name: np.array([row[name] for row in each]) for name in TERMS}
    total = np.sum(list(parts.values()), axis=0)
    tip = np.array([velocity(v, w, length * d) for v, w, d in zip(v_a, omega, e, strict=True)])
    sizes = {name: np.linalg.norm(term, axis=1) for name, term in parts.items()}
    unit, end = 0.4, A + length * e  # s
    arrows = {"v of A": (end, v_a), "omega x arm": (end + unit * v_a, tip - v_a), "v of the tip": (end, tip)}
    return Scene(
        "Points of a rigid body",
        "A bar turns while its end A goes to and fro. On the left, the velocity of its tip is that of A and "
        "omega x arm. On the right a bead slides along the bar; the five terms of its acceleration, one after the "
        "other, add up to the sum.",
        times,
        [
            Panel([*_bar(A, end), *_arrows(arrows, unit, (1, 2, 0))], "velocity of the tip"),
            Panel([*_bar(A, end), *_polygon(bead, parts, total)], "acceleration of the bead"),
        ],
        [value_plot("size of each term", times, sizes, "m/s²")],
        still_time=0.06,
    )


def _sway(times: Array, rate: float) -> tuple[Array, Array, Array]:
    """Return sin(rate t), and its first and second derivative."""
    return np.sin(rate * times), rate * np.cos(rate * times), -(rate**2) * np.sin(rate * times)


def _bar(A: Array, tip: Array) -> list[Shape]:
    return [
        Shape("lines", moving(A, tip)[..., :2], INK, "bar", width=5),
        Shape("dot", A[:, None, :2], GREY, "A", width=7),
    ]


def _polygon(bead: Array, parts: Mapping[str, Array], total: Array) -> list[Shape]:
    """Draw each term from the end of the term before it."""
    unit = 1.1 / float(np.linalg.norm(total, axis=1).max())  # s^2
    arrows, end = {}, bead
    for name, term in parts.items():
        arrows[name], end = (end, term), end + unit * term
    dot = Shape("dot", bead[:, None, :2], INK, "bead", width=7)
    return [dot, *_arrows({**arrows, "acceleration": (bead, total)}, unit, (1, 2, 3, 4, 5, 0))]


def _arrows(arrows: Mapping[str, tuple[Array, Array]], unit: float, colors: tuple[int, ...]) -> list[Shape]:
    return [
        arrow(tail[:, :2], unit * vector[:, :2], color, name)
        for color, (name, (tail, vector)) in zip(colors, arrows.items(), strict=True)
    ]
