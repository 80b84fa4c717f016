"""What is seen: a film of panels and strips, made of numbers. A scene makes it, the player and the savers show it."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.show.student import Trouble

__all__ = [
    "GREY",
    "INK",
    "RATE",
    "Array",
    "Film",
    "Panel",
    "Part",
    "Slider",
    "Strip",
    "clock",
    "conserved",
    "energy_strip",
    "followed",
    "moving",
    "strip_samples",
    "with_slider",
]

Array = NDArray[np.float64]

RATE = 60  # samples a second, as screens show
STRIP_SAMPLES = 400  # of a strip, which is about as many pixels wide

INK, GREY = -1, -2  # colours beside the numbered ones of the palette
LEAST_SPAN = 0.01  # of a strip of deviations: what is conserved to a pixel in it looks flat, whatever the rounding
LARGEST = 1e200  # of what is drawn: its square is a number
LARGE = 1e-3  # a deviation that no careful integration has; 1e-6 is a careless one


@dataclass(frozen=True)
class Part:
    """One thing that is drawn.

    kind   : "lines" (points in pairs), "path", "fill", "dot", "trail" (where the point has been), "arrow", "text"
    points : (m, dim) if it stands still, else (n, m, dim) at the film's times; m
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

    parts: Sequence[Part]
    title: str = ""
    ruler: bool = True


@dataclass(frozen=True)
class Strip:
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
class Film:
    """A scene in motion.

    times : (n,) s, evenly spaced
    sight : what is seen, in words, for those who do not see it
    view  : azimuth and elevation of the eye in a scene in space, rad
    poster : share of the time at which a single picture tells most
    notes : what could not be shown, and why
    slider : the same scene for other values of a number
    """

    title: str
    sight: str
    times: Array
    panels: Sequence[Panel]
    strips: Sequence[Strip] = ()
    view: tuple[float, float] = (0.7, 0.35)
    poster: float = 0.6
    notes: Sequence[str] = field(default_factory=list)
    slider: "Slider | None" = None

    @property
    def in_space(self) -> bool:
        """Whether any panel has three dimensions."""
        return any(part.points.shape[-1] == 3 for panel in self.panels for part in panel.parts)


@dataclass(frozen=True)
class Slider:
    """One number of a scene with its values, and the scene for each.

    values : ascending
    films  : for each value, with as many panels each
    chosen : which one is shown first
    """

    name: str
    unit: str
    values: Sequence[float]
    films: Sequence[Film]
    chosen: int


def with_slider(make: Callable[[float], Film], name: str, unit: str, values: Sequence[float], first: float) -> Film:
    """The film for the value `first`, with a slider that changes to those for others."""
    several = sorted({*values, first})
    films = [make(value) for value in several]
    chosen = several.index(first)
    return replace(films[chosen], slider=Slider(name, unit, several, films, chosen))


def clock(seconds: float) -> Array:
    """(n,) s, evenly spaced, from 0."""
    return np.linspace(0.0, seconds, math.ceil(RATE * seconds) + 1)


def strip_samples(times: Array) -> NDArray[np.int64]:
    """Which of the times a strip needs."""
    count = min(len(times), STRIP_SAMPLES + 1)
    return np.rint(np.linspace(0, len(times) - 1, count)).astype(np.int64)


def moving(*points: ArrayLike) -> Array:
    """(n, m, dim) of m points that are (n, dim) each, or (dim,) if they stand still."""
    arrays = np.broadcast_arrays(*(np.asarray(point, dtype=float) for point in points))
    return np.stack(arrays, axis=-2)


def conserved(
    title: str,
    times: Array,
    curves: Mapping[str, ArrayLike],
    scale: float,
    of: str,
    *,
    beside: Mapping[str, ArrayLike] | None = None,
) -> Strip:
    """A strip of what should not change: how far each is from its first value.

    curves : by name, (m,) numbers or (m, k) vectors
    scale  : what the deviations are measured by, > 0
    of     : its name, as in "the largest kinetic energy"
    beside : curves that are shown, and need not be constant
    """
    judged, others = ({name: _percent(v, scale) for name, v in some.items()} for some in (curves, beside or {}))
    largest = max(float(np.abs(curve).max()) for curve in judged.values()) / 100.0
    shown = {**judged, **others}
    half = 1.1 * max(100.0 * LEAST_SPAN / 1.1, *(float(np.abs(curve).max()) for curve in shown.values()))
    alarm = largest > LARGE
    note = f"{'not conserved: ' if alarm else ''}relative drift {largest:.2g} of {of}"
    return _drawable(Strip(title, times, shown, (-half, half), "%", note, alarm))


def _percent(values: ArrayLike, scale: float) -> Array:
    """(m,) difference from the first value, of a vector its size, in % of the scale."""
    array = np.asarray(values, dtype=float)
    with np.errstate(over="ignore"):
        moved: Array = 100.0 * ((array - array[0]) / scale)
    return moved if moved.ndim == 1 else np.linalg.norm(moved, axis=1)


def energy_strip(times: Array, total: Array, potential: Array, title: str = "energy, change since the start") -> Strip:
    """A strip of the energy; its potential part tells how much of it is in play.

    total, potential : (m,) J
    """
    kinetic = float(np.abs(total - potential).max())
    scale = kinetic or float(np.abs(total).max()) or 1.0
    return conserved(title, times, {"": total}, scale, "the largest kinetic energy")


def followed(
    title: str,
    times: Array,
    curves: Mapping[str, ArrayLike],
    unit: str,
    note: str = "",
    *,
    alarm: bool = False,
    least: float = 0.0,
) -> Strip:
    """A strip of what may change, as it is; its axis reaches to `least` at least."""
    values = {name: np.asarray(curve, dtype=float) for name, curve in curves.items()}
    low = min(0.0, *(float(curve.min()) for curve in values.values()))
    high = max(least, *(float(curve.max()) for curve in values.values()))
    margin = 0.05 * (high - low) or 1.0
    return _drawable(Strip(title, times, values, (low - margin, high + margin), unit, note, alarm))


def _drawable(strip: Strip) -> Strip:
    """The strip, if its numbers have a size that can be drawn. Trouble if not."""
    if not max(map(abs, strip.span)) < LARGEST:
        raise Trouble(f"{strip.title}: the numbers are too large to be drawn")
    return strip
