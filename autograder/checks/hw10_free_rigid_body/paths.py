"""The drawn paths of two points of a rim against the right ones, and which others they are."""

from dataclasses import replace

import numpy as np

from tam570_grader.writing.curves import along
from tam570_grader.writing.drawings import distances, exchanged


def strays(line, fine):
    """How far a drawn path is from the right one, both taken as polygons that begin and end alike.

    The right one may be ten times as far from the drawn one, which may have fewer points.
    """
    path = along(line, fine)
    ends = np.linalg.norm(path[[0, -1]] - fine[[0, -1]], axis=1)
    return max(*ends, distances(path, fine).max(), distances(fine, path).max() / 10)


MISTAKEN_PATHS = {
    "they are seen along x": lambda fine, radius: fine[:, 1:, 0],
    "they are seen along y": lambda fine, radius: fine[:, ::2, 0],
    "they are those of the points (0, radius, 0) and (0, -radius, 0)": lambda fine, radius: fine[:, :2, 1],
    "they are those of the transposes of R": lambda fine, radius: fine[:, 0, :2],
    "they start with the identity, not with the given R": lambda fine, radius: (fine[0].T @ fine)[:, :2, 0] / radius,
    "they are those of a radius of 1 m": lambda fine, radius: fine[:, :2, 0] / radius,
}


def farthest(found, path):
    """How far two drawn paths are from this one and the one opposite; either may be drawn first."""
    return min(max(map(strays, found, paths)) for paths in ((path, -path), (-path, path)))


def ends_early(line, fine, near):
    """Whether a line goes along the right path, from its start, but not to its end."""
    path = along(line, fine)
    first, last = np.linalg.norm(path[[0, -1]] - fine[[0, -1]], axis=1)
    return first < near < last and distances(path, fine).max() < near


def wrong_paths(found, picture, fine, radius):
    """Which other paths are drawn, if they are known, else what to draw."""
    path, near = fine[:, :2, 0], 1e-3 * radius
    if all(exchanged(picture)) and farthest(turned_over(found), path) < near:
        return "the label of x stands at the axis of y"
    if any(all(map(ends_early, found, paths, (near, near))) for paths in ((path, -path), (-path, path))):
        return "they end before t[-1]"
    known = [says for says, path in MISTAKEN_PATHS.items() if farthest(found, path(fine, radius)) < near]
    return known[0] if known else "x and y, in space, of the body's points (radius, 0, 0) and (-radius, 0, 0)"


def turned_over(lines):
    """The lines with x for y: by its labels a picture may be one from below, with y to the right and x up."""
    return [replace(line, points=line.points[:, ::-1]) for line in lines]
