"""What is graded: trees, files and notebooks, by their names and by what they hold."""

import json
import shutil

import pytest
from classes import HW08, notebook

from tam570_grader.sandbox.launch import isolation


def test_a_tree_is_graded(run, tree, scores):
    (tree / "ada" / "hw02_ballistics").mkdir()
    code, lines, _ = run(tree, "--seed", 570, "--only", "hw08")
    assert (code, scores(lines)) == (0, {"ada": 10.0, "ben": 0.0, "cora": 0.0})
    assert [line["status"] for line in lines if line["student"] == "cora"] == ["missing"]
    line = next(line for line in lines if line["student"] == "ada")
    assert line["seed"] == 570 and line["isolation"] == isolation() and line["max_score"] == 10.0
    assert set(line["checks"][0]) >= {"name", "part", "points", "max_points", "outcome", "message", "suspect"}


# Notebooks


@pytest.mark.parametrize(
    "cell",
    [
        "text = '''\n%kept\n'''",
        "if 'google.colab' in str(get_ipython()):\n    !pip install tam570 \\\n        numpy\nassert True",
        "%precision 3\nassert (4\n    % 3\n    != 2)",
        "display(3, metadata={})\nget_ipython().run_line_magic('matplotlib', 'inline')",
        "from IPython import get_ipython\nif 'IPKernelApp' in get_ipython().config:\n    1 / 0",
        pytest.param("import matplotlib\nmatplotlib.use('TkAgg')\nmatplotlib.pyplot.figure()", marks=pytest.mark.slow),
        pytest.param("%pylab inline\nassert allclose(sin(pi), 0)\nplt.plot([1])", marks=pytest.mark.slow),
    ],
)
def test_what_runs_in_a_kernel_runs_in_the_grader(grade, solution_text, cell):
    result = grade(HW08, notebook(cell, solution_text(HW08)), notebook=True)
    assert result.score == 10.0 and not result.message


@pytest.mark.parametrize("form", [3, 4])
def test_the_error_of_a_cell_is_told(grade, solution_text, form):
    text = notebook(solution_text(HW08), "whatever")
    if form == 3:
        cells = [{"cell_type": "code", "input": cell} for cell in ("", solution_text(HW08), "whatever")]
        text = json.dumps({"worksheets": [{"cells": cells}], "nbformat": 3})
    result = grade(HW08, text, notebook=True)
    assert result.score == 10.0 and "cell 3: NameError: name 'whatever' is not defined" in result.message


AT_IMPORT = """
t = np.linspace(0, 3, 50)
states = simulate(t, 20.0, 0.8, mass=1.0, drag=0.3, gravity=9.81)
assert np.allclose(states, trajectory(t, 20.0, 0.8, mass=1.0, drag=0.3, gravity=9.81))
plot_comparison(__import__("matplotlib.pyplot").pyplot.gca(), t, 20.0, 0.8, mass=1.0, drag=0.3, gravity=9.81)
"""


@pytest.mark.parametrize("form", ["module", "notebook", "notebook of one cell"])
def test_what_a_file_tries_out_at_import_may_use_what_one_function_may_not(grade, solution_text, form):
    slug, correct = "hw02_ballistics", solution_text("hw02_ballistics")
    if form == "module":
        result = grade(slug, f"from __future__ import annotations\n{correct}{AT_IMPORT}")
    else:
        cells = [correct + AT_IMPORT] if form.endswith("cell") else [correct, *AT_IMPORT.splitlines()]
        result = grade(slug, notebook(*cells), notebook=True)
    assert result.score == 10.0 and not result.message


def test_a_cell_that_tries_what_is_off_limits_costs_only_what_needs_it(grade, solution_text):
    tries = "from scipy.spatial.transform import Rotation\nprint(Rotation.identity())"
    result = grade(HW08, notebook(solution_text(HW08), tries), notebook=True)
    assert result.score == 10.0 and "scipy.spatial.transform is off limits" in result.message
    used = "def skew(v): return Rotation.from_rotvec(v).as_matrix()"
    assert grade(HW08, notebook(tries, solution_text(HW08), used), notebook=True).score < 10.0


def test_what_a_later_import_says_reaches_no_page(grade, solution_text):
    """A file is imported again where a function has bans of its own, and may know hidden inputs by then."""
    second = "import scipy.integrate\nif type(scipy.integrate).__name__ != 'module': raise ValueError('8.41470984')"
    result = grade("hw02_ballistics", notebook(solution_text("hw02_ballistics"), second, "1 / 0"), notebook=True)
    assert result.score == 10.0 and result.message.endswith("cell 4: ZeroDivisionError: division by zero")
    assert "8.41470984" not in json.dumps(result.record())


def test_of_a_module_and_a_notebook_the_one_that_is_written_wins(run, tree, course, solution_text):
    mine = tree / "ada" / HW08
    (mine / f"{HW08}.ipynb").write_text("no notebook at all")
    assert run(tree / "ada")[1][0]["score"] == 10.0
    shutil.copy(course / "assignments" / HW08 / f"{HW08}.py", mine)
    for cell, score in (("import hw08_axis_angle as hw", 0.0), (solution_text(HW08), 10.0)):
        (mine / f"{HW08}.ipynb").write_text(notebook(cell))
        assert run(tree / "ada")[1][0]["score"] == score
