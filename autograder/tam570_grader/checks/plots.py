"""Judge what students plot: curves with any points, the edges of boxes in any order, labels in many forms."""

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.checking.drawings import FEWEST, in_metres, without_tex
from tam570.values import Json
from tam570_grader.checks.case import Case
from tam570_grader.checks.expect import Failed, FollowsFrom, NotWritten, expect, expect_that, fail, get_context
from tam570_grader.checks.returns import Drawing, Line
from tam570_grader.checks.student import StudentFunction

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]  # points of the plane

SEEN, WITHIN, EXTENT = 0.5, 0.9, 0.02  # least share of a curve's points that show, that are within the axes; least size
STRAIGHT = 1e-3  # largest `bent` of linear axes; a logarithmic axis over a tenth of a decade has .03
LARGEST = 1e100  # coordinates that a student plots are cut to this
MOST_POINTS, MOST_CORNERS = 400, 4000  # so that a picture of a million points costs no more than a similar one
BLOCK = 128  # points per product with a path's corners, so that it fits in the cache


def readable(picture: Drawing) -> Drawing:
    """Return a drawing with labels without TeX's commands, and of its lines only those that are curves."""
    xlabel, ylabel = map(without_tex, (picture.xlabel, picture.ylabel))
    lines = (replace(line, points=_told_apart(line.points)) for line in picture.lines)
    curves = tuple(line for line in lines if len(line.points) >= FEWEST)
    return replace(picture, lines=curves, xlabel=xlabel, ylabel=ylabel)


def _told_apart(points: Array) -> Array:
    """Return the points without NaN, which interrupts a line, and without immediate repetitions."""
    points = np.clip(points[np.isfinite(points).all(axis=1)], -LARGEST, LARGEST)
    return points[np.insert(np.diff(points, axis=0).any(axis=1), 0, True)] if len(points) else points


def along(line: Line, path: Array) -> Array:
    """Return the points of a drawn line from the path's first point on; those of a scatter in the path's order."""
    if not line.scatter:
        is_reversed = abs(line.points[[-1, 0]] - path[[0, -1]]).sum() < abs(line.points[[0, -1]] - path[[0, -1]]).sum()
        return line.points[::-1] if is_reversed else line.points
    tangents = np.gradient(path, axis=0)
    nearest = _nearest(_some(line.points, len(line.points)), _some(path, len(path)))
    beyond = np.sum((line.points - path[nearest]) * tangents[nearest], axis=1)
    lengths2 = np.sum(tangents[nearest] ** 2, axis=1)
    return line.points[np.argsort(nearest + beyond / np.maximum(lengths2, 1e-300))]


def distances(points: ArrayLike, polygon: ArrayLike) -> Array:
    """Return the distance from each point, or from every kth of many, to the nearest side of the polygon.

    points, polygon : (n, 2) and (m, 2), m > 1; of many corners of the polygon, only every kth is used
    """
    places, corners = _some(points, MOST_POINTS), _some(polygon, MOST_CORNERS)
    return np.asarray(_apart(places[:, None], corners[:-1], corners[1:]).min(axis=1))


def _is_along(points: ArrayLike, polygon: ArrayLike, limit: float) -> bool:
    """Return whether each point is within `limit` of a side at its nearest corner; if not, another side may be near."""
    places, corners = _some(points, MOST_POINTS), _some(polygon, MOST_CORNERS)
    starts = np.clip(_nearest(places, corners)[:, None] + [-1, 0], 0, len(corners) - 2)
    return bool((_apart(places[:, None], corners[starts], corners[starts + 1]).min(axis=1) <= limit).all())


def _nearest(places: Complex, corners: Complex) -> NDArray[np.intp]:
    """Return the index of the corner c nearest to each place p: p.c - c^2/2 about the mean corner is largest there."""
    middle = corners.mean()
    x, y = (corners - middle).real, (corners - middle).imag
    columns = np.array([x, y, -(x**2 + y**2) / 2])
    rows = np.column_stack([(places - middle).real, (places - middle).imag, np.ones(len(places))])
    blocks = (rows[first : first + BLOCK] for first in range(0, len(rows), BLOCK))
    return np.concatenate([np.argmax(block @ columns, axis=1) for block in blocks])


def _apart(places: Complex, starts: Complex, ends: Complex) -> Array:
    """Return the distance from each place to the side between two points, all in the complex plane."""
    sides = ends - starts
    sides[sides == 0] = 1e-300
    share = np.clip(((places - starts) / sides).real, 0, 1)
    return np.asarray(np.abs(places - starts - share * sides))


def path_drawn(  # noqa: PLR0913  as `compare`
    line: Line,
    path: Array,
    *,
    tolerance: float,
    quantity: str,
    others: Mapping[str, ArrayLike],
    fewer: float = 10,
    wrong_source: Callable[[], str],
    own_paths: Callable[[], Iterable[ArrayLike]],
    near_miss_credit: bool = True,
) -> None:
    """Fail unless a line is the path from end to end, in its order or from its last point to its first.

    tolerance : largest distance of the line's points from the path, relative to the path's extent
    fewer  : factor on the tolerance for the path's points, because the line may have fewer points
    others : {hint: path, or several} of other paths, which are recognized by their ends
    wrong_source : returns the name of a wrong function whose results are to be drawn; empty if all are right
    own_paths : returns the paths by the student's own functions; raises Failed if the picture has another mistake
    """
    size, drawn = float(np.ptp(path, axis=0).max()), along(line, path)
    limit = tolerance * size

    def hint() -> str:
        if message := _other_path(drawn, path, others, limit):
            return message
        if not (name := wrong_source()):
            return "The motion is right: draw the point of each row, from t[0] to t[-1]"
        try:
            if follows_path(line, own_paths(), tolerance, fewer):
                return FollowsFrom(name)
        except (Failed, NotWritten):
            pass
        return f"{name} is wrong for this motion, too: look there first"

    options: Json = {"unit": "m", "hint": hint, "near_miss_credit": near_miss_credit}
    expect(drawn[[0, -1]], path[[0, -1]], tolerance=limit, quantity=f"an end of {quantity}", **options)
    for points, polygon, what, near in (
        (drawn, path, f"a point of {quantity}", limit),
        (path, drawn, f"a point that {quantity} passes", fewer * limit),  # the curve may have fewer points
    ):
        if get_context().listens or not _is_along(points, polygon, near):
            expect(distances(points, polygon), 0.0, tolerance=near, quantity=what, **options)
    # a curve through the same points in another order is longer; one of fewer points is shorter
    in_order = line.scatter or _arc_length(drawn) < 1.05 * _arc_length(path)
    message = f"{quantity} goes to and fro between its points"
    expect_that(in_order, message, hint="Draw the points in the order of time.")


def follows_path(line: Line, paths: Iterable[ArrayLike], tolerance: float, fewer: float = 10) -> bool:
    """Return whether a line is one of the paths, from end to end."""
    for path in map(np.asarray, paths):
        drawn, near = along(line, path), tolerance * float(np.ptp(path, axis=0).max())
        ends = np.linalg.norm(drawn[[0, -1]] - path[[0, -1]], axis=1).max()
        passed = distances(path, drawn).max()  # the curve may have fewer points
        if max(ends, distances(drawn, path).max(), passed / fewer) <= near:
            return True
    return False


def _other_path(drawn: Array, path: Array, others: Mapping[str, ArrayLike], near: float) -> str:
    """Return the hint for the other path that has the ends of the drawn one; empty if none has."""
    for message, paths in others.items():
        each = np.reshape(paths, (-1, *np.shape(paths)[-2:]))
        if any(np.allclose(drawn[[0, -1]], candidate[[0, -1]], rtol=0, atol=near) for candidate in each):
            return message
    first, last = np.linalg.norm(drawn[[0, -1]] - path[[0, -1]], axis=1)
    if first < near < last and distances(drawn, path).max() < near:
        return "It is right as far as it goes, and ends too early."
    return ""


def _arc_length(path: Array) -> float:
    return float(np.sum(np.linalg.norm(np.diff(path, axis=0), axis=1)))


def _some(points: ArrayLike, most: int) -> Complex:
    """Return every kth of the points, so that there are at most `most`, as complex numbers."""
    points = np.asarray(points, float)
    x, y = points[:: -(-len(points) // most)].T
    return np.asarray(x + 1j * y)


def curves_seen(picture: Drawing, count: int, of_small: Callable[[], str] = str) -> tuple[Line, ...]:
    """Return the curves that can be seen; fail unless there are `count`. Hidden ones in addition are allowed.

    of_small : returns the hint for a curve that is too small to be seen beside the other
    """
    seen = tuple(line for line in picture.lines if not _unseen(line))
    hidden = [line for line in picture.lines if _unseen(line)]
    if len(seen) < count and hidden:
        reason = _unseen(hidden[0])
        fail("a curve cannot be seen", hint=lambda: (of_small() if reason == TOO_SMALL else "") or reason)
    message = f"the number of curves on the axes is {len(seen)}, not {count}"
    expect_that(len(seen) == count, message, hint="A curve needs ten points or more.", label=None)
    return seen


TOO_SMALL = "It is as small as a point."


def _unseen(line: Line) -> str:
    """Return why a curve cannot be seen; empty if it can."""
    if not line.share_within >= WITHIN:
        return "It leaves the limits of the axes."
    if not line.extent >= EXTENT:
        return TOO_SMALL
    return "" if line.shows >= SEEN else "It is hidden, covered, too thin or too pale."


def judge_axes_of_lengths(
    picture: Drawing, across: str = "x horizontal", up: str = "y height vertical", *, from_below: bool = False
) -> None:
    """Fail unless both labels have the unit m as a separate word, and the axes are linear and at the same scale.

    across, up : the words that name each axis, the usual one first
    from_below : whether the picture may be seen from behind the paper: one axis reversed, or both exchanged
    """
    require = partial(expect_that, label=None)
    for label, shows, axis in zip((picture.xlabel, picture.ylabel), picture.labels_show, "xy", strict=True):
        require(in_metres(label), "the axes are not labelled with their unit, as in x (m)")
        require(shows, f"the label of the axis of {axis} cannot be seen")
    wrong, (first, other) = exchanged(picture, across, up), (names.split()[0] for names in (across, up))
    require(not any(wrong) or (from_below and all(wrong)), f"the label of {first} stands at the axis of {other}")
    require(picture.bent <= STRAIGHT, "the axes are not linear: equal lengths must look equal")
    backwards = [scale < 0 for scale in picture.scales]
    require(not any(backwards) or (from_below and not all(backwards)), "the picture is upside down")
    width, height = np.abs(picture.scales)
    require(abs(width - height) <= 0.01 * height, f"{first} and {other} are not drawn at the same scale")


def exchanged(picture: Drawing, across: str = "x", up: str = "y") -> tuple[bool, bool]:
    """Return whether the label of x, and that of y, has a name of the other axis and none of this one."""
    along_x, along_y = (set(re.findall("[a-z]+", label.lower())) for label in (picture.xlabel, picture.ylabel))
    rightward, upwards = set(across.split()), set(up.split())
    return not along_x & rightward and bool(along_x & upwards), not along_y & upwards and bool(along_y & rightward)


def judge_boxes(function: StudentFunction, cases: Iterable[tuple[Array, Array, str]], tolerance: float) -> None:
    """Fail unless the function returns the twelve edges of each box (R, size, label), with its centre at the origin."""
    calls = [Case(R, size=size).labelled(label) for R, size, label in cases]
    for call, edges in function.each(calls):
        (R,), size = call.args, call.kwargs["size"]
        words: Json = {"quantity": "an edge", "unit": "of the longest edge"}
        hint, off = partial(_mistake, edges, R, size, tolerance), _mismatch(edges, box_edges(R, size))
        expect(off, 0.0, tolerance=tolerance, scale=max(size), hint=hint, **words)


def box_edges(R: Array, size: Array) -> Array:
    """Return the twelve edges (12, 2, 3) of a box: pairs of corners that differ in one sign."""
    signs = 2 * np.array(list(np.ndindex(2, 2, 2))) - 1
    pairs = [(i, j) for i in range(8) for j in range(i) if np.count_nonzero(signs[i] != signs[j]) == 1]
    return np.asarray((signs[np.array(pairs)] * size / 2) @ R.T)


def _astray(actual: Array, expected: Array) -> float:
    """Return the largest distance of an actual edge to the nearest expected one, in either direction."""
    both_ways = [np.abs(actual[:, None] - one_way).max(axis=(2, 3)) for one_way in (expected, expected[:, ::-1])]
    return float(np.minimum(*both_ways).min(axis=1).max())


def _mismatch(actual: Array, expected: Array) -> float:
    """Return the largest distance between the edges of two boxes, in any order and direction; a missing edge counts."""
    return max(_astray(actual, expected), _astray(expected, actual))


MISTAKEN_BOXES: dict[str, Callable[[Array, Array], Array]] = {
    "The edges belong to the transpose": lambda R, size: box_edges(R.T, size),
    "The edges belong to a box of twice that size": lambda R, size: box_edges(R, 2 * size),
    "The edges belong to a box of half that size": lambda R, size: box_edges(R, size / 2),
    "The edges are along x, y, z: the size is turned, not the box": lambda R, size: box_edges(np.eye(3), R @ size),
    "The edges belong to a box with a corner at the origin": lambda R, size: box_edges(R, size) + R @ size / 2,
    "The edges are half as long: each begins in the middle": lambda R, size: (
        (box_edges(R, size) + box_edges(R, size)[:, :1]) / 2
    ),
    "The edges are not turned": lambda R, size: box_edges(np.eye(3), size),
}


def _mistake(actual: Array, R: Array, size: Array, tolerance: float) -> str:
    """Return the known mistake in the edges, else where to look."""
    near = tolerance * max(size)
    mistaken = [message for message, box in MISTAKEN_BOXES.items() if _mismatch(actual, box(R, size)) < near]
    if not mistaken and _astray(actual, box_edges(R, size)) < near:
        return "Each drawn edge is an edge of the box: is one drawn twice, and another missing?"
    return mistaken[0] if mistaken else "Three edges meet at each of the eight corners; the centre is the origin"
