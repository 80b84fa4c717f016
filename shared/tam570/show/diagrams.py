"""The forces of a student's free body diagram, drawn on the moving body."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from tam570.loading import Trouble
from tam570.show.scene import Array, Shape, moving
from tam570.show.student import StudentModule
from tam570.values import Numbers

NAME = "free_body_diagram"
COLOR = 4  # of the palette


def force_shapes(
    student: StudentModule,
    *rows: Numbers,
    size: float,
    origin: ArrayLike = (0.0, 0.0),
    axes: ArrayLike | None = None,
    color: int = COLOR,
    label: str = "forces of your diagram",
    **parameters: Numbers,
) -> list[Shape]:
    """Return arrows for the forces that the student draws at each row, and dots for those of unknown direction.

    size   : length of every arrow, m: a diagram has points and directions of forces, not magnitudes
    origin : of the diagram's axes in the scene, (dim,), or (n, dim) if it moves
    axes   : (dim, dim), the diagram's axes as rows; default: those of the scene
    """
    dim = np.shape(origin)[-1]
    turn = np.eye(dim) if axes is None else np.asarray(axes)
    try:
        diagrams = student.one_by_one(NAME, *rows, **parameters)
    except Trouble as trouble:
        student.notes.append(str(trouble))
        return []
    arrows, unknown = list[list[Array]](), list[list[Array]]()
    for forces, start in zip(diagrams, np.broadcast_to(origin, (len(diagrams), dim)), strict=True):
        placed = [(start + at @ turn, along) for at, along in forces]
        drawn = [(at, size * along / np.linalg.norm(along)) for at, along in placed if along is not None]
        arrows.append([np.array([at, at + way @ turn]) for at, way in drawn])
        unknown.append([at[None] for at, along in placed if along is None])
    shapes = [Shape("arrow", places, color, label, width=2.5) for places in _steady(arrows)]
    return shapes + [Shape("dot", places, color, "of unknown direction", width=7) for places in _steady(unknown)]


def _steady(frames: Sequence[Sequence[Array]]) -> list[Array]:
    """Return each force over all frames, (n, m, dim); in a frame with fewer forces, it shrinks to a point."""
    count = max(map(len, frames), default=0)
    full = next((frame for frame in frames if len(frame) == count), [])
    padded = [
        [*frame, *(np.repeat(values[:1], len(values), axis=0) for values in full[len(frame) :])] for frame in frames
    ]
    return [moving(*np.swapaxes([frame[k] for frame in padded], 0, 1)) for k in range(count)]
