"""The student's free body diagrams, drawn on what moves."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from tam570.show.scene import Array, Shape, moving
from tam570.show.student import Student, Trouble

__all__ = ["force_shapes"]

NAME = "free_body_diagram"


def force_shapes(student: Student, *rows: Any, length: float, color: int, label: str, **known: Any) -> list[Shape]:
    """Make arrows of the forces that the student draws at each row, and dots of those of unknown direction.

    length : of every arrow, m: a diagram says where a force acts and along what, not how large it is
    """
    arrows, unknown = list[list[Array]](), list[list[Array]]()
    for diagram in student.returned(NAME, *rows, **known):
        forces = _read(diagram)
        arrows.append([np.array([at, at + length * along]) for at, along in forces if along is not None])
        unknown.append([at[None] for at, along in forces if along is None])
    shapes = [Shape("arrow", places, color, label, width=2.5) for places in _steady(arrows)]
    return shapes + [Shape("dot", places, color, "of unknown direction", width=7) for places in _steady(unknown)]


def _read(diagram: Any) -> list[tuple[Array, Array | None]]:
    """The pairs of a diagram, directions of length one; an arrow of no length draws nothing."""
    try:
        pairs = [(np.array(point, float), None if way is None else np.array(way, float)) for point, way in diagram]
    except (TypeError, ValueError):
        raise Trouble(f"{NAME} gives no list of pairs (point, direction)") from None
    if any(one is not None and (one.shape != (2,) or not np.isfinite(one).all()) for pair in pairs for one in pair):
        raise Trouble(f"{NAME} gives a point or a direction that is not two finite numbers")
    return [(at, way if way is None else way / np.linalg.norm(way)) for at, way in pairs if way is None or way.any()]


def _steady(frames: Sequence[Sequence[Array]]) -> list[Array]:
    """Each place over all frames, (n, m, 2); where a frame has fewer, the place shrinks to a point."""
    count = max(map(len, frames), default=0)
    full = next((frame for frame in frames if len(frame) == count), [])
    padded = [[*frame, *(np.repeat(one[:1], len(one), axis=0) for one in full[len(frame) :])] for frame in frames]
    return [moving(*np.swapaxes([frame[k] for frame in padded], 0, 1)) for k in range(count)]
