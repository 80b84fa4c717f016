"""Pictures of curves and free body diagrams for pages: SVG coordinates, ticks, and the text alternative."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from tam570.values import Json
from tam570_grader.checks.curves import Curve
from tam570_grader.reports.sentences import quantity
from tam570_grader.results.run_time import Speed, scenes, time_to

LEFT, RIGHT, TOP, BOTTOM = 52, 350, 10, 166  # px, edges of the frame in a drawing of 360 by 200 px, for phones
DOT = 20  # most samples that are drawn as dots
LAST = 268  # px, right edge of the frame if the names of curves are written to the right of it
EDGE, SHEET, ARROW = 50, 200, 42  # px, picture of a free body diagram: margin, size of the body, length of an arrow
QUARTERS = ("start", "1/4", "1/2", "3/4", "end")  # ticks of the motion, as its times are hidden inputs
NARROW = 3  # px, least height of a band that does not look like a line


@dataclass(frozen=True)
class Picture:
    """A drawing of a curve: what a template writes into an svg element."""

    caption: str
    alt_text: str  # text alternative for readers who cannot see the drawing
    path: str
    dots: Sequence[tuple[float, float]]
    band: tuple[float, float]  # top and height of the allowed range
    limit: str
    x: Sequence[tuple[float, str]]  # ticks
    y: Sequence[tuple[float, str]]


@dataclass(frozen=True)
class Sketch:
    """A drawing of a free body diagram."""

    caption: str
    alt_text: str
    outline: str  # SVG path of the body
    arrows: str  # SVG path of the forces
    unknown: Sequence[tuple[int, int]]  # points of application of forces with unknown direction


def sketch(drawn: Json) -> Sketch:
    """Return the picture of a free body diagram: the body's outline, and the forces as arrows."""
    outline, arrows, unknown = "", "", []
    for x1, y1, x2, y2 in drawn["outline"]:
        outline += f"M{EDGE + x1} {EDGE + SHEET - y1}L{EDGE + x2} {EDGE + SHEET - y2}"
    for x, y, angle in drawn["arrows"]:
        point = EDGE + x, EDGE + SHEET - y
        if angle is None:
            unknown.append(point)
        else:
            arrows += _arrow(*point, math.radians(angle))
    count = len(drawn["arrows"])
    alt = f"{count} {'force' if count == 1 else 'forces'}, {len(unknown)} of unknown direction."
    return Sketch(f"What you drew on {drawn['body']}.", alt, outline, arrows, unknown)


def _arrow(x: float, y: float, angle: float) -> str:
    """Return the SVG path of an arrow from (x, y), with y down; angle in rad, counterclockwise."""
    c, s = math.cos(angle), -math.sin(angle)
    tip = x + ARROW * c, y + ARROW * s
    back = [(tip[0] - 9 * c + side * s, tip[1] - 9 * s - side * c) for side in (4, -4)]
    corners = [(x, y), tip, back[0], tip, back[1]]
    return "M" + "L".join(f"{across:.0f} {down:.0f}" for across, down in corners)


@dataclass(frozen=True)
class Among:
    """A plot of run time over error: a student's point among the curves of the integrators."""

    caption: str
    alt_text: str
    paths: Sequence[tuple[str, str]]  # name and path
    names: Sequence[tuple[float, str]]  # y and text
    point: tuple[float, float]
    machine: float  # ratio of this machine's time to that of the machine of the curves
    x: Sequence[tuple[float, str]]
    y: Sequence[tuple[float, str]]


def among(slug: str, speed: Speed) -> Among:
    """Return the plot of run time against error, with smaller errors to the right as in the benchmark's plot."""
    curves = {
        name: [(machine_seconds * speed["machine"], error) for machine_seconds, error in curve]
        for name, curve in scenes()[slug]["curves"].items()
    }
    everything = [(speed["seconds"], speed["error"]), *(point for curve in curves.values() for point in curve)]
    seconds, errors = ([math.log10(numbers) for numbers in column] for column in zip(*everything, strict=True))
    (x0, x1), (y0, y1) = ((math.floor(min(logs)), math.floor(max(logs)) + 1) for logs in (errors, seconds))

    def locate(point: tuple[float, float]) -> tuple[float, float]:
        across = (x1 - math.log10(point[1])) / (x1 - x0)
        return round(LEFT + (LAST - LEFT) * across, 1), round(_up(math.log10(point[0]), y0, y1), 1)

    points_of = {name: [locate(point) for point in curve] for name, curve in curves.items() if curve}
    point = locate((speed["seconds"], speed["error"]))
    decades = range(x1, x0 - 1, -max(1, math.ceil((x1 - x0) / 6)))
    return Among(
        caption=f"Run time against error of {speed['function']}, scene: {speed['scene']}.",
        alt_text=_compared(speed, curves),
        paths=[(name, _path(places)) for name, places in points_of.items()],
        names=_spread([(places[-1][1], name) for name, places in points_of.items()]),
        point=point,
        machine=speed["machine"],
        x=[(LEFT + (LAST - LEFT) * (x1 - k) / (x1 - x0), f"1e{k}") for k in decades],
        y=[(round(_up(k, y0, y1), 1), f"1e{k}") for k in range(y0, y1 + 1)],
    )


def _compared(speed: Speed, curves: Mapping[str, Sequence[tuple[float, float]]]) -> str:
    """Return the text alternative: the student's time and error, and the methods' times to the same error."""
    times = {name: time_to(speed["error"], curve) for name, curve in curves.items()}
    others = [f"{name} {time:.2g} s" if time else f"{name} does not get there" for name, time in times.items()]
    return (
        f"Yours takes {speed['seconds']:.2g} s of processor time to an error of {speed['error']:.0e} at the end. "
        f"To the same error: {', '.join(others)}."
    )


def _spread(names: Sequence[tuple[float, str]]) -> list[tuple[float, str]]:
    """Return the names from the top down, moved down where they would overlap."""
    positions: list[tuple[float, str]] = []
    for height, name in sorted(names):
        positions.append((max(height, positions[-1][0] + 12 if positions else TOP + 4), name))
    return positions


def _path(places: Sequence[tuple[float, float]]) -> str:
    return "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in places)


def pictures(curve: Curve | None) -> list[Picture]:
    """Return the drawings of a failure: the error, and the drift of an invariant if there is one."""
    return [picture(drawn) for drawn in (curve, curve.get("keeps")) if drawn] if curve else []


def picture(curve: Curve) -> Picture:
    """Return the drawing of a curve: a drift on a linear scale, an error on a logarithmic one."""
    caption, alt_text, places, band, ticks = _drift(curve) if curve["scale"] == "linear" else _error(curve)
    unit = f", {curve['unit']}" if curve["unit"] else ""
    allowed = f"allowed up to {quantity(curve['tolerance'])}"
    return Picture(
        caption=f"{caption}{unit}.",
        alt_text=f"{alt_text} {allowed.capitalize()}.",
        path=_path(places),
        dots=[(round(x, 1), round(y, 1)) for x, y in places] if len(places) <= DOT else [],
        band=(round(band[0], 1), round(band[1], 1)),
        limit=allowed if band[1] >= NARROW else f"{allowed}, too narrow to see",
        x=[(LEFT + (RIGHT - LEFT) * quarter / 4, text) for quarter, text in enumerate(QUARTERS)],
        y=[(round(position, 1), text) for position, text in ticks],
    )


# caption and text alternative without the limit, positions of the samples, allowed band, ticks of y
Drawn = tuple[str, str, list[tuple[float, float]], tuple[float, float], list[tuple[float, str]]]


def _error(curve: Curve) -> Drawn:
    """Return what is drawn of the size of an error on a logarithmic scale; the band below the limit is allowed."""
    values, limit = curve["values"], math.log10(curve["tolerance"])
    finite = [value for value in values if value is not None]
    low, high = math.floor(min(*finite, 0) + limit - 0.2), math.ceil(max(*finite, 0) + limit + 0.2)
    places = _places([None if v is None else v + limit for v in values], low, high)
    decades = range(low, high + 1, max(1, math.ceil((high - low) / 5)))
    line = _up(limit, low, high)
    # the text has both ends, as a wrong start is another mistake than an error that grows
    first, last = (curve["tolerance"] * 10**value for value in (finite[0], finite[-1]))
    caption = f"The error of {curve['quantity']} along your motion"
    alt_text = f"It begins at about {first:.0e} and ends at about {last:.0e}. {_crossing(curve)}"
    ticks = [(_up(decade, low, high), f"1e{decade}") for decade in decades]
    return caption, alt_text, places, (line, BOTTOM - line), ticks


def _drift(curve: Curve) -> Drawn:
    """Return what is drawn of the signed deviation of an invariant from its right value, on a linear scale."""
    values, limit = curve["values"], curve["tolerance"]
    finite = [value for value in values if value is not None]
    low, high = min(*finite, -limit), max(*finite, limit)
    low, high = low - (high - low) / 20, high + (high - low) / 20
    places = _places(values, low, high)
    top, bottom = _up(limit, low, high), _up(-limit, low, high)
    last = finite[-1]
    ends = f"It ends {'above' if last > 0 else 'below' if last < 0 else 'at'} what it should be"
    alt_text = f"{ends}, off by {quantity(abs(last))}; the largest drift is {quantity(max(finite, key=abs))}."
    caption = f"What becomes of {curve['quantity']} along your motion"
    ticks = [(_up(value, low, high), text) for value, text in _ticks(low, high)]
    return caption, alt_text, places, (top, max(bottom - top, 0.0)), ticks


def _ticks(low: float, high: float) -> list[tuple[float, str]]:
    """Return three to eight round numbers from low to high, with their texts; low is less than high."""
    rough = (high - low) / 7.5
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(factor * power for factor in (1, 2, 5, 10) if factor * power >= rough)
    digits = max(0, math.ceil(math.log10(max(abs(low), abs(high)) / step) - 1e-9)) + 1
    counts = range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)
    return [(k * step, f"{k * step:.{digits}g}") for k in counts]


def _places(heights: Sequence[float | None], low: float, high: float) -> list[tuple[float, float]]:
    """Return the positions of the values that are not None in the frame, whose sides are the first and last sample."""
    across = (RIGHT - LEFT) / max(len(heights) - 1, 1)
    return [(LEFT + across * k, _up(height, low, high)) for k, height in enumerate(heights) if height is not None]


def _up(value: float, low: float, high: float) -> float:
    return BOTTOM - (BOTTOM - TOP) * (value - low) / (high - low)


def _crossing(curve: Curve) -> str:
    """Return a sentence on the quarter of the motion in which the error first exceeds the limit."""
    values = curve["values"]
    slot = next((k for k, value in enumerate(values) if value is not None and value > 0), None)
    if not slot:
        return "It is beyond the limit from the first sample on." if slot == 0 else ""
    words = ("first", "second", "third", "last")
    return f"It passes the limit in the {words[min(4 * slot // len(values), 3)]} quarter."
