"""Plots of students: curves, scales, labels, decorations, scatters in any order, distances from a path."""

import contextlib
import runpy
import sys
import types

import numpy as np
import pytest

from tam570_grader.checks import assignments
from tam570_grader.checks.expect import Failed, check_context
from tam570_grader.checks.plots import distances, judge_axes_of_lengths, readable
from tam570_grader.checks.returns import Drawing
from tam570_grader.protocol.answer import MODES


@pytest.mark.parametrize(("shape", "equal"), [(1, True), (0.5, False), (None, False)])
def test_a_scale_is_what_is_drawn_and_pieces_of_a_line_are_one_curve_where_they_meet(shape, equal):
    from matplotlib.collections import LineCollection

    def coloured(axes, *more):
        axes.add_collection(LineCollection([[(0, 0), (1, 1)], [(1, 1), (2, 0)], [(2, 0), (3, 3)], *more]))
        axes.set(xlim=(-1, 3), ylim=(-1, 3), box_aspect=shape)

    drawn = MODES["drawing"](coloured, [], {}, {})
    (line,) = drawn["lines"]
    width, height = drawn["scales"]
    assert line["points"].tolist() == [[0, 0], [1, 1], [2, 0], [3, 3]] and (abs(width / height - 1) < 0.01) == equal
    assert len(MODES["drawing"](coloured, [[(3, 2), (3, 1)]], {}, {})["lines"]) == 4


def test_distances_from_a_polygon_are_those_to_its_sides_and_many_points_cost_no_more():
    square = [[0, 0], [2, 0], [2, 0], [2, 2]]  # a repeated corner
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


DRAWN = {  # slug: (the function that plots, its hidden check, its visible test)
    "hw02_ballistics": ("plot_comparison", "both_paths_are_drawn", "two_curves_are_drawn"),
    "hw04_hanging_spring": ("plot_projection", "the_path_is_drawn", "the_picture_has_one_curve_and_names_on_its_axes"),
    "hw07_double_pendulum": ("plot_tip_path", "tip_path_is_drawn", "the_tip_path_is_drawn"),
    "hw10_free_rigid_body": ("plot_rim_paths", "rim_paths_are_drawn", "two_paths_are_drawn"),
}
REDRAWN = """
right = {name}

def {name}(ax, *args, **kwargs):
    right(ax, *args, **kwargs)
    x, y = ax.lines[-1].get_data()
    mixed = np.random.default_rng(1).permutation([x, y], axis=1)
    right_is, up_is = ax.get_xlabel()[0], ax.get_ylabel()[0]
    {code}
"""
RIGHT = {
    "a dark page": "ax.figure.set_facecolor('k'); ax.set_facecolor('0.1'); ax.lines[-1].set_color('w');"
    " ax.xaxis.label.set_color('w'); ax.yaxis.label.set_color('w')",
    "dots far apart": "ax.lines[-1].set_linestyle((0, (1, 10)))",
    "a grid in front, a legend": "ax.grid(zorder=9); ax.legend(['path'], framealpha=1)",
    "a frame around it": "ax.figure.set_layout_engine('constrained'); ax.set_title(r'$\\undefined{$')",
    "words set by TeX": "ax.xaxis.label.set_usetex(True)",
    "limits of its own": "ax.margins(0.3); ax.set_aspect('equal', adjustable='datalim')",
    "another axis beside": "ax.secondary_xaxis('top'); ax.inset_axes([0.4, 0.4, 0.2, 0.2]).plot(y, x)",
    "hidden helpers": "ax.plot(x + y, y, visible=False); ax.figure.add_axes([0, 0, 1, 1], visible=False)",
    "a start marker and an origin": "ax.plot(x[0], y[0], 'o'); ax.plot(0, 0, '+'); ax.scatter(x[:1], y[:1])",
    "lines for reference": "ax.axhline(0); ax.axvline(0); ax.plot(x[:9], y[:9])",
    "a hinge drawn at every time": "ax.plot(0 * x, 0 * y, 'o')",
    "colours behind": "ax.contourf(*np.meshgrid(x[:12], y[:12]), np.eye(12)); ax.fill_between(x, y, alpha=0.1)",
    "fewer points": "k = np.linspace(0, len(x) - 1, len(x) // 5).astype(int); ax.lines[-1].set_data(x[k], y[k])",
    "a line from its end": "ax.lines[-1].set_data(x[::-1], y[::-1])",
    "a shuffled scatter": "ax.lines[-1].remove(); ax.scatter(*mixed)",
    "all curves in one collection": "from matplotlib.collections import LineCollection; lines = list(ax.lines);"
    " ax.add_collection(LineCollection([line.get_xydata() for line in lines])); [line.remove() for line in lines]",
    "an open path": "from matplotlib.patches import Circle, Polygon; ax.add_patch(Circle((0, 0), x.std(), fill=False));"
    " ax.lines[-1].remove(); ax.add_patch(Polygon(np.transpose([x, y]), closed=False, fill=False))",
    "a lift of the pen": "ax.lines[-1].set_data(*(np.concatenate([c[:30], [np.nan], c[29:]]) for c in (x, y)))",
    "text in TeX": r"ax.set(xlabel=rf'${right_is}$ $(\text{{m}})$', ylabel=rf'${up_is}\ \left[\mathbf{{m}}\right]$')",
}
WRONG = {
    "a hidden curve": "ax.lines[-1].set_visible(False)",
    "a clear curve": "ax.lines[-1].set_alpha(0.01)",
    "a curve without width": "ax.lines[-1].set_linewidth(0)",
    "white on white": "ax.lines[-1].set_color('w')",
    "a curve cut off": "ax.lines[-1].set_clip_box(__import__('matplotlib').transforms.Bbox.unit())",
    "a curve elsewhere": "ax.lines[-1].set_transform(ax.transAxes)",
    "half a curve": "ax.set_xlim((x.min() + x.max()) / 2, x.max() + 1)",
    "limits elsewhere": "ax.set(xlim=(1e7, 2e7), ylim=(1e7, 2e7))",
    "axes like a dot": "ax.set_position([0.5, 0.5, 0.01, 0.01])",
    "turned round": "ax.invert_xaxis(); ax.invert_yaxis()",
    "logarithmic": "ax.set_xscale('symlog', linthresh=1e-3); ax.set_yscale('symlog', linthresh=1e-3)",
    "no axis": "ax.axis('off')",
    "a white label": "ax.xaxis.label.set_color('w')",
    "a label like a dot": "ax.yaxis.label.set_fontsize(0.1)",
    "one label twice": "ax.set_ylabel(ax.get_xlabel())",
    "no curve": "ax.lines[-1].remove()",
    "another curve": "ax.plot(x + y, y)",
    "few points": "ax.lines[-1].set_data(np.linspace(x[0], x[-1], 9), np.linspace(y[0], y[-1], 9))",
    "a scatter without its last quarter": "ax.lines[-1].remove(); n = len(x) * 3 // 4; ax.scatter(x[:n], y[:n])",
    "a scatter of another curve": "ax.lines[-1].remove(); ax.scatter(y, x)",
    "unordered points, joined": "ax.lines[-1].set_data(*mixed)",
    "another unit": r"ax.set(xlabel=r'$x\,(\mathrm{mm})$')",
}
SEEN = {"no curve", "another curve", "few points", "another unit"}  # the visible tests detect these, too


def redrawn(slug, code, text):
    """Return the solution with code that changes the picture."""
    return text + "\nimport numpy as np\n" + REDRAWN.format(name=DRAWN[slug][0], code=code)


def run_hidden_check(slug, student, course):
    """Run the hidden check of the picture."""
    (check,) = (check for check in assignments.assignment(course, slug).checks if check.name == DRAWN[slug][1])
    with check_context():
        check.run(student, np.random.default_rng(3))


def tried(slug, text, course, monkeypatch):
    """Run the visible test of the picture."""
    module = types.ModuleType(slug)
    exec(text, vars(module))
    monkeypatch.setitem(sys.modules, slug, module)
    path = course / "assignments" / slug / f"test_{slug}.py"
    runpy.run_path(str(path))[f"test_{DRAWN[slug][2]}"]()


def pictures(fields):
    """Return the parameters of each picture in each assignment; all are slow except one assignment of every third."""
    return [
        pytest.param(what, slug, marks=[] if row % 3 == 0 and row // 3 % len(DRAWN) == column else [pytest.mark.slow])
        for row, what in enumerate(fields)
        for column, slug in enumerate(DRAWN)
    ]


@pytest.mark.parametrize(("what", "slug"), pictures(RIGHT))
def test_a_right_picture_is_one_however_it_is_drawn(what, slug, course, student_of, solution_text, monkeypatch):
    text = redrawn(slug, RIGHT[what], solution_text(slug))
    run_hidden_check(slug, student_of(slug, text), course)
    tried(slug, text, course, monkeypatch)


@pytest.mark.parametrize(("what", "slug"), pictures(WRONG))
def test_a_curve_that_is_missing_or_one_too_many_is_seen(what, slug, course, student_of, solution_text, monkeypatch):
    text = redrawn(slug, WRONG[what], solution_text(slug))
    with pytest.raises(Failed):
        run_hidden_check(slug, student_of(slug, text), course)
    if what in SEEN:
        with pytest.raises(AssertionError):
            tried(slug, text, course, monkeypatch)
