"""Pictures of a mistake, wrong beside right, for the class report.

A known mistake that changes an assignment's scene is shown by two scenes; other mistakes by a student's numbers or free
body diagram beside the right ones.
"""

import base64
import io
import tempfile
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from PIL import Image

from tam570.show import Trouble, scene_of
from tam570.show.pictures import write
from tam570.show.scene import Scene
from tam570_grader.checks.assignments import checks_folder
from tam570_grader.checks.failure import Failure
from tam570_grader.diagnosis.mistakes import mistakes, solution_with
from tam570_grader.reports.pictures import Sketch, sketch

SIZE = (5.0, 2.8)  # inches
COLOURS = 32
FEW = 7  # arrays with fewer rows are drawn as bars
SAME = 1e-9  # tolerance, absolute and relative, of equal scenes


@dataclass(frozen=True)
class WrongAndRight:
    """Two images as data URLs, or two free body diagrams."""

    wrong: str | Sketch
    reference: str | Sketch


def wrong_and_right(course: Path, slug: str, message: str, failure: Failure | None) -> WrongAndRight | None:
    """Return the pictures of a mistake; None if there is nothing to draw.

    message : the sentence that names the mistake
    failure : the failure of a student who made it
    """
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        try:
            if scenes := _scenes(course, slug, message):
                return scenes
            if failure and failure.sketch and isinstance(failure.expected, dict):  # free body diagrams
                return WrongAndRight(sketch(failure.sketch), sketch(failure.expected))
            return _numbers(failure)
        except (Trouble, ArithmeticError, ValueError, TypeError, LookupError):  # a mistake may have no picture
            return None


def _scenes(course: Path, slug: str, message: str) -> WrongAndRight | None:
    """Return the scene with a known mistake and the right scene; None if they are equal."""
    listed = mistakes(checks_folder(course, slug))
    overlay = next((mistake.text for mistake in listed if mistake.message == message), None)
    if overlay is None:
        return None
    solution = (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8")
    wrong, reference = (scene_of(solution_with(solution, text), slug) for text in (overlay, ""))
    pairs = list(zip(_numbers_of(wrong), _numbers_of(reference), strict=False))
    if all(a.shape == b.shape and np.allclose(a, b, SAME, SAME, equal_nan=True) for a, b in pairs):
        return None
    return WrongAndRight(_still(wrong), _still(reference))


def _numbers_of(scene: Scene) -> Iterator[NDArray[np.float64]]:
    yield from (shape.points for panel in scene.panels for shape in panel.shapes)
    yield from (curve for plot in scene.time_plots for curve in plot.curves.values())


def _still(scene: Scene) -> str:
    with tempfile.TemporaryDirectory() as folder:
        write(scene, path := Path(folder) / "still.png")
        return _address(path.read_bytes())


def _numbers(failure: Failure | None) -> WrongAndRight | None:
    """Return plots of a student's numbers and of the right ones, with the same scale."""
    if failure is None or failure.actual is None or failure.expected is None:
        return None
    both = [np.asarray(values, float) for values in (failure.actual, failure.expected)]
    if both[0].shape != both[1].shape or not both[0].size or not np.isfinite(both).all():
        return None
    low, high = min(0.0, np.min(both)), max(0.0, np.max(both))
    margin = 0.15 * (high - low) or 1.0
    return WrongAndRight(*(_plot(values, (low - margin, high + margin)) for values in both))


def _plot(values: NDArray[np.float64], span: tuple[float, float]) -> str:
    figure = Figure(SIZE, layout="constrained")
    axes = figure.subplots()
    if len(values := np.atleast_1d(values)) < FEW:
        axes.bar_label(axes.bar(range(values.size), values.ravel()), fmt="%.4g")
        axes.set_xticks(range(values.size) if values.size > 1 else [])
    else:
        axes.plot(values.reshape(len(values), -1))
        axes.set_xlabel("row")
    axes.axhline(0, color="0.5", lw=0.8)
    axes.set_ylim(*span)
    data = io.BytesIO()
    figure.savefig(data, format="png")
    return _address(data.getvalue())


def _address(png: bytes) -> str:
    """Return a data URL of a PNG image, reduced to COLOURS."""
    image = Image.open(io.BytesIO(png)).convert("RGB").quantize(COLOURS)
    data = io.BytesIO()
    image.save(data, "PNG", optimize=True)
    return "data:image/png;base64," + base64.b64encode(data.getvalue()).decode()
