"""Shapes and curves that several scenes use: circles, springs, axes, a floor, boxes, graphs."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from tam570.show.scene import GREY, Array, Shape

TINY = 1e-300  # avoids a division by 0; its root is less than any length


def unit_circle(count: int) -> Array:
    """Return (count, 2) points of a closed unit circle."""
    angles = np.linspace(0.0, 2.0 * np.pi, count)
    return np.column_stack([np.cos(angles), np.sin(angles)])


def circle(centre: ArrayLike, first: ArrayLike, other: ArrayLike, count: int = 61) -> Array:
    """Return a closed ellipse, (..., count, dim), from its centre and two semi-axes, (..., dim) each."""
    c, s = unit_circle(count).T[..., None]
    centre, first, other = (np.asarray(vector)[..., None, :] for vector in (centre, first, other))
    return centre + c * first + s * other


def coil(start: Array, end: Array, width: float, turns: int = 8) -> Array:
    """Return the zigzag of a spring in a plane, (n, 2 turns + 4, 2), between points (n, 2), with straight ends."""
    share = np.concatenate([[0.0, 0.125], 0.125 + 0.75 * (np.arange(2 * turns) + 0.5) / (2 * turns), [0.875, 1.0]])
    aside = np.concatenate([[0.0, 0.0], width * (-1.0) ** np.arange(2 * turns), [0.0, 0.0]])
    along = end - start
    across = np.stack([-along[:, 1], along[:, 0]], axis=-1)
    across = across / np.sqrt((along**2).sum(axis=1, keepdims=True) + TINY)
    return start[:, None] + share[:, None] * along[:, None] + aside[:, None] * across[:, None]


def axes(length: float) -> list[Shape]:
    """Return the axes x, y, z of space, from the origin, with their names."""
    ends = length * np.eye(3)
    arrows = np.stack([np.zeros((3, 3)), ends], axis=1).reshape(6, 3)
    names = [Shape("text", end[None], GREY, words=name) for name, end in zip("xyz", ends, strict=True)]
    return [Shape("arrow", arrows, GREY, width=1.2), *names]


def floor(low: ArrayLike, high: ArrayLike, step: float) -> Shape:
    """Return the lines of a square grid on z = 0 that covers the rectangle from low to high."""
    first, last = np.floor(np.divide(low, step)), np.ceil(np.divide(high, step))
    (x0, y0), (x1, y1) = first * step, last * step
    xs = np.arange(first[0], last[0] + 1) * step
    ys = np.arange(first[1], last[1] + 1) * step
    lines = [((x, y0, 0.0), (x, y1, 0.0)) for x in xs] + [((x0, y, 0.0), (x1, y, 0.0)) for y in ys]
    return Shape("lines", np.array(lines).reshape(-1, 3), GREY, width=1, faint=True)


def box_face(rotations: Array, size: ArrayLike) -> Array:
    """Return the corners (n, 4, 3) of the face at +z/2 of a box about the origin, turned by rotations (n, 3, 3)."""
    half = np.asarray(size, dtype=float) / 2.0
    corners = half * np.array([[1.0, 1, 1], [-1, 1, 1], [-1, -1, 1], [1, -1, 1]])
    return corners @ np.swapaxes(rotations, -1, -2)


def solid(outline: Array, color: int, name: str = "", width: float = 2.0) -> list[Shape]:
    """Return shapes of an outline (..., m, dim), closed and filled."""
    closed = np.concatenate([outline, outline[..., :1, :]], axis=-2)
    return [Shape("fill", outline, color, faint=True), Shape("path", closed, color, name, width=width)]


def placed(outline: Array, at: Array, heading: Array) -> Array:
    """Return positions (n, m, 2) of points (m, 2), ahead and to the left, of a body at (n, 2), headings (n,) in rad."""
    c, s = np.cos(heading), np.sin(heading)
    ahead, aside = np.stack([c, s], axis=-1), np.stack([-s, c], axis=-1)
    return at[:, None] + outline[:, :1] * ahead[:, None] + outline[:, 1:] * aside[:, None]


def brick(rotations: Array, size: ArrayLike, color: int, name: str) -> list[Shape]:
    """Return two opposite faces of a box about the origin, one of them filled, and the edges between them."""
    top, bottom = box_face(rotations, size), -box_face(rotations, size)[:, [2, 3, 0, 1]]
    around = np.concatenate([top, top[:, :1], bottom, bottom[:, :1]], axis=1)
    posts = np.stack([top[:, 1:], bottom[:, 1:]], axis=2).reshape(len(top), 6, 3)
    return [
        Shape("fill", top, color, faint=True),
        Shape("path", around, color, name, width=2.5),
        Shape("lines", posts, color, width=2.5),
    ]


def cone(rim: Array, color: int, name: str) -> list[Shape]:
    """Return a rim, (m, 3) fixed or (n, m, 3) moving, and lines to it from the origin."""
    spokes = rim[..., ::3, :]
    lines = np.stack([np.zeros_like(spokes), spokes], axis=-2).reshape(*rim.shape[:-2], -1, 3)
    return [Shape("path", rim, color, name, width=2), Shape("lines", lines, color, width=1)]


def graph(
    x: ArrayLike, y: ArrayLike, names: tuple[str, str], *, height: float = 0.8
) -> tuple[list[Shape], Callable[[ArrayLike, ArrayLike], Array]]:
    """Return the axes of a graph of width 1, and a function that maps values to points (..., 2) in it.

    x, y   : the values that the graph must include; any shape
    names  : of the axes, with their units
    height : of the graph
    """
    ranges = []
    for values in (np.asarray(x, dtype=float), np.asarray(y, dtype=float)):
        low, high = float(values.min()), float(values.max())
        margin = 0.06 * (high - low) or 1.0
        ranges.append((low - margin, high + margin))
    (x0, x1), (y0, y1) = ranges

    def to_points(x: ArrayLike, y: ArrayLike) -> Array:
        across = (np.asarray(x, dtype=float) - x0) / (x1 - x0)
        return np.stack(np.broadcast_arrays(across, height * (np.asarray(y, dtype=float) - y0) / (y1 - y0)), axis=-1)

    zero = to_points(x0 if x0 * x1 > 0.0 else 0.0, y0 if y0 * y1 > 0.0 else 0.0)
    ends = [[0.0, zero[1]], [1.0, zero[1]], [zero[0], 0.0], [zero[0], height]]
    places = [[0.9, zero[1] - 0.13], [zero[0], height]]  # below the axis, where no curve runs
    labels = [Shape("text", np.array([at]), GREY, words=name) for at, name in zip(places, names, strict=True)]
    return [Shape("arrow", np.array(ends), GREY, width=1.2), *labels], to_points
