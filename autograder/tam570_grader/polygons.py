"""Drawn curves: polygons in the plane, compared whatever their corners are."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["distances"]

MOST_POINTS, MOST_CORNERS = 400, 4000  # a picture of a million points costs no more than one that looks alike


def distances(points: ArrayLike, polygon: ArrayLike) -> NDArray[np.float64]:
    """Distance from each of the points, or of every kth if there are many, to the nearest side of the polygon.

    points, polygon : (n, 2) and (m, 2), m > 1; the polygon's kth corners alone are joined if there are many
    """
    places, corners = _some(points, MOST_POINTS), _some(polygon, MOST_CORNERS)
    sides = np.diff(corners)
    sides[sides == 0] = 1e-300
    from_corners = places[:, None] - corners[:-1]
    share = np.clip((from_corners / sides).real, 0, 1)
    return np.asarray(np.abs(from_corners - share * sides).min(axis=1))


def _some(points: ArrayLike, most: int) -> NDArray[Any]:
    """Every kth of the points, so that there are `most` or fewer, in the complex plane."""
    points = np.asarray(points, float)
    x, y = points[:: -(-len(points) // most)].T
    return np.asarray(x + 1j * y)
