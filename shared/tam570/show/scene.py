"""Scenes as data: panels and time plots made of numbers, which the page's player and Matplotlib draw."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.values import Parameters

if TYPE_CHECKING:
    from tam570.show.live import Live

Array = NDArray[np.float64]

RATE = 60  # samples a second, as on most screens
FASTEST = math.pi * RATE  # rad/s; a body that turns more than half a turn per frame seems to turn backward

INK, GREY = -1, -2  # colours besides the numbered ones of the palette


@dataclass(frozen=True)
class Shape:
    """One element of a drawing.

    form   : "lines" (points in pairs), "path", "fill", "dot", "trail" (where the point has been), "arrow", "text"
    points : (m, dim) if it does not move, else (n, m, dim) at the scene's times; m
    color  : index in the palette, or INK or GREY
    name   : for the legend
    words  : of a text
    width  : of the line or size of the dot, pixels
    faint  : half transparent
    """

    form: str
    points: Array
    color: int = INK
    name: str = ""
    words: str = ""
    width: float = 2.0
    faint: bool = False


@dataclass(frozen=True)
class Panel:
    """Shapes with a common scale. A flat panel of a scene in space does not turn with the others.

    ruler : whether to show the length of a metre
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
    caption: about the curves
    alarm  : whether the caption says that something is wrong
    """

    title: str
    times: Array
    curves: Mapping[str, Array]
    span: tuple[float, float]
    unit: str
    caption: str = ""
    alarm: bool = False


@dataclass(frozen=True)
class Scene:
    """An animated scene.

    times : (n,) s, evenly spaced
    alt_text : description for a screen reader
    view  : azimuth and elevation of the viewer of a scene in space, rad
    still_time : fraction of the duration, at which a single picture shows most
    notes : what could not be shown, and why
    slider : the same scene for other values of a number
    settings : values of the numbers that `--set` changes
    live   : the equations, if the scene is interactive
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
    settings: Parameters = field(default_factory=dict)
    live: "Live | None" = None

    @property
    def in_space(self) -> bool:
        """Whether any panel has three dimensions."""
        return any(shape.points.shape[-1] == 3 for panel in self.panels for shape in panel.shapes)


@dataclass(frozen=True)
class Slider:
    """One number of a scene with its values, and the scene for each.

    values : ascending
    scenes  : for each value, with the same number of panels
    chosen : index of the scene that is shown first
    """

    name: str
    unit: str
    values: Sequence[float]
    scenes: Sequence[Scene]
    chosen: int


def with_slider(make: Callable[[float], Scene], name: str, unit: str, values: Sequence[float], first: float) -> Scene:
    """Return the scene for the value `first`, with a slider to the scenes for the other values."""
    several = sorted({*values, first})
    scenes = [make(value) for value in several]
    chosen = several.index(first)
    return replace(scenes[chosen], slider=Slider(name, unit, several, scenes, chosen))


def frame_times(seconds: float) -> Array:
    """Return the times of the frames, (n,) s, evenly spaced from 0. Raise ValueError for a motion too short to see."""
    if not RATE * seconds > 2:
        raise ValueError(f"all is over within {seconds:g} s, which is too fast to be drawn")
    return np.linspace(0.0, seconds, math.ceil(RATE * seconds) + 1)


def drawable_rate(name: str, rate: float) -> None:
    """Raise ValueError, with the rate's name, if a body at this rate in rad/s would seem to turn backward."""
    if abs(rate) >= FASTEST:
        raise ValueError(f"{name}: below {FASTEST:.0f} rad/s, to be drawn, got {rate:g}")


def arrow(tail: ArrayLike, vector: ArrayLike, color: int, name: str = "", width: float = 2.5) -> Shape:
    """Return an arrow from its tail, (n, dim) or (dim,), along a vector, (n, dim)."""
    return Shape("arrow", moving(tail, np.add(tail, vector)), color, name, width=width)


def moving(*points: ArrayLike) -> Array:
    """Stack m points that are (n, dim) each, or (dim,) if fixed, to (n, m, dim)."""
    arrays = np.broadcast_arrays(*(np.asarray(point) for point in points))
    stacked = np.stack(arrays, axis=-2)
    return stacked if stacked.dtype == object else stacked.astype(float)  # objects are symbols of a trace
