"""Notebooks as students write them: `check`, `show` and the grader read them alike."""

import json
from concurrent.futures import ThreadPoolExecutor

import pytest
from classes import HW08 as SLUG
from classes import notebook

from tam570.loading import loaded
from tam570.notebooks import LARGEST, code_cells
from tam570.show import show
from tam570_grader.grading.submissions import CannotRead, Submission, read

CELLS = {
    "awaits": "import asyncio\nasync def seven():\n    await asyncio.sleep(0)\n    return 7\nx = await seven()",
    "is indented": "\n    x = 3\n    if x:\n        x = 7",
    "has prompts": ">>> x = 3\n>>> if x:\n...     x = 7\n...\n",
    "has numbered prompts": "In [12]: x = 3\n    ...: if x:\n    ...:     x = 7",
    "has a part for when it is run by itself": "x = 7\nif __name__ == '__main__':\n    x = 0",
    "is timed": "%%time\n%time x = 7",
    "takes what is timed": "x = %time 3 + 4",
    "writes the module": "%%writefile hw08_axis_angle.py\nx = 7",
    "takes a time": "import sys\ntimes = %timeit -o sum([1])\nprint(times.average)\nx = 7\nsys.stdout.flush()",
    "asks the shell": "!ls | grep 'x\nfiles = !ls\nif files:\n    !ls \\\n   -l\nx = 7",
    "asks for help": "import numpy as np\nx = 7\nx?\n?x\nnp.array??\nnp.*load*?",
    "has magics": "%matplotlib inline\n%load_ext autoreload\nx = 17 \\\n  % 10",
    "is captured": "\n%%capture out --no-stderr\nx = 7",
    "has a percent sign in a text": "text = '''\n%kept\n'''\nx = 7 * (text == '\\n%kept\\n')",
    "asks for Colab": "if 'google.colab' in str(get_ipython()):\n    !pip install tam570 \\\n        numpy\nx = 7",
    "has lines that begin with an operator": "%precision 3\nx = (19\n    % 12\n    != 2) * 7",
    "calls a magic": "display(3, metadata={})\nget_ipython().run_line_magic('matplotlib', 'inline')\nx = 7",
    "takes all of pylab": "%pylab inline\nplt.plot([1])\nx = round(7 * cos(0.0))",
}
# cells of other languages, and cells without a source
OTHERS = ("%%writefile a.py\nx = 0", " %%bash\nexit 1", "%%html\n<b>", "%%timeit\nx = 0", "no source", "", "!ls")
pytestmark = pytest.mark.usefixtures("in_process")


@pytest.fixture
def book(desk, solution_text):
    """`book(*cells)` -> the file of a notebook with magics, the solution of hw08, and these cells."""

    def book(*cells):
        imports, body = solution_text(SLUG).split("\ndef ", 1)
        file = desk / f"{SLUG}.ipynb"
        file.write_text(notebook(f"%matplotlib inline\n!ls\nprint('x')\n{imports}", f"\ndef {body}", *cells))
        return file

    return book


def test_a_notebook_of_colab_and_a_module_that_jupyter_exported_lose_nothing(book, desk, tam570, grade, solution_text):
    file = book("from google.colab import drive\ndrive.mount('/content')\nkept = rotate", "rotate = kept")
    assert tam570("check", file)[0] == 0 and grade(SLUG, file.read_text(), notebook=True).score == 10
    exported = "get_ipython().run_line_magic('matplotlib', 'inline')\nfrom IPython.display import HTML\n"
    (desk / "hw08.py").write_text(exported + solution_text(SLUG))
    assert tam570("check", "hw08.py")[0] == 0 and grade(SLUG, (desk / "hw08.py").read_text()).score == 10


def test_what_a_notebook_has_shown_is_not_counted(book, tam570, tmp_path):
    """`check` and the grader limit the size of a notebook's code, not of its outputs."""
    file = book()
    cells = json.loads(file.read_text())
    picture = {"output_type": "display_data", "data": {"image/png": "A" * LARGEST, "text/plain": '"]}\\'}}
    cells["cells"][1]["outputs"] = [picture, picture]
    file.write_text(json.dumps(cells))
    assert tam570("check", file)[0] == 0
    source = read(Submission("ada", SLUG, file, file.parent))
    assert len(source.text) < LARGEST and code_cells(source.text) == code_cells(file.read_bytes())
    cells["cells"][1]["source"] += "#" * LARGEST
    file.write_text(json.dumps(cells))
    assert "larger than 10 MiB" in tam570("check", file)[1]
    with pytest.raises(CannotRead, match="larger than 10 MiB"):
        read(Submission("ada", SLUG, file, file.parent))


def test_a_cell_that_raises_is_left_out_and_named(book, tam570):
    code, said = tam570("check", book("def skew(v):\n    return 1 +", "rotate(nothing)", "display(1)"))
    assert code == 0 and "left out" in said and "cell 4: SyntaxError" in said and "cell 5: NameError" in said
    assert "cell 6" not in said


def test_what_is_wrong_in_a_cell_is_named_by_its_line(book, tam570):
    code, said = tam570("check", book("def rotate(r, axis, angle):\n    x = 1\n    return r + nothing"))
    assert code == 1 and "Line 3, in rotate: return r + nothing" in said


@pytest.mark.parametrize("text", ["", "{}", "[]", "not json", *map(notebook, ("x = 1", "(" * 10_000, "'\ud800'"))])
def test_a_notebook_without_functions_is_said_so(desk, tam570, text):
    (desk / f"{SLUG}.ipynb").write_text(text)
    code, said = tam570("check", f"{SLUG}.ipynb")
    assert code == 1 and "Traceback" not in said and "The grader would give this file 0 points." in said


def test_the_notebook_counts_where_the_module_is_still_empty(book, hw08, desk, tam570):
    book().rename(hw08(None).with_suffix(".ipynb"))
    assert tam570("check", "hw08")[0] == 0
    hw08("def skew(v):\n    return None")
    assert tam570("check", "hw08")[0] == 1


def test_a_notebook_is_shown(book, tam570, desk):
    code, said = tam570("show", book(), "--save", "scene.html")
    assert code == 0 and (desk / "scene.html").stat().st_size > 10_000, said
    assert show(book()).scene is not None


@pytest.mark.parametrize("cell", CELLS.values(), ids=CELLS)
def test_a_cell_means_what_it_means_in_jupyter_here_and_where_it_is_graded(desk, grade, solution_text, cell):
    ends = "def skew(v, _skew=skew): return _skew(v) if x == 7 else None"
    book = notebook(*OTHERS, cell, solution_text(SLUG), ends).replace(', "source": "no source"', "")
    (desk / "hw08.ipynb").write_text(book)
    with ThreadPoolExecutor() as fresh:  # another test's browser may have an event loop in this thread
        module, skipped = fresh.submit(loaded, desk / "hw08.ipynb", SLUG).result()
    assert (module.x, skipped) == (7, [])
    result = grade(SLUG, book, notebook=True)
    assert (result.score, result.message) == (10, "")


def test_a_notebook_that_shows_itself_is_read_once(book):
    loads = f"from pathlib import Path\nfrom tam570.loading import loaded\nx = 1\nloaded(Path('{SLUG}.ipynb'), 'x')"
    module, skipped = loaded(book(loads), SLUG)
    assert module.x == 1 and len(skipped) == 1 and "loads itself" in skipped[0]
