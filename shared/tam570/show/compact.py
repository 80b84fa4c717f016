"""Compress a scene to as few numbers as a screen needs.

Coordinates are integers in units of half a pixel. A point that moves by less than one unit is stored once. Points that
move as one body are stored as combinations of three or four of them. A sample is not stored if linear interpolation
between its neighbours gives it to half a pixel.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tam570.loading import Trouble
from tam570.show.scene import Array, Panel, Scene, Shape, TimePlot
from tam570.values import Json, Numbers

PIXELS = 1000  # the larger side of a panel on a large screen
STEPS = 2  # units to a pixel
PLOT_PIXELS = 300  # height of a time plot
TRACK, FIXED, MIXED = range(3)  # how a point is stored; its number is 3 * index + storage


def packed(scene: Scene) -> Json:
    """Return the scene as JSON data for the player."""
    slider = scene.slider
    if slider is None:
        return _packed(scene, [_frame([panel]) for panel in scene.panels])
    frames = [_frame(panels) for panels in zip(*(film.panels for film in slider.scenes), strict=True)]
    return {
        **_packed(scene, frames),
        "slider": {
            "name": slider.name,
            "unit": slider.unit,
            "values": [_figures(value, 6) for value in slider.values],
            "chosen": slider.chosen,
            "scenes": [None if i == slider.chosen else _packed(film, frames) for i, film in enumerate(slider.scenes)],
        },
    }


def _packed(scene: Scene, frames: Sequence["_Frame"]) -> Json:
    points, space = _Points(), scene.in_space
    panels = [_packed_panel(panel, frame, points, space) for panel, frame in zip(scene.panels, frames, strict=True)]
    samples = kept_samples(np.concatenate(points.tracks, axis=1)) if points.tracks else np.array([0])
    samples = np.union1d(samples, [0, len(scene.times) - 1])
    return {
        "view": scene.view,
        "start": _figures(scene.times[0]),
        "step": _figures(scene.times[1] - scene.times[0], 12),
        "keys": _differences(samples),
        "tracks": [[_differences(axis) for axis in track[samples].T] for track in points.tracks],
        "fixed": points.fixed,
        "mixed": points.mixed,
        "panels": panels,
        "time_plots": [_packed_time_plot(time_plot) for time_plot in scene.time_plots],
    }


class _Points:
    """The points of a scene, numbered, each stored once."""

    def __init__(self) -> None:
        self.tracks: list[Array] = []
        self.fixed: list[list[int]] = []
        self.mixed: list[list[list[float]]] = []  # pairs of a point's number and its weight
        self._known: dict[bytes, int] = {}

    def still(self, point: Array) -> int:
        """Return the number of a fixed point (dim,)."""
        position = np.rint(point).astype(int)
        return self._number(position.tobytes(), self.fixed, FIXED, position.tolist)

    def moving(self, track: Array) -> int:
        """Return the number of a point with this track (n, dim)."""
        if np.ptp(track, axis=0).max() < 1.0:
            return self.still(track[0])
        return self._number(np.rint(track).tobytes(), self.tracks, TRACK, lambda: track)

    def _number(self, key: bytes, stored: list[Numbers], storage: int, value: Callable[[], Numbers]) -> int:
        if key not in self._known:
            self._known[key] = 3 * len(stored) + storage
            stored.append(value())
        return self._known[key]

    def body(self, tracks: Array) -> list[int]:
        """Return the numbers of points with these tracks (n, m, dim), most of which may move as one body."""
        base, weights = _affine_base(tracks)
        numbers = {i: self.moving(tracks[:, i]) for i in base}
        for i in range(tracks.shape[1]):
            if i not in numbers:
                numbers[i] = self._combination([numbers[j] for j in base], weights[:, i])
        return [numbers[i] for i in range(tracks.shape[1])]

    def _combination(self, base: list[int], weights: Array) -> int:
        weighted = [[number, _figures(w, 4)] for number, w in zip(base, weights, strict=True) if abs(w) > 1e-4]
        if len(weighted) == 1:
            return int(weighted[0][0])
        return self._number(repr(weighted).encode(), self.mixed, MIXED, lambda: weighted)


def _affine_base(tracks: Array) -> tuple[list[int], Array]:
    """Return the base, points of which the others are fixed combinations to half a unit; and weights (len(base), m).

    Greedy: the next point is the one farthest from the span of those before, which keeps the weights small. If the
    points do not move as one body, the base has all of them.
    """
    n, m, dim = tracks.shape
    relative = np.moveaxis(tracks - tracks[:, :1], 1, 2).reshape(n * dim, m)
    rest, base = relative.copy(), [0]
    while np.abs(rest).max() > 0.5:
        if len(base) > dim:
            return list(range(m)), np.eye(m)
        farthest = int(np.linalg.norm(rest, axis=0).argmax())
        direction = rest[:, farthest] / np.linalg.norm(rest[:, farthest])
        rest -= np.outer(direction, direction @ rest)
        base.append(farthest)
    spanning = relative[:, base[1:]]  # at most three columns, far from parallel: normal equations are accurate
    weights = np.linalg.solve(spanning.T @ spanning, spanning.T @ relative)
    return base, np.vstack([1.0 - weights.sum(axis=0), weights])


def kept_samples(tracks: Array, tolerance: float = STEPS / 2) -> NDArray[np.int64]:
    """Return which samples (n, k) to keep: linear interpolation between them gives the others (Douglas and Peucker)."""
    n = len(tracks)
    chosen, intervals = {0, n - 1}, [(0, n - 1)]
    while intervals:
        first, last = intervals.pop()
        if last - first < 2:
            continue
        share = np.arange(1, last - first)[:, None] / (last - first)
        line = tracks[first] + share * (tracks[last] - tracks[first])
        off = np.abs(tracks[first + 1 : last] - line).max(axis=1)
        worst = int(off.argmax())
        if off[worst] > tolerance:
            middle = first + 1 + worst
            chosen.add(middle)
            intervals += [(first, middle), (middle, last)]
    return np.array(sorted(chosen))


@dataclass(frozen=True)
class _Frame:
    """The scale that fits a panel, with all values of a slider, into the screen.

    middle : (dim,) m
    unit   : m
    size   : width and height, units
    flat   : whether the panel does not turn with the view
    """

    middle: Array
    unit: float
    size: tuple[float, float]
    flat: bool


def _frame(panels: Sequence[Panel]) -> _Frame:
    """Return the frame that fits all points of the panels at all times. Raise Trouble if these are too far apart."""
    rows = [shape.points.reshape(-1, shape.points.shape[-1]) for panel in panels for shape in panel.shapes]
    low = np.min([row.min(axis=0) for row in rows], axis=0)
    high = np.max([row.max(axis=0) for row in rows], axis=0)
    with np.errstate(over="ignore"):
        if not np.isfinite(high - low).all():
            raise Trouble(f"the motion goes as far as {max(high.max(), -low.min()):.1e} m: no screen shows that")
    middle, unit = (low + high) / 2, float((high - low).max() or 1.0) / (PIXELS * STEPS)
    if len(low) == 2:
        return _Frame(middle, unit, tuple((high - low) / unit), True)
    scaled = [np.abs(shape.points - middle) / unit for panel in panels for shape in panel.shapes]
    width = max(float(np.hypot(points[..., 0], points[..., 1]).max()) for points in scaled)  # seen from any side
    height = max(float(points[..., 2].max()) for points in scaled)
    return _Frame(middle, unit, (2.0 * width, 2.0 * height), False)


def _packed_panel(panel: Panel, frame: _Frame, points: _Points, in_space: bool) -> Json:
    shapes = []
    for shape in panel.shapes:
        at = (shape.points - frame.middle) / frame.unit
        if in_space and at.shape[-1] == 2:  # in a flat panel
            at = np.concatenate([at, np.zeros((*at.shape[:-1], 1))], axis=-1)
        shapes.append(shape_entry(shape, [points.still(row) for row in at] if at.ndim == 2 else points.body(at)))
    return {
        "title": panel.title,
        "flat": frame.flat,
        "ruler": panel.ruler,
        "unit": frame.unit,
        "middle": [_figures(number) for number in frame.middle],
        "size": [_figures(side, 6) for side in frame.size],
        "shapes": shapes,
    }


def shape_entry(shape: Shape, at: Sequence[int]) -> Json:
    """Return a shape's data for the page; `at` has the numbers of its points."""
    optional = {"name": shape.name, "words": shape.words, "faint": shape.faint}
    stated = {name: value for name, value in optional.items() if value}
    return {"kind": shape.form, "at": at, "color": shape.color, "width": shape.width, **stated}


def _packed_time_plot(time_plot: TimePlot) -> Json:
    low, high = time_plot.span
    unit = (high - low) / PLOT_PIXELS
    curves = np.array(list(time_plot.curves.values())).T / unit
    samples = kept_samples(curves, tolerance=0.5)
    return {
        "title": time_plot.title,
        "names": list(time_plot.curves),
        "times": [_figures(t, 6) for t in time_plot.times[samples]],
        "curves": [_differences(curve) for curve in curves[samples].T],
        "scale": unit,
        "span": time_plot.span,
        "unit": time_plot.unit,
        "note": time_plot.caption,
        "alarm": bool(time_plot.alarm),
    }


def _differences(values: NDArray[np.generic]) -> list[int]:
    """Round; return the first value, then the differences between neighbours, which have fewer digits."""
    return np.diff(np.rint(values).astype(np.int64), prepend=0).tolist()


def _figures(value: float, figures: int = 9) -> float:
    return float(f"{value:.{figures}g}")
