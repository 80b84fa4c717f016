"""3 Oct: Dyads, and a rotation as the sum of three of them, or of nine.

The dyad a b turns a vector r into a (b . r); its matrix is a b^T. A rotation that takes the triad e1, e2, e3 to
e1', e2', e3' is R = e1' e1 + e2' e2 + e3' e3, three dyads of mixed base vectors. With the base vectors of a single
triad it takes nine: R = sum of R_ij ei ej with R_ij = ei . R ej. Triads are (3, 3), their vectors the rows.
"""

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import array, numbers
from tam570.rotations import exp, log
from tam570.show.plots import value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, arrow, frame_times
from tam570.values import Parameters

EXAMPLE: Parameters = {  # triads, and a vector to turn, m
    "before": ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
    "after": ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)),
    "vector": (0.9, 0.5, 0.7),
}
SECONDS = 8.0  # of the scene
LARGEST = 1e-9  # error of a triad's elements; its rotation has as large an error


def dyad(a: ArrayLike, b: ArrayLike) -> Array:
    """Return (3, 3) the matrix of the dyad a b of two vectors (3,)."""
    return np.outer(numbers(3, a=a), numbers(3, b=b))


def rotation(before: ArrayLike, after: ArrayLike) -> Array:
    """Return (3, 3) the rotation with rotation(before, after) @ before[i] = after[i], as the sum of three dyads.

    before, after : (3, 3) orthonormal rows, both right-handed or both left-handed, else ValueError
    """
    old, new = _triad(before=before), _triad(after=after)
    if np.linalg.det(old) * np.linalg.det(new) < 0:
        raise ValueError("after: is of the other hand than before; only a reflection takes one to the other")
    return dyad(new[0], old[0]) + dyad(new[1], old[1]) + dyad(new[2], old[2])


def nine(R: ArrayLike, triad: ArrayLike) -> Array:
    """Return (3, 3) the coefficients R_ij = ei . R ej, with which R is the sum of the nine dyads ei ej.

    R     : (3, 3)
    triad : (3, 3) orthonormal rows, else ValueError
    """
    base = _triad(triad=triad)
    return base @ array((3, 3), R=R) @ base.T


def _triad(**vectors: ArrayLike) -> Array:
    rows = array((3, 3), **vectors)
    if np.abs(rows @ rows.T - np.eye(3)).max() > LARGEST:
        raise ValueError(f"{next(iter(vectors))}: must be three orthonormal rows, got {rows.tolist()}")
    return rows


def film(parameters: Parameters) -> Scene:
    """Return the scene of a vector that turns: its components stay, their base vectors go from triad to triad."""
    before, vector = array((3, 3), before=parameters["before"]), numbers(3, vector=parameters["vector"])
    times = frame_times(SECONDS)
    share = np.sin(np.pi * times / SECONDS) ** 2  # there and back
    rotation_vector = log(rotation(before, parameters["after"]))
    triads = before @ np.swapaxes(exp(share[:, None] * rotation_vector), 1, 2)
    parts_of_it = (before @ vector)[:, None] * triads  # ei' (ei . r)
    chain = np.concatenate([np.zeros((len(times), 1, 3)), np.cumsum(parts_of_it, axis=1)], axis=1)
    origin = np.zeros(3)
    turned = chain[:, -1]
    shapes = [
        *(Shape("arrow", np.array([origin, row]), GREY, "e1, e2, e3", width=1.5) for row in before),
        *(arrow(origin, triads[:, i], i, f"e{i + 1}'", 3) for i in range(3)),
        *(Shape("lines", chain[:, i : i + 2], i, width=2, faint=True) for i in range(3)),
        *(Shape("text", row[None], GREY, words=f"e{i + 1}") for i, row in enumerate(before)),
        *(Shape("text", triads[:, [i]], i, words=f"e{i + 1}'") for i in range(3)),
        Shape("text", vector[None], 5, words="r"),
        Shape("text", turned[:, None], INK, words="R r"),
        Shape("trail", turned[:, None], 4, width=1.5),
        Shape("arrow", np.array([origin, vector]), 5, "r", width=2.5),
        arrow(origin, turned, INK, "R r", 3.5),
    ]
    return Scene(
        "A rotation as three dyads",
        "Three base vectors turn to another triad and back. A vector turns with them: its parts along the base vectors "
        "keep their lengths, ei' (ei . r), and add up to it.",
        times,
        [Panel(shapes, ruler=False)],
        [value_plot("parts of the vector in space", times, dict(zip("xyz", turned.T, strict=True)), "m")],
        view=(0.2, 0.5),
        still_time=0.35,
    )
