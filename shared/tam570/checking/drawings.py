"""What visible tests read of a picture: its curves, and the units on its axes."""

import re

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PathCollection
from numpy.typing import NDArray

__all__ = ["curves", "in_metres"]

FEWEST = 10  # points of a curve; fewer are markers, or lines for reference


def curves(axes: Axes) -> list[NDArray[np.float64]]:
    """Return the points (n, 2) of each line or scatter, each point once, without NaN (a lift of the pen)."""
    drawn = [line.get_xydata() for line in axes.lines if line.get_visible()]
    drawn += [
        np.vstack([np.empty((0, 2)), *c.get_segments()]) for c in axes.collections if isinstance(c, LineCollection)
    ]
    drawn += [c.get_offsets() for c in axes.collections if isinstance(c, PathCollection)]
    finite = [curve[np.isfinite(curve).all(axis=1)] for curve in (np.asarray(curve, float) for curve in drawn)]
    points = [np.unique(curve, axis=0) for curve in finite]
    return [curve for curve in points if len(curve) >= FEWEST]


def in_metres(label: str) -> bool:
    """Return whether the unit is a word of its own, as in "x (m)" or "x in metres"."""
    plain = re.sub(r"\\[A-Za-z]+\{?|\\.|~", " ", label.replace("(s)", "s"))  # without TeX's commands
    words = {word.strip("()[]{}$,;:.") for word in plain.split()}
    return "m" in words or any(word.lower().rstrip("s") in ("metre", "meter") for word in words)
