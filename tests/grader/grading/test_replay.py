"""`tam570-grader replay`: the very call that failed, and the same call made again."""

import json
import re

import pytest

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import mistakes, overlays

SLUG = "hw08_axis_angle"


@pytest.fixture(scope="module")
def results(tmp_path_factory, course):
    """A class of one, whose rotation matrix has one term of the wrong sign."""
    folder = tmp_path_factory.mktemp("replay")
    work = folder / "submitted" / "ada" / SLUG
    work.mkdir(parents=True)
    solution = (course / "solutions" / f"{SLUG}.py").read_text()
    slip = overlays(assignments.checks_folder(course, SLUG))["square_subtracted"]
    (work / f"{SLUG}.py").write_text(f"{solution}\n\n{slip}")
    (folder / "reference.py").write_text(solution)
    arguments = ["grade", str(folder / "submitted"), "--out", str(folder / "out"), "--seed", "3", "--jobs", "1"]
    assert cli.main(["--root", str(course), *arguments]) == 0
    return folder


def failed(course):
    known = {one.name: one for one in mistakes(assignments.checks_folder(course, SLUG))}["square_subtracted"]
    return known.first_fails


def numbers(line):
    return [float(one) for one in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", line)]


def test_the_call_is_printed_whole_and_made_again(results, course, capsys):
    capsys.readouterr()
    mine = str(results / "submitted" / "ada" / SLUG / f"{SLUG}.py")
    assert cli.main(["--root", str(course), "replay", str(results / "out"), "ada", failed(course), mine]) == 0
    said = capsys.readouterr().out
    expected, actual, now = (numbers(re.search(rf"^{what}: +(.+)$", said, re.MULTILINE)[1]) for what in WHAT)
    assert now == actual != expected
    assert "(np.array([" in said, "what was an array is one where the call is pasted"


def test_what_is_right_gives_what_is_expected(results, course, capsys):
    capsys.readouterr()
    right = str(results / "reference.py")
    assert cli.main(["--root", str(course), "replay", str(results / "out"), "ada", failed(course), right]) == 0
    said = capsys.readouterr().out
    expected, _, now = (numbers(re.search(rf"^{what}: +(.+)$", said, re.MULTILINE)[1]) for what in WHAT)
    assert now == pytest.approx(expected, abs=1e-12)


WHAT = ("expected", "actual", "now")


FAILURES = {  # what is appended to the solution, and what `now` says
    "raises": (SLUG, "def skew(v):\n    raise KeyError(v)", "skew raised KeyError"),
    "hangs": (SLUG, "def skew(v):\n    while True: pass", "skew did not return"),
    "none": (SLUG, "def skew(v):\n    return None", "skew returned None, not real numbers"),
    "short": (SLUG, "def skew(v):\n    return v", "not an array of shape (3, 3)"),
    "nan": (SLUG, "def skew(v):\n    return np.full((3, 3), np.nan)", "skew returned NaN"),
    "accepts": (SLUG, "def rotation_matrix(axis, angle):\n    return np.eye(3)", "np.array([[1.0, 0.0, 0.0]"),
    "formula": ("hw12_bead_on_wire", "def lagrange_equation():\n    return sympy.Symbol('x')", "np.array(["),
    "symbol": ("hw12_bead_on_wire", "def lagrange_equation():\n    return sympy.Symbol('q')", "SymPy expression"),
    "drawing": (
        "hw04_hanging_spring",
        "def plot_projection(ax, *args, **kwargs):\n    ax.plot(range(20), range(20))",
        "[19.0, 19.0]",
    ),
    "undrawn": (
        "hw04_hanging_spring",
        "def plot_projection(ax, *args, **kwargs):\n    ax.no()",
        "raised AttributeError",
    ),
}


@pytest.fixture(scope="module")
def failures(tmp_path_factory, course):
    """A class with a failure of each form; every second one is a notebook."""
    folder = tmp_path_factory.mktemp("failures")
    for place, (name, (slug, slip, _)) in enumerate(FAILURES.items()):
        (work := folder / "submitted" / name / slug).mkdir(parents=True)
        text = f"{(course / 'solutions' / f'{slug}.py').read_text()}\nimport sympy\n\n{slip}\n"
        cell = {"cell_type": "code", "source": text, "metadata": {}, "outputs": [], "execution_count": None}
        book = {"cells": [cell], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}
        (work / (f"{slug}.ipynb" if place % 2 else f"{slug}.py")).write_text(json.dumps(book) if place % 2 else text)
    arguments = ["grade", str(folder / "submitted"), "--out", str(folder / "out"), "--seed", "3", "--call", "1"]
    assert cli.main(["--root", str(course), *arguments]) == 0
    return folder


@pytest.mark.parametrize("name", FAILURES)
def test_every_form_of_failure_is_made_again(failures, course, capsys, name):
    slug, slip, says = FAILURES[name]
    lines = map(json.loads, (failures / "out" / "results.jsonl").read_text().splitlines())
    marks = next(line["checks"] for line in lines if line["student"] == name)
    function = re.match(r"def (\w+)", slip)[1]
    check = [mark["name"] for mark in marks if mark.get("failure", {}).get("function") == function][-1]
    work = next((failures / "submitted" / name / slug).iterdir())
    capsys.readouterr()
    assert cli.main(["--root", str(course), "replay", str(failures / "out"), name, check, str(work)]) == 0
    said = capsys.readouterr().out
    assert f"\n{function}(" in said
    assert says in said.rpartition("now:")[2]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("def rotation_matrix(axis, angle:", "was never closed"),
        ("def rotation_matrix(axis, angle):\n    raise NotImplementedError", "rotation_matrix is not written yet."),
        ("x = 1", "Your file has no function rotation_matrix."),
        ("1 / 0", "ZeroDivisionError"),
    ],
)
def test_what_cannot_be_run_says_why(results, course, capsys, tmp_path, text, says):
    (tmp_path / "new.py").write_text(text)
    capsys.readouterr()
    new = str(tmp_path / "new.py")
    assert cli.main(["--root", str(course), "replay", str(results / "out"), "ada", failed(course), new]) == 0
    assert says in capsys.readouterr().out.rpartition("now:")[2]


def test_a_file_that_is_not_there_is_bad_usage(results, course, capsys):
    new = str(results / "none.py")
    assert cli.main(["--root", str(course), "replay", str(results / "out"), "ada", failed(course), new]) == 2
    assert "none.py cannot be read: No such file" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("student", "check", "says"),
    [
        ("bob", "no_check", "no result of bob"),
        ("ada", "no_check", "ada did not fail no_check; failed checks: "),
        ("ada", "skew_is_the_cross_product", "ada did not fail skew_is_the_cross_product (passed: "),
    ],
)
def test_what_is_not_there_is_named(results, course, capsys, student, check, says):
    assert cli.main(["--root", str(course), "replay", str(results / "out"), student, check]) == 2
    assert says in capsys.readouterr().err


@pytest.fixture(scope="module")
def twice(results, tmp_path_factory):
    """The same failures in two assignments."""
    folder = tmp_path_factory.mktemp("twice")
    line = json.loads((results / "out" / "results.jsonl").read_text())
    both = [line, {**line, "assignment": "hw13_rolling_cylinder"}]
    (folder / "results.jsonl").write_text("".join(json.dumps(one) + "\n" for one in both))
    return str(folder)


def test_a_check_that_two_assignments_have_is_asked_for(twice, course, capsys):
    assert cli.main(["--root", str(course), "replay", twice, "ada", failed(course)]) == 2
    said = capsys.readouterr().err
    assert f"hw08: {failed(course)}, hw13: {failed(course)}; choose one with --assignment" in said
    for slug in (SLUG, "hw13_rolling_cylinder"):
        assert cli.main(["--root", str(course), "replay", twice, "ada", failed(course), "--assignment", slug[:4]]) == 0
        assert f"ada, {slug}, " in capsys.readouterr().out


def test_failed_checks_are_listed_with_their_assignments(twice, course, capsys):
    assert cli.main(["--root", str(course), "replay", twice, "ada", "no_check"]) == 2
    said = capsys.readouterr().err
    assert f"hw08: {failed(course)}" in said and f"hw13: {failed(course)}" in said
    assert cli.main(["--root", str(course), "replay", twice, "ada", "no_check", "--assignment", "hw08"]) == 2
    assert "hw13" not in capsys.readouterr().err
    assert cli.main(["--root", str(course), "replay", twice, "ada", "no_check", "--assignment", "hw01"]) == 2
    assert "there is no assignment 'hw01'" in capsys.readouterr().err
