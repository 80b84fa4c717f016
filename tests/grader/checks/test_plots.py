"""What a drawing is judged by: its curves, its scale, its labels, the distance from a path."""

import contextlib

import numpy as np
import pytest

from tam570_grader.checks.expect import Failed
from tam570_grader.checks.plots import distances, judge_axes_of_lengths, readable
from tam570_grader.checks.returns import Drawing
from tam570_grader.protocol.answer import MODES


@pytest.mark.parametrize(("shape", "equal"), [(1, True), (0.5, False), (None, False)])
def test_a_scale_is_what_is_drawn_and_a_line_in_pieces_is_one_curve(shape, equal):
    from matplotlib.collections import LineCollection

    def coloured(axes):
        axes.add_collection(LineCollection([[(0, 0), (1, 1)], [(1, 1), (2, 0)], [(2, 0), (3, 3)]]))
        axes.set(xlim=(-1, 3), ylim=(-1, 3), box_aspect=shape)

    drawn = MODES["drawing"](coloured, [], {}, {})
    (line,) = drawn["lines"]
    width, height = drawn["scales"]
    assert line["points"].tolist() == [[0, 0], [1, 1], [2, 0], [3, 3]] and (abs(width / height - 1) < 0.01) == equal


def test_lines_apart_are_as_many_curves():
    from matplotlib.collections import LineCollection

    drawn = MODES["drawing"](
        lambda axes: axes.add_collection(LineCollection([[(0, 0), (1, 1)], [(2, 1), (2, 0)]])), [], {}, {}
    )
    assert len(drawn["lines"]) == 2


def test_distances_from_a_polygon_are_those_to_its_sides_and_many_points_cost_no_more():
    square = [[0, 0], [2, 0], [2, 0], [2, 2]]  # a corner twice
    assert distances([[1, 0], [1, -3], [3, 3], [-3, 4]], square) == pytest.approx([0, 3, 2**0.5, 5])
    turn = np.linspace(0, 6, 300_000)
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    actual = distances(2 * circle, circle)
    assert len(actual) <= 400 and actual == pytest.approx(1, abs=1e-5)


@pytest.mark.parametrize(
    ("label", "reference"),
    [
        *((label, True) for label in ("x (m)", "x [m]", "right, m", "$x$ (m)", r"$x$ $[\mathrm{m}]$", "x in metres")),
        *((label, True) for label in ("Horizontal Distance (Meters)", "X [METRES]", "length in metre(s)")),
        *((f"$x{space}(m)$", True) for space in (r"\quad", r"\qquad", r"\enspace", r"\thinspace", r"\/", r"\>")),
        *((rf"$x\ {font}{{m}}$", True) for font in (r"\rm", r"\rm ", r"\boldsymbol", r"\operatorname", r"\big")),
        *((label, False) for label in ("", "x", "x (mm)", "x (M)", "m(x)", "moment", r"$x\quadm$")),
    ],
)
def test_a_label_names_metres_in_many_forms(label, reference):
    axes = Drawing((), label, "y (m)")
    with contextlib.nullcontext() if reference else pytest.raises(Failed, match="not labelled with their unit"):
        judge_axes_of_lengths(readable(axes))
