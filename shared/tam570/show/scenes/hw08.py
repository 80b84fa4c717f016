"""hw08: a box turned about an axis, by the matrix and by the formula for a vector."""

import numpy as np

from tam570.arguments import array
from tam570.invariants import rotation_defect
from tam570.show.drawing import axes
from tam570.show.plots import gap_caption, value_plot
from tam570.show.scene import Array, Panel, Scene, Shape, TimePlot, frame_times
from tam570.show.student import StudentModule
from tam570.values import Parameters

EXAMPLE = {"axis": (1.0, 2.0, 2.0)}
SIZE = np.array([1.6, 1.0, 0.5])  # m
RATE = 1.0  # rad/s
SECONDS = 2 * np.pi
LARGE = 1e-9  # of the length; rounding is about 1e-15


def film(student: StudentModule, parameters: Parameters) -> Scene:
    """Return the scene of one full turn."""
    times, axis = frame_times(SECONDS), array((3,), axis=parameters["axis"])
    angles = RATE * times
    rotations = student.each("rotation_matrix", [axis] * len(times), angles)
    corners = SIZE / 2 * np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    turned = corners @ np.swapaxes(rotations, 1, 2)
    around = [corners[-1]] * len(times), [axis] * len(times), angles
    paths = student.make_each(lambda: student.each("rotate", *around))
    ends = [(i, i | bit) for i in range(8) for bit in (1, 2, 4) if not i & bit]
    n = axis / np.linalg.norm(axis)
    shapes = [
        *axes(0.8),
        Shape("lines", 1.3 * np.array([-n, n]), 3, "axis", width=2.5),
        Shape("fill", turned[:, [1, 3, 7, 5]], 0, faint=True),
        Shape("lines", turned[:, np.ravel(ends)], 0, "box by rotation_matrix()", width=2.5),
        *(Shape("trail", path[:, None], 1, "a corner by rotate()", width=2.5) for path in paths),
    ]
    defect = gap_caption(float(rotation_defect(rotations).max()), LARGE, about="RᵀR - I is ", warning="not zero: ")
    diagonal = {f"R{i + 1}{i + 1}": rotations[:, i, i] for i in range(3)}
    return Scene(
        "Axis and angle",
        "A box turns once about a fixed axis through its centre; one of its corners draws a circle.",
        times,
        [Panel(shapes, ruler=False)],
        [
            value_plot("on the diagonal of R", times, diagonal, "", *defect),
            *(_apart(times, path, turned[:, -1]) for path in paths),
        ],
    )


def _apart(times: Array, path: Array, by_matrix: Array) -> TimePlot:
    largest = float(np.linalg.norm(path - by_matrix, axis=1).max())
    caption = f"{'not' if largest > LARGE else 'as'} by rotation_matrix(): {largest:.2g} m apart"
    curves = dict(zip("xyz", path.T, strict=True))
    return value_plot("the corner by rotate()", times, curves, "m", caption, largest > LARGE)
