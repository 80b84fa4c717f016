"""Save a scene with Matplotlib as a picture, an animation or a video; only frames that are saved are drawn."""

import re
from collections.abc import Callable, Collection
from functools import cache, partial
from pathlib import Path

import numpy as np
from matplotlib.animation import AbstractMovieWriter, FFMpegWriter, PillowWriter
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.patches import Polygon
from PIL import Image

from tam570.loading import Trouble
from tam570.show.page import HERE
from tam570.show.scene import RATE, Array, Panel, Scene, Shape, TimePlot
from tam570.values import Json, Numbers

SIZE = (10.0, 5.6)  # inches
DPI = 100
EVERY = {".gif": 3, ".webp": 3, ".mp4": 2}  # samples per frame: 20 and 30 frames a second
HEAD = 0.03  # largest head of an arrow, relative to the larger side of the panel
CSS_COLOUR = re.compile(r"--(\w+): (#\w+);")
PALETTE_FRAMES = 8  # from which the colours of a GIF are chosen

Update = Callable[[int], None]
Moving = tuple[Artist, Update]  # an artist, and what moves it to another sample


class _Film(Figure):
    """A figure that draws in each frame only moving artists, and those above them, over a stored image of the rest."""

    def __init__(self) -> None:
        super().__init__(figsize=SIZE, dpi=DPI)
        self._backdrop: object = None
        self._above: list[Artist] = []

    def keep_backdrop(self, moving: Collection[Artist]) -> None:
        """Draw artists below these only once, in the first frame."""
        for ax in self.axes:
            layers = sorted(ax.get_children(), key=Artist.get_zorder)
            first = next((i for i, artist in enumerate(layers) if artist in moving), len(layers))
            hidden = () if ax.axison else (ax.xaxis, ax.yaxis, ax.patch, *ax.spines.values())
            self._above += [artist for artist in layers[first:] if artist not in hidden]

    def draw(self, renderer: RendererBase) -> None:
        if self._backdrop is None:
            self._show_above(False)
            super().draw(renderer)
            self._show_above(True)
            if self._above:
                self._backdrop = renderer.copy_from_bbox(self.bbox)  # type: ignore[attr-defined]  # of Agg
        else:
            renderer.restore_region(self._backdrop)  # type: ignore[attr-defined]
        for artist in self._above:
            artist.draw(renderer)

    def _show_above(self, visible: bool) -> None:
        for artist in self._above:
            artist.set_visible(visible)


class _GifWriter(PillowWriter):
    """A writer with one palette for all frames: to choose one for each takes as long as to draw it."""

    _frames: list[Image.Image]

    def finish(self) -> None:
        some = self._frames[:: max(1, len(self._frames) // PALETTE_FRAMES)]
        palette = Image.fromarray(np.concatenate([np.asarray(frame) for frame in some])).quantize()
        self._frames = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in self._frames]
        super().finish()


def write(scene: Scene, file: Path) -> None:
    """Save a picture (.png), an animation (.gif, .webp) or a video (.mp4). Raise Trouble if a video lacks ffmpeg."""
    if file.suffix == ".png":
        figure, moving = _drawn(scene)
        for _, update in moving:
            update(round(scene.still_time * (len(scene.times) - 1)))
        return figure.savefig(file)
    every = EVERY[file.suffix]
    writer: AbstractMovieWriter
    if file.suffix != ".mp4":
        writer = (_GifWriter if file.suffix == ".gif" else PillowWriter)(fps=RATE // every)
    elif FFMpegWriter.isAvailable():
        writer = FFMpegWriter(fps=RATE // every, bitrate=1800)
    else:
        raise Trouble("a video needs ffmpeg, which is not installed; .gif and .html need nothing more")
    save_frames(scene, file, writer, every)


def save_frames(scene: Scene, file: Path, writer: AbstractMovieWriter, every: int) -> None:
    """Save the motion with a Matplotlib writer, one frame for every `every` samples."""
    figure, moving = _drawn(scene)
    figure.keep_backdrop({artist for artist, _ in moving})
    writer.setup(figure, str(file), DPI)
    for sample in range(0, len(scene.times), every):
        for _, update in moving:
            update(sample)
        writer.grab_frame()
    writer.finish()  # not `with writer.saving`, which writes the frames so far after a Ctrl-C


@cache
def _palette() -> tuple[str, ...]:
    """Return the colours of the page's light theme; the last two are those of the indices GREY and INK."""
    parameters = dict(reversed(CSS_COLOUR.findall((HERE / "page.css").read_text(encoding="utf-8"))))
    return tuple(parameters[name] for name in ("c0", "c1", "c2", "c3", "c4", "c5", "soft", "ink"))


def _drawn(scene: Scene) -> tuple[_Film, list[Moving]]:
    """Draw the scene's first frame; return the figure and its moving artists."""
    figure = _Film()
    halves = figure.subfigures(1, 2, squeeze=False, width_ratios=[2.6, 1] if scene.time_plots else [1, 0.01])
    wide, narrow = halves[0]
    figure.suptitle(scene.title)
    figure.set_layout_engine(ConstrainedLayoutEngine(rect=(0.0, 0.0, 0.985, 1.0)))
    sides = np.ptp(np.concatenate([s.points.reshape(-1, s.points.shape[-1]) for s in scene.panels[0].shapes]), axis=0)
    columns = 1 if sides[0] > 2.0 * sides[-1] else min(len(scene.panels), 3)  # wide panels go below each other
    axes = wide.subplots(-(-len(scene.panels) // columns), columns, squeeze=False).ravel()
    moving = [artist for ax, panel in zip(axes, scene.panels, strict=False) for artist in _panel(ax, panel, scene)]
    for ax in axes:
        ax.set_axis_off()
    lines_by_name = {name: line for ax in axes for line, name in zip(*ax.get_legend_handles_labels(), strict=True)}
    if lines_by_name:
        wide.legend(lines_by_name.values(), lines_by_name, loc="outside lower left", ncols=4, fontsize=8, frameon=False)
    if scene.time_plots:
        tall = narrow.subplots(len(scene.time_plots), 1, squeeze=False).ravel()
        moving += [_time_plot(ax, time_plot, scene) for ax, time_plot in zip(tall, scene.time_plots, strict=True)]
    figure.draw_without_rendering()  # compute the layout once for all frames
    figure.set_layout_engine(None)  # "none" would draw each frame twice
    return figure, moving


def _panel(ax: Axes, panel: Panel, scene: Scene) -> list[Moving]:
    shapes = [(shape, _seen(shape.points, scene.view)) for shape in panel.shapes]
    rows = np.concatenate([points.reshape(-1, 2) for _, points in shapes])
    low, high = rows.min(axis=0), rows.max(axis=0)
    margin = 0.03 * float((high - low).max() or 1.0)
    ax.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin), aspect="equal")
    ax.set_title(panel.title, fontsize=10, y=1.0)  # without y, its place is computed in each frame
    moving = []
    for shape, points in shapes:
        artist, update = _shape(ax, shape, points, HEAD * float((high - low).max()))
        update(0)
        if points.ndim > 2:
            moving.append((artist, update))
    return moving


def _seen(points: Array, view: tuple[float, float]) -> Array:
    """Project points to (..., 2), as seen from an azimuth and an elevation, without perspective."""
    if points.shape[-1] == 2:
        return points
    (ca, ce), (sa, se) = np.cos(view), np.sin(view)
    return points @ np.array([[-sa, ca, 0.0], [-se * ca, -se * sa, ce]]).T


def _shape(ax: Axes, shape: Shape, points: Array, head_size: float) -> Moving:
    """Add a shape to the axes; return its artist and what sets its points."""
    look: Json = {"color": _palette()[shape.color], "alpha": 0.25 if shape.faint else 1.0}
    still = points.ndim == 2

    def at(sample: int) -> Array:
        return points if still else points[sample]

    if shape.form == "fill":
        patch = Polygon(at(0), closed=True, linewidth=0, **look)
        ax.add_patch(patch)
        return patch, lambda sample: patch.set_xy(at(sample))
    if shape.form == "text":
        text = ax.text(0.0, 0.0, shape.words, **look)
        return text, lambda sample: text.set_position(at(sample)[0])
    joined: Numbers = {"lines": _apart, "arrow": partial(_arrows, longest=head_size)}.get(shape.form, lambda rows: rows)
    style: Json = {"marker": "o", "markersize": 1.5 * shape.width, "linestyle": ""} if shape.form == "dot" else {}
    (line,) = ax.plot([], [], linewidth=0.8 * shape.width, label=shape.name or "_", clip_on=False, **style, **look)
    if shape.form == "trail":
        so_far = np.concatenate([points, np.full((1, *points.shape[1:]), np.nan)])
        return line, lambda sample: line.set_data(*so_far[np.r_[0 : sample + 1, -1]].swapaxes(0, 1).reshape(-1, 2).T)
    return line, lambda sample: line.set_data(*joined(at(sample)).T)


def _apart(points: Array) -> Array:
    """Insert gaps (NaN) between pairs of points."""
    pairs = points.reshape(-1, 2, 2)
    gaps = np.full((len(pairs), 1, 2), np.nan)
    return np.concatenate([pairs, gaps], axis=1).reshape(-1, 2)


def _arrows(points: Array, longest: float) -> Array:
    """Return pairs of tail and tip as lines with barbs that are no longer than `longest`."""
    tails, tips = points[::2], points[1::2]
    along = tips - tails
    length = np.linalg.norm(along, axis=1, keepdims=True)
    along = along * np.minimum(0.3, longest / np.where(length > 0.0, length, 1.0))
    across = 0.5 * np.column_stack([-along[:, 1], along[:, 0]])
    gap = np.full_like(tips, np.nan)
    strokes = [tails, tips, tips - along + across, tips, tips - along - across, gap]
    return np.stack(strokes, axis=1).reshape(-1, 2)


def _time_plot(ax: Axes, time_plot: TimePlot, scene: Scene) -> Moving:
    for color, (name, curve) in zip(_palette(), time_plot.curves.items(), strict=False):
        ax.plot(time_plot.times, curve, color=color, linewidth=1.2, label=name or "_")
    ax.set(
        xlim=scene.times[[0, -1]],
        ylim=time_plot.span,
        xlabel="t (s)",
        ylabel=f"({time_plot.unit})" if time_plot.unit else "",
    )
    ax.set_title(
        f"{time_plot.title}\n{time_plot.caption}",
        fontsize=8,
        color="#b00020" if time_plot.alarm else "#1b1f24",
        wrap=True,
        y=1.0,
    )
    ax.tick_params(labelsize=8)
    if len(time_plot.curves) > 1:
        ax.legend(fontsize=7)
    now = ax.axvline(0.0, color="#667080", linewidth=1)
    return now, lambda sample: now.set_xdata([scene.times[sample]] * 2)
