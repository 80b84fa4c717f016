"""Describe by numbers what a plot function draws: the points of its curves, its labels, and which of them are visible.

    print    the figure as an image (rows, columns, 4) on white: three colours from 0 to 255, and alpha, which is 255
    ink      the pixels (rows, columns), bool, in which two prints differ

A curve is visible where the image changes when the curve alone is drawn: this covers all colours, widths and limits.
"""

import builtins
from collections.abc import Iterator
from typing import Any, TypeAlias

import numpy as np

from tam570.values import Function, Json, Numbers

from .wire import LARGEST_ARRAY, LONGEST_TEXT

__builtins__ = dict(vars(builtins))  # type: ignore[assignment]  # as in wire

Artist: TypeAlias = Any  # a Matplotlib object: axes, figure, canvas, or an artist in them

MOST_LINES = 500
MOST_PRINTED = 12  # artists that are drawn one by one; no assignment requires as many curves
FEWEST = 10  # least points of a curve
LOOKED_AT = 400  # points of a curve that are tested for visibility, up to twice as many for some curves
PRINTED = 480  # pixels of the figure's longer side
CONTRAST = 12  # least change of a colour, of 255, that counts; a light grey line of half a point has 15
SMALLEST = 2  # points, least height and width of a label, of which only a letter is drawn
PREPARED = 2  # axes prepared, each for one call of a plot function
BLOCK = 12  # pixels; gaps between dots and dashes are smaller


def picture(function: Function, args: list[Numbers], kwargs: Json, *, looked_at: bool = True) -> Json:
    """Return what the function draws on the Axes that it is given; without `looked_at`, as if nothing were visible.

    lines          : of each line its points (n, 2), label, whether it is a scatter plot; the shares of its points that
                     are visible and within the limits, and its extent as a share of the figure's longer side
    xlabel, ylabel : the labels; labels_show: whether they are visible
    scales         : pixels per unit of x to the right and of y up
    bent           : deviation of the axes from a linear scale, as a share of their length
    """
    axes = blank_axes.take()
    function(axes, *args, **kwargs)
    drawn = list(_drawn(axes))
    if sum(np.size(points) for _, pieces, _ in drawn for points in pieces) * 8 > LARGEST_ARRAY:
        return {"stranger": True}
    labels = {"xlabel": _text(axes.get_xlabel()), "ylabel": _text(axes.get_ylabel())}
    names = [_text(artist.get_label()) for artist, _, _ in drawn]
    curves = [
        artist
        for artist, pieces, _ in drawn
        if any(len(points) >= FEWEST and len(np.unique(points, axis=0)) >= FEWEST for points in pieces)
    ]
    inks = _inks(axes, curves) if looked_at else {}
    lines = [
        {"points": points, "label": name, "scatter": scatter, **_shown(axes, points, inks.get(artist))}
        for name, (artist, pieces, scatter) in zip(names, drawn, strict=True)
        for points in pieces
    ]
    return {"lines": lines, **labels, "labels_show": _labels_show(axes, inks), **_scales(axes)}


class BlankAxes:
    """Axes that are created before a submission runs, because that takes as long as drawing a picture."""

    def __init__(self) -> None:
        self._axes: list[Artist] = []
        self._settings: Json = {}

    def prepare(self) -> None:
        """Draw a first picture, so that Matplotlib loads its fonts, and create the axes."""
        picture(_first_picture, [], {})
        self._settings = _settings()
        self._axes = [self._new() for _ in range(PREPARED)]

    def take(self) -> Artist:
        """Return blank axes in a new figure; they are prepared ones if Matplotlib's settings have not changed."""
        return self._axes.pop() if self._axes and self._settings == _settings() else self._new()

    @staticmethod
    def _new() -> Artist:
        from matplotlib.figure import Figure

        return Figure().subplots()


blank_axes = BlankAxes()


def _first_picture(axes: Artist) -> None:
    """Draw texts in two sizes and a legend, as most submissions do, so that Matplotlib's lazy work is done."""
    axes.plot(range(FEWEST), label="x")
    axes.set(xlabel="x", ylabel="x", aspect="equal")
    axes.legend()


def _settings() -> Json:
    """Return Matplotlib's settings except its backend, because reading that imports pyplot."""
    from matplotlib import rcParams

    return {name: value for name, value in dict.items(rcParams) if name != "backend"}


def _drawn(axes: Artist) -> Iterator[tuple[Artist, list[Numbers], bool]]:
    """Yield each artist that draws curves, the points (n, 2) of its curves, and whether it is a scatter plot."""
    from matplotlib.collections import PathCollection

    for line in axes.lines[:MOST_LINES]:
        yield line, [_real(line.get_xydata())], False
    for collection in axes.collections[:MOST_LINES]:
        if hasattr(collection, "get_segments"):
            yield collection, [_real(piece) for piece in _joined(collection.get_segments())[:MOST_LINES]], False
        elif isinstance(collection, PathCollection):
            yield collection, [_real(collection.get_offsets())], True
    for patch in axes.patches[:MOST_LINES]:
        path = patch.get_path()
        if not patch.get_fill() and (path.codes is None or np.all(path.codes <= path.LINETO)):
            yield patch, [_real(patch.get_patch_transform().transform(path.vertices))], False


def _joined(pieces: list[Numbers]) -> list[Numbers]:
    """Return pieces that each begin where the last one ends (a line of many colours) as one line, others unchanged."""
    neighbours = zip(pieces, pieces[1:], strict=False)
    if len(pieces) < 2 or not all(len(a) and len(b) and np.array_equal(a[-1], b[0]) for a, b in neighbours):
        return pieces
    return [np.concatenate([pieces[0], *(piece[1:] for piece in pieces[1:])])]


def _real(points: Numbers) -> Numbers:
    return np.ma.filled(np.ma.asarray(points, float), np.nan).reshape(-1, 2)


def _text(text: Artist) -> str:
    return str(text)[:LONGEST_TEXT]


def _inks(axes: Artist, curves: list[Artist]) -> dict[Artist, Numbers]:
    """Return by artist the ink of each curve, and by `axes` the ink of all curves and labels together."""
    from matplotlib import rcParams
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    figure, labels = axes.figure, (axes.xaxis.label, axes.yaxis.label)
    figure.dpi = PRINTED / max(figure.get_size_inches())
    _without_words(figure, labels)
    canvas = FigureCanvasAgg(figure)
    rcParams["agg.path.chunksize"] = 10_000  # not reset afterwards, as that takes long
    with np.errstate(all="ignore"):
        full = _printed(canvas).copy()
        figure.set_layout_engine("none")  # later prints must not move anything
        visible = {artist: artist.get_visible() for artist in curves}
        for artist in (*curves, *(axis for other in figure.axes for axis in (other.xaxis, other.yaxis))):
            artist.set_visible(False)
        empty = (paper := _printed(canvas)).copy()
        inks = {axes: _ink(full, empty)}
        for artist in [artist for artist in curves if visible[artist]][:MOST_PRINTED]:
            artist.set_visible(True)
            paper[:] = empty
            artist.draw(canvas.renderer)
            inks[artist] = _ink(paper, empty) & inks[axes]  # not covered by others
    return inks


def _without_words(figure: Artist, labels: tuple[Artist, Artist]) -> None:
    """Hide spines, ticks, legends and texts, which are slow to draw or need TeX; replace the two labels by an x.

    A legend is hidden as a whole, because its layout takes as long as drawing everything else.
    """
    from matplotlib.legend import Legend
    from matplotlib.text import Text
    from matplotlib.ticker import NullLocator

    for axes in figure.axes:
        axes.get_xlim(), axes.get_ylim()  # compute the limits now, while the axes have ticks
        for spine in axes.spines.values():
            spine.set_visible(False)
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(NullLocator())
            axis.set_minor_locator(NullLocator())
    for artist in figure.findobj(lambda artist: isinstance(artist, Legend | Text)):
        if isinstance(artist, Legend):
            artist.set_visible(False)
        else:
            artist.set_usetex(False)
            artist.set_text("x" if artist in labels and artist.get_text().strip() else "")


def _printed(canvas: Artist) -> Numbers:
    """Return a print; the next one overwrites its memory."""
    canvas.draw()
    colours = np.asarray(canvas.buffer_rgba())
    opaque = colours[..., 3:]
    if opaque.min() < 255:
        colours[..., :3] = 255 + (colours[..., :3].astype(np.int16) - 255) * (opaque / 255)
        opaque[:] = 255
    return colours


def _ink(first: Numbers, other: Numbers) -> Numbers:
    """Return the ink of two prints; for speed, compare colours only in the few pixels that differ at all."""
    ink = (first.view(np.uint32) != other.view(np.uint32)).ravel()
    where = np.flatnonzero(ink)
    colours, others = (colours.reshape(-1, 4)[where].astype(np.int16) for colours in (first, other))
    ink[where] = (np.abs(colours - others) > CONTRAST).any(axis=1)
    return ink.reshape(first.shape[:2])


def _shown(axes: Artist, points: Numbers, ink: Numbers) -> dict[str, float]:
    """Return the shares of the points (of every kth) that have ink near them and are within the limits; the extent."""
    points = points[np.isfinite(points).all(axis=1)]
    points = points[:: max(1, len(points) // LOOKED_AT)]
    nothing = {"shows": 0.0, "within": 0.0, "extent": 0.0}
    if ink is None or not len(points):
        return nothing
    with np.errstate(all="ignore"):
        places = axes.transData.transform(points)
    places = places[np.isfinite(places).all(axis=1)]
    box, margin = axes.bbox, 1.0  # pixel
    is_inside = (places >= [box.x0 - margin, box.y0 - margin]) & (places <= [box.x1 + margin, box.y1 + margin])
    visible = places[is_inside.all(axis=1)]
    if not len(visible):
        return nothing
    near = _near(ink, visible)
    extent = np.ptp(visible, axis=0).max() / PRINTED
    return {"shows": float(near.sum() / len(points)), "within": len(visible) / len(points), "extent": float(extent)}


def _near(ink: Numbers, places: Numbers) -> Numbers:
    """Return whether there is ink in the block of each of these pixels or in one of its neighbours."""
    rows, columns = (-(-size // BLOCK) for size in ink.shape)
    blocks = np.zeros((rows + 2, columns + 2), bool)  # with a border
    down, across = divmod(np.flatnonzero(ink), ink.shape[1])
    blocks[down // BLOCK + 1, across // BLOCK + 1] = True
    near = blocks[:-2] | blocks[1:-1] | blocks[2:]
    near = near[:, :-2] | near[:, 1:-1] | near[:, 2:]
    row = np.clip((ink.shape[0] - places[:, 1]) // BLOCK, 0, rows - 1).astype(int)
    column = np.clip(places[:, 0] // BLOCK, 0, columns - 1).astype(int)
    return near[row, column]


def _labels_show(axes: Artist, inks: dict[Artist, Numbers]) -> list[bool]:
    if not inks:
        return [False, False]
    shown, ink = [], inks[axes]
    for label in (axes.xaxis.label, axes.yaxis.label):
        label.set_visible(True)
        box = label.get_window_extent().get_points()
        (left, bottom), (right, top) = np.clip(box, 0, max(ink.shape)).astype(int)
        there = ink[max(0, len(ink) - top - 1) : max(0, len(ink) - bottom + 1), left : right + 1].any()
        shown.append(bool(there and np.ptp(box, axis=0).min() * 72 / axes.figure.dpi >= SMALLEST))
    return shown


def _scales(axes: Artist) -> Json:
    """Return pixels per unit of x and y, negative for a reversed axis, and the deviation from linear scales."""
    (left, right), (bottom, top) = sorted(axes.get_xlim()), sorted(axes.get_ylim())
    middle = (left + right) / 2, (bottom + top) / 2
    with np.errstate(all="ignore"):
        corners = axes.transData.transform([(left, bottom), (right, bottom), (left, top), (right, top), middle])
        sides = np.array([corners[1, 0] - corners[0, 0], corners[2, 1] - corners[0, 1]])
        bent = np.abs((corners[4] - corners[:4].mean(axis=0)) / sides).max()
        return {"scales": [float(side) for side in sides / [right - left, top - bottom]], "bent": float(bent)}
