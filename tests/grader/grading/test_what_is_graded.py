"""What is graded: trees, files and notebooks, by their names and by what they hold."""

import json
import shutil
from pathlib import Path

import pytest
from parameters import first

from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import slug_of
from tam570_grader.grading import command
from tam570_grader.sandbox.launch import isolation

SLUG = "hw08_axis_angle"
NOTHING = "def skew(v): return None\n"


def test_a_tree_is_graded(run, tree, scores):
    code, lines, _ = run(tree, "--seed", 1)
    assert (code, scores(lines)) == (0, {"ada": 10.0, "ben": 0.0, "cora": 0.0})
    assert {line["student"]: line["status"] for line in lines}["cora"] == "missing"


@pytest.mark.parametrize("name", ["hw08.py", "HW08_final.py", f"{SLUG}.py"])
def test_a_file_is_known_by_its_name(run, tmp_path, solution_text, name):
    path = tmp_path / name
    path.write_text(solution_text(SLUG))
    code, (line,), _ = run(path)
    assert (code, line["assignment"], line["student"], line["score"]) == (0, SLUG, path.stem, 10.0)


def test_a_file_of_any_name_is_graded_as_the_assignment_that_is_named(run, tmp_path, solution_text):
    path = tmp_path / "ada.py"
    path.write_text(solution_text(SLUG))
    _, (line,), _ = run(path, "--assignment", "hw08")
    assert (line["student"], line["score"]) == ("ada", 10.0)


def test_a_line_has_what_it_promises(run, tree):
    _, lines, _ = run(tree / "ada" / SLUG, "--seed", 570)
    (line,) = lines
    assert line["seed"] == 570 and line["isolation"] == isolation() and line["max_score"] == 10.0
    assert set(line["checks"][0]) >= {"name", "part", "points", "max_points", "outcome", "message", "suspect"}


def test_only_takes_assignments(run, tree):
    (tree / "ada" / "hw02_ballistics").mkdir()
    _, lines, _ = run(tree, "--only", "hw08")
    assert {line["assignment"] for line in lines} == {SLUG}


def test_a_notebook_is_graded_by_its_code_cells(run, tmp_path, solution_text, notebook):
    folder = tmp_path / "ada" / SLUG
    folder.mkdir(parents=True)
    text = notebook(
        "%matplotlib inline\n!pip list\n", "%%bash\nrm -rf /", solution_text(SLUG), "1 / 0", "text = '''\n%kept\n'''"
    )
    (folder / f"{SLUG}.ipynb").write_text(text)
    _, (line,), _ = run(folder)
    assert (line["student"], line["score"]) == ("ada", 10.0)
    assert "cell 5: ZeroDivisionError" in line["message"]


@pytest.mark.parametrize(
    "cell",
    first(
        6,
        [
            "if 'google.colab' in str(get_ipython()):\n    !pip install tam570 \\\n        numpy\nassert True",
            "%precision 3\nassert (4\n    % 3\n    != 2)",
            "%time two = 2\nabs?\nassert two == 2",
            "display(3, metadata={})\nget_ipython().run_line_magic('matplotlib', 'inline')",
            "from IPython import get_ipython\nif 'IPKernelApp' in get_ipython().config:\n    1 / 0",
            "import matplotlib.pyplot as plt\nimport matplotlib\nmatplotlib.use('TkAgg')\nplt.figure()",
            "from matplotlib import pyplot\npyplot.switch_backend('QtAgg')\npyplot.plot([1])",
            "%pylab inline\nassert allclose(sin(pi), 0) and np.eye(2).any()\nplt.plot([1])",
        ],
    ),
)
def test_what_runs_in_a_kernel_runs_in_the_grader(run, tmp_path, solution_text, cell, notebook):
    (tmp_path / "hw08.ipynb").write_text(notebook(cell, solution_text(SLUG)))
    _, (line,), _ = run(tmp_path / "hw08.ipynb")
    assert line["score"] == 10.0 and "message" not in line


def test_an_old_notebook_is_read_and_the_error_of_a_cell_is_told(run, tmp_path, solution_text):
    cells = [{"cell_type": "code", "language": "python", "input": text} for text in (solution_text(SLUG), "whatever")]
    text = json.dumps({"worksheets": [{"cells": cells}], "nbformat": 3})
    (tmp_path / "hw08.ipynb").write_text(text)
    _, (line,), _ = run(tmp_path / "hw08.ipynb")
    assert line["score"] == 10.0 and "cell 2: NameError: name 'whatever' is not defined" in line["message"]


AT_IMPORT = """
from __future__ import annotations
t = np.linspace(0, 3, 50)
states = simulate(t, 20.0, 0.8, mass=1.0, drag=0.3, gravity=9.81)
assert np.allclose(states, trajectory(t, 20.0, 0.8, mass=1.0, drag=0.3, gravity=9.81))
plot_comparison(__import__("matplotlib.pyplot").pyplot.gca(), t, 20.0, 0.8, mass=1.0, drag=0.3, gravity=9.81)
"""


@pytest.mark.parametrize("form", ["module", "notebook", "notebook of one cell"])
def test_what_a_file_tries_out_at_import_may_use_what_one_function_may_not(
    run, tmp_path, solution_text, form, notebook
):
    slug = "hw02_ballistics"
    right, tries = solution_text(slug), AT_IMPORT.replace("from __future__ import annotations\n", "")
    if form == "module":
        (tmp_path / "hw02.py").write_text(f"from __future__ import annotations\n{right}{tries}")
    else:
        cells = [right + tries] if form.endswith("cell") else [right, *tries.splitlines()]
        (tmp_path / "hw02.ipynb").write_text(notebook(*cells))
    _, (line,), _ = run(next(tmp_path.iterdir()))
    assert line["score"] == 10.0 and "message" not in line


def test_a_cell_that_tries_what_is_off_limits_costs_only_what_needs_it(run, tmp_path, solution_text, notebook):
    tries = "from scipy.spatial.transform import Rotation\nprint(Rotation.identity())"
    (tmp_path / "hw08.ipynb").write_text(notebook(solution_text(SLUG), tries))
    _, (line,), _ = run(tmp_path / "hw08.ipynb")
    assert line["score"] == 10.0 and "scipy.spatial.transform is off limits" in line["message"]
    used = "def skew(v): return Rotation.from_rotvec(v).as_matrix()"
    (tmp_path / "hw08.ipynb").write_text(notebook(tries, solution_text(SLUG), used))
    _, (line,), _ = run(tmp_path / "hw08.ipynb")
    assert line["score"] < 10.0


def test_a_module_wins_over_a_notebook(run, tree):
    (tree / "ada" / SLUG / f"{SLUG}.ipynb").write_text("no notebook at all")
    _, (line,), _ = run(tree / "ada")
    assert line["score"] == 10.0


def test_a_notebook_wins_over_a_module_that_nobody_has_written(run, tree, course, solution_text, notebook):
    own = tree / "ada" / SLUG
    shutil.copy(course / "assignments" / SLUG / f"{SLUG}.py", own)
    (own / f"{SLUG}.ipynb").write_text(notebook("import hw08_axis_angle as hw"))
    _, (line,), _ = run(tree / "ada")
    assert line["score"] == 0.0 and "not written yet" in line["checks"][0]["message"]
    (own / f"{SLUG}.ipynb").write_text(notebook(solution_text(SLUG)))
    _, (line,), _ = run(tree / "ada")
    assert line["score"] == 10.0


def test_what_a_later_import_says_reaches_no_page(run, tmp_path, solution_text, notebook):
    """A file is imported again where a function has bans of its own, and may know hidden inputs by then."""
    again = "import scipy.integrate\nif type(scipy.integrate).__name__ != 'module': raise ValueError('8.41470984')"
    (tmp_path / "hw02.ipynb").write_text(notebook(solution_text("hw02_ballistics"), again, "1 / 0"))
    _, (line,), _ = run(tmp_path / "hw02.ipynb")
    assert line["score"] == 10.0 and line["message"].endswith("cell 4: ZeroDivisionError: division by zero")
    assert "8.41470984" not in json.dumps(line)


@pytest.mark.parametrize(
    ("name", "slug"),
    [
        ("hw08", SLUG),
        (SLUG, SLUG),
        ("Hw08-ada", SLUG),
        ("hw08_other", SLUG),
        ("hw080", None),
        ("ada", None),
        ("hw99", None),
    ],
)
def test_names_tell_assignments(name, slug):
    assert slug_of(name, [SLUG]) == slug


def test_an_assignment_is_found_by_its_short_name(course):
    assert assignments.assignment(course, "hw08").slug == SLUG


def test_a_course_may_lie_at_the_top_of_a_disk():
    assert command._folders(Path("/course")) == [Path("/course")]
