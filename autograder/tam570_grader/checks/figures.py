"""A small vocabulary for figures of mechanics: arrows, angles, dimensions, springs, ground, as SVG.

    figure = Figure("Pendulum", "A mass on a rod ...", x=(-1, 1), y=(-1.4, 0.3))
    figure.ground((0.4, 0), (-0.4, 0))
    figure.line([(0, 0), bob], "body")
    figure.angle((0, 0), 0.4, -math.pi / 2, theta - math.pi / 2, "θ")
    figure.point("m", bob)
    figure.svg()

Coordinates are those of the problem, in m; distances on paper (`by`) are in pixels, x to the right and y up.
A figure brings its own background and has two sets of colours, so that it can be read on light and dark pages.
"""

import math
import re
from collections.abc import Callable, Sequence
from html import escape
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

Vector = NDArray[np.float64]

WIDTH = 520  # px
HEAD, SLIM = 11.0, 0.3  # px, length of an arrowhead; half its width over its length
HATCH, COIL, TURNS = 9.0, 7.0, 9  # px between hatches; px, half the width of a spring, and its turns
SUBSCRIPT = re.compile(r"_(\S+)")
STYLE = "".join(map(str.strip, Path(__file__).with_name("figure.css").read_text(encoding="utf-8").splitlines()))


class Figure:
    """A drawing of the part of the plane x[0] to x[1], y[0] to y[1]."""

    def __init__(self, title: str, description: str, *, x: tuple[float, float], y: tuple[float, float]) -> None:
        self.title, self.description = title, description
        self.scale = WIDTH / (x[1] - x[0])  # px/m
        self.height = round(self.scale * (y[1] - y[0]))
        self._corner, self._parts = np.array([x[0], y[1]]), list[str]()

    def svg(self) -> str:
        """Return the drawing as SVG, with its title and description."""
        opening = (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {self.height}" width="{WIDTH}" '
            f'height="{self.height}" role="img" aria-labelledby="t d">\n'
            f'<title id="t">{escape(self.title)}</title>\n<desc id="d">{escape(self.description)}</desc>\n'
            f"<style>{STYLE}</style>\n"
            f'<rect width="{WIDTH}" height="{self.height}" rx="8"/>\n'
        )
        return opening + "\n".join(self._parts) + "\n</svg>\n"

    # Vocabulary

    def line(self, points: ArrayLike, style: str = "thin", *, closed: bool = False) -> None:
        """Join points, (n, 2); a closed line of style "solid" is filled."""
        self._path(self._on_paper(points), style, closed)

    def segments(self, pairs: ArrayLike) -> None:
        """Draw line segments (k, 2, 2), as a `wireframe` returns them."""
        for pair in np.asarray(pairs, float):
            self.line(pair, "body")

    def curve(self, points: ArrayLike, label: str = "", style: str = "angle", by: tuple[float, float] = (0, 0)) -> None:
        """Join points, with an arrowhead at the last; the label is at the middle."""
        places = self._on_paper(points)
        self._path(places, style)
        before = next((p for p in places[::-1] if math.dist(p, places[-1]) > HEAD / 2), places[0])
        self._head(before, places[-1], style)
        self._text(places[len(places) // 2], label, by, style)

    def arrow(
        self, tail: ArrayLike, tip: ArrayLike, label: str = "", style: str = "vector", by: tuple[float, float] = (0, 0)
    ) -> None:
        """Draw an arrow; the label is at its tip, by default a little beyond."""
        start, end = self._on_paper([tail, tip])
        along = (end - start) / max(math.dist(start, end), 1e-9)
        self._path([start, end - HEAD * 0.7 * along], style)
        self._head(start, end, style)
        beyond = 15 * along
        self._text(end, label, by if any(by) else (beyond[0], -beyond[1]), style)

    def angle(
        self,
        centre: ArrayLike,
        radius: float,
        start: float,
        end: float,
        label: str,
        by: tuple[float, float] | None = None,
    ) -> None:
        """Draw the arc from one direction to another, in rad, with an arrowhead at the end: the positive sense."""
        turns = np.linspace(start, end, 25)
        around = np.asarray(centre) + radius * np.column_stack([np.cos(turns), np.sin(turns)])
        outwards = 16 * math.cos(turns[12]), 16 * math.sin(turns[12])
        self.curve(around, label, by=by or outwards)

    def dimension(self, a: ArrayLike, b: ArrayLike, label: str, aside: float = 0.0) -> None:
        """Mark the distance from a to b by a line beside it, `aside` px to the left of the direction from a to b."""
        start, end = self._on_paper([a, b])
        along = (end - start) / math.dist(start, end)
        offset = aside * np.array([along[1], -along[0]])
        for point in (start, end) if aside else ():
            self._path([point + offset * 0.15, point + offset * 1.12], "soft")
        self._path([start + offset, end + offset], "soft")
        self._head(start + offset, end + offset, "soft")
        self._head(end + offset, start + offset, "soft")
        side = math.copysign(14.0, aside or 1.0) * np.array([along[1], -along[0]])
        middle = (start + end) / 2 + offset
        self._text(middle, label, (side[0], -side[1]), "thin")

    def point(self, name: str, at: ArrayLike, by: tuple[float, float] = (13, 12), size: float = 4.0) -> None:
        """Draw a point with its name, which becomes data-name in the SVG."""
        (paper,) = self._on_paper([at])
        self._parts.append(f'<circle cx="{paper[0]:.2f}" cy="{paper[1]:.2f}" r="{size:g}" data-name="{escape(name)}"/>')
        self._text(paper, name, by, "thin")

    def label(self, at: ArrayLike, text: str, by: tuple[float, float] = (0, 0), style: str = "thin") -> None:
        """Write a text."""
        self._text(self._on_paper([at])[0], text, by, style)

    def spring(self, a: ArrayLike, b: ArrayLike) -> None:
        """Draw a spring from a to b."""
        from tam570.show.drawing import coil  # imported late: checks need no scenes

        start, end = self._on_paper([a, b])
        self._path(coil(start[None], end[None], COIL, TURNS)[0], "body")

    def ground(self, a: ArrayLike, b: ArrayLike) -> None:
        """Draw a surface from a to b, hatched on the right of that direction."""
        start, end = self._on_paper([a, b])
        length = math.dist(start, end)
        along = (end - start) / length
        reference = np.array([-along[1], along[0]])
        self._path([start, end], "thin")
        marks = np.arange(HATCH / 2, length, HATCH)
        lines = [
            f"M{_xy(start + s * along)}L{_xy(start + s * along + HATCH * (reference - 0.7 * along))}" for s in marks
        ]
        self._parts.append(f'<path class="soft" d="{"".join(lines)}"/>')

    def axes(self, origin: ArrayLike, length: float, turned: float = 0.0) -> None:
        """Draw the axes of x and y, turned by an angle in rad."""
        for name, way in {"x": turned, "y": turned + math.pi / 2}.items():
            tip = np.asarray(origin) + length * np.array([math.cos(way), math.sin(way)])
            self.arrow(origin, tip, name, "thin")

    # Paper

    def _on_paper(self, points: ArrayLike | Sequence[ArrayLike]) -> Vector:
        """Return pixels to the right and down."""
        return np.asarray((np.array(points, float) - self._corner) * [self.scale, -self.scale])

    def _path(self, places: Sequence[Vector] | Vector, style: str, closed: bool = False) -> None:
        ways = "L".join(_xy(point) for point in places)
        self._parts.append(f'<path class="{style}" d="M{ways}{"Z" if closed else ""}"/>')

    def _head(self, before: Vector, tip: Vector, style: str) -> None:
        along = (tip - before) / max(math.dist(before, tip), 1e-9)
        side, base = SLIM * HEAD * np.array([-along[1], along[0]]), tip - HEAD * along
        self._parts.append(f'<path class="h {style}" d="M{_xy(tip)}L{_xy(base + side)}L{_xy(base - side)}Z"/>')

    def _text(self, point: Vector, text: str, by: tuple[float, float], style: str) -> None:
        if text:
            x, y = point[0] + by[0], point[1] - by[1]
            words = SUBSCRIPT.sub(r'<tspan dy="6" font-size="13">\1</tspan>', escape(text))
            self._parts.append(f'<text class="{style}" x="{x:.1f}" y="{y:.1f}">{words}</text>')


def seen_from(azimuth: float, elevation: float) -> Callable[[ArrayLike], Vector]:
    """Return the orthographic projection (..., 3) -> (..., 2) for an eye in this direction, in rad, z up."""
    ca, sa, ce, se = math.cos(azimuth), math.sin(azimuth), math.cos(elevation), math.sin(elevation)
    right_and_up = np.array([[-sa, ca, 0.0], [-se * ca, -se * sa, ce]])
    return lambda points: np.asarray(np.asarray(points, float) @ right_and_up.T)


def _xy(point: Vector) -> str:
    return f"{point[0]:.1f} {point[1]:.1f}"
