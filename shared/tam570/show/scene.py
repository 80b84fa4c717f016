"""What is seen: a scene of panels and time plots, made of numbers. The player and the savers show it."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.show.student import Trouble

if TYPE_CHECKING:
    from tam570.show.live import Live

__all__ = [
    "FASTEST",
    "GREY",
    "INK",
    "RATE",
    "Array",
    "Scene",
    "Panel",
    "Shape",
    "Slider",
    "TimePlot",
    "frame_times",
    "drift_note",
    "drift_plot",
    "energy_plot",
    "value_plot",
    "moving",
    "plot_samples",
    "with_slider",
]

Array = NDArray[np.float64]

RATE = 60  # samples a second, as screens show
FASTEST = math.pi * RATE  # rad/s; beyond half a turn from frame to frame the picture turns backward
PLOT_SAMPLES = 400  # of a time plot, which is about as many pixels wide

INK, GREY = -1, -2  # colours beside the numbered ones of the palette
LEAST_SPAN = 0.01  # of a time plot of deviations: what is conserved to a pixel in it looks flat, whatever the rounding
LARGEST = 1e200  # of what is drawn: its square is a number
LARGE = 1e-3  # a deviation that no careful integration has; 1e-6 is a careless one


@dataclass(frozen=True)
class Shape:
    """One thing that is drawn.

    kind   : "lines" (points in pairs), "path", "fill", "dot", "trail" (where the point has been), "arrow", "text"
    points : (m, dim) if it stands still, else (n, m, dim) at the scene's times; m
    color  : of the palette, or INK or GREY
    name   : for the legend
    words  : of a text
    width  : of the line or size of the dot, pixels
    faint  : half transparent
    """

    kind: str
    points: Array
    color: int = INK
    name: str = ""
    words: str = ""
    width: float = 2.0
    faint: bool = False


@dataclass(frozen=True)
class Panel:
    """Parts that share a scale. A flat panel of a scene in space does not turn with the others.

    ruler : whether to show how long a metre is
    """

    shapes: Sequence[Shape]
    title: str = ""
    ruler: bool = True


@dataclass(frozen=True)
class TimePlot:
    """Curves over time beside the motion.

    times  : (m,) s
    curves : by name, (m,) each
    span   : of the axis
    unit   : of the curves and the axis
    note   : what they come to
    alarm  : the note says that something is wrong
    """

    title: str
    times: Array
    curves: Mapping[str, Array]
    span: tuple[float, float]
    unit: str
    note: str = ""
    alarm: bool = False


@dataclass(frozen=True)
class Scene:
    """A scene in motion.

    times : (n,) s, evenly spaced
    alt_text : the scene in words, for a screen reader
    view  : azimuth and elevation of the eye in a scene in space, rad
    still_time : share of the time at which a single picture shows most
    notes : what could not be shown, and why
    slider : the same scene for other values of a number
    settings : the numbers that `--set` changes, as they are
    live   : the scene as equations, where a hand can take hold of it
    """

    title: str
    alt_text: str
    times: Array
    panels: Sequence[Panel]
    time_plots: Sequence[TimePlot] = ()
    view: tuple[float, float] = (0.7, 0.35)
    still_time: float = 0.6
    notes: Sequence[str] = field(default_factory=list)
    slider: "Slider | None" = None
    settings: Mapping[str, Any] = field(default_factory=dict)
    live: "Live | None" = None

    @property
    def in_space(self) -> bool:
        """Whether any panel has three dimensions."""
        return any(shape.points.shape[-1] == 3 for panel in self.panels for shape in panel.shapes)


@dataclass(frozen=True)
class Slider:
    """One number of a scene with its values, and the scene for each.

    values : ascending
    scenes  : for each value, with as many panels each
    chosen : which one is shown first
    """

    name: str
    unit: str
    values: Sequence[float]
    scenes: Sequence[Scene]
    chosen: int


def with_slider(make: Callable[[float], Scene], name: str, unit: str, values: Sequence[float], first: float) -> Scene:
    """Return the scene for the value `first`, with a slider that changes to those for others."""
    several = sorted({*values, first})
    scenes = [make(value) for value in several]
    chosen = several.index(first)
    return replace(scenes[chosen], slider=Slider(name, unit, several, scenes, chosen))


def frame_times(seconds: float) -> Array:
    """(n,) s, evenly spaced, from 0."""
    return np.linspace(0.0, seconds, math.ceil(RATE * seconds) + 1)


def plot_samples(times: Array) -> NDArray[np.int64]:
    """Return which of the times a time plot needs."""
    count = min(len(times), PLOT_SAMPLES + 1)
    return np.rint(np.linspace(0, len(times) - 1, count)).astype(np.int64)


def moving(*points: ArrayLike) -> Array:
    """(n, m, dim) of m points that are (n, dim) each, or (dim,) if they stand still."""
    arrays = np.broadcast_arrays(*(np.asarray(point) for point in points))
    stacked = np.stack(arrays, axis=-2)
    return stacked if stacked.dtype == object else stacked.astype(float)  # objects are symbols, of a live scene


def drift_plot(
    title: str,
    times: Array,
    curves: Mapping[str, ArrayLike],
    scale: float,
    of: str,
    *,
    beside: Mapping[str, ArrayLike] | None = None,
) -> TimePlot:
    """Plot how far each of the quantities that must not change is from its first value, in percent of a scale.

    curves : by name, (m,) numbers or (m, k) vectors
    scale  : what the deviations are measured by, > 0
    of     : its name, as in "the largest kinetic energy"
    beside : curves that are shown, and need not be constant
    """
    moved, others = (
        {name: 100.0 * _deviation(v, scale) for name, v in some.items()} for some in (curves, beside or {})
    )
    shown = {**moved, **others}
    half = 1.1 * max(100.0 * LEAST_SPAN / 1.1, *(float(np.abs(curve).max()) for curve in shown.values()))
    caption, alarm = drift_note(curves, scale, of)
    return _drawable(TimePlot(title, times, shown, (-half, half), "%", caption, alarm))


def drift_note(constants: Mapping[str, ArrayLike], scale: float, of: str) -> tuple[str, bool]:
    """Tell the drift of what must not change as one number, and whether it is an alarm.

    constants : by name, (m,) numbers or (m, k) vectors
    scale, of : what the drift is measured by, > 0, and its name
    """
    largest = max(float(np.abs(_deviation(values, scale)).max()) for values in constants.values())
    alarm = largest > LARGE
    return f"{'not conserved: ' if alarm else ''}relative drift {largest:.2g} of {of}", alarm


def _deviation(values: ArrayLike, scale: float) -> Array:
    """(m,) difference from the first value, of a vector its size, as a share of the scale."""
    array = np.asarray(values, dtype=float)
    with np.errstate(over="ignore"):
        moved: Array = (array - array[0]) / scale
    return moved if moved.ndim == 1 else np.linalg.norm(moved, axis=1)


def energy_plot(times: Array, total: Array, potential: Array, title: str = "energy") -> TimePlot:
    """Plot kinetic, potential and total energy; the note tells the drift of the total.

    total, potential : (m,) J
    """
    kinetic = total - potential
    scale = float(np.abs(kinetic).max()) or float(np.abs(total).max()) or 1.0
    curves = {"kinetic T": kinetic, "potential V": potential, "total E": total}
    return value_plot(title, times, curves, "J", *drift_note({"": total}, scale, "the largest kinetic energy"))


def value_plot(
    title: str,
    times: Array,
    curves: Mapping[str, ArrayLike],
    unit: str,
    caption: str = "",
    alarm: bool = False,
    *,
    least: float = 0.0,
) -> TimePlot:
    """Plot quantities as they are; the axis reaches to `least` at least."""
    values = {name: np.asarray(curve, dtype=float) for name, curve in curves.items()}
    low = min(0.0, *(float(curve.min()) for curve in values.values()))
    high = max(least, *(float(curve.max()) for curve in values.values()))
    margin = 0.05 * (high - low) or 1.0
    return _drawable(TimePlot(title, times, values, (low - margin, high + margin), unit, caption, alarm))


def _drawable(time_plot: TimePlot) -> TimePlot:
    """Return the time plot, if its numbers have a size that can be drawn. Trouble if not."""
    if not max(map(abs, time_plot.span)) < LARGEST:
        raise Trouble(f"{time_plot.title}: the numbers are too large to be drawn")
    return time_plot
