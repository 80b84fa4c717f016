"""Read the curves of a picture, and the words on its axes."""

import re
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FEWEST = 10  # points of a curve; fewer are a marker, a line for reference or an entry of the legend


def curves(axes: "Axes") -> list[NDArray[np.float64]]:
    """Return the distinct points (n, 2) of each line, scatter or open path, without NaN, which interrupts a line."""
    from matplotlib.collections import LineCollection, PathCollection

    drawn = [line.get_xydata() for line in axes.lines if line.get_visible()]
    for collection in (c for c in axes.collections if isinstance(c, LineCollection)):
        pieces = [np.asarray(piece, float) for piece in collection.get_segments()]
        many = [piece for piece in pieces if len(piece) >= FEWEST]  # else segments of a single line in many colours
        drawn += many or [np.vstack([np.empty((0, 2)), *pieces])]
    drawn += [c.get_offsets() for c in axes.collections if isinstance(c, PathCollection)]
    for patch in axes.patches:
        path = patch.get_path()
        if not patch.get_fill() and (path.codes is None or np.all(np.asarray(path.codes) <= path.LINETO)):
            drawn.append(patch.get_patch_transform().transform(path.vertices))
    finite = [curve[np.isfinite(curve).all(axis=1)] for curve in (np.asarray(curve, float) for curve in drawn)]
    points = [np.unique(curve, axis=0) for curve in finite]
    return [curve for curve in points if len(curve) >= FEWEST]


def without_tex(label: str) -> str:
    """Remove TeX commands from a label: fonts, spaces and sizes of brackets."""
    return re.sub(r"\\[A-Za-z]+\{?|\\.|~", " ", label)


def in_metres(label: str) -> bool:
    """Return whether a label has the unit metre as a separate word, as in "x (m)" or "x in metres"."""
    words = {word.strip("()[]{}$,;:.\\") for word in without_tex(label.replace("(s)", "s")).split()}
    return "m" in words or any(word.lower().rstrip("s") in ("metre", "meter") for word in words)
