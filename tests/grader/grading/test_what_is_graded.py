"""Which files are graded, by name and content; a file that cannot be read or loaded costs only its student points."""

import json
import os
import shutil

import pytest
from classes import HW08, hand_in, notebook, packed, rows

from tam570.notebooks import without_outputs
from tam570_grader import cli
from tam570_grader.grading.submissions import is_begun

NOTHING = "def skew(v): return None\n"
CELLS = [3], ["x"], [{}], [{"cell_type": "code"}], [{"cell_type": "code", "source": [1]}], {"a": 1}, None, "code", []
NAMES = ("=cmd|'calc'!A0", "@sum", "+1", "<img src=x onerror=alert(1)>", "%2e%2e%2fada", "a'b\"c", "l" * 255)
UNPARSED = [b"# -*- coding: rot13 -*-\nqrs f(): cnff", b"# coding: no-such-codec\n", b"# coding: utf-7\n+AGEAYgBj-\n"]
UNPARSED += [b"x = 1\0\n", b"\xff\xfea\0", b"-" * 100_000 + b"1", b"(" * 100_000, b"x = " + b"9" * 100_000]
UNPARSED += [b"a = b" + b".c" * 100_000]
ALIKE = ("x\ny", r"x\ny", "\u200b" * 80, "\u200b" * 81)
AT_IMPORT = """
t = np.linspace(0, 3, 50)
states = simulate(t, 20.0, 0.8, mass=1.0, drag=0.3, gravity=9.81)
assert np.allclose(states, trajectory(t, 20.0, 0.8, mass=1.0, drag=0.3, gravity=9.81))
plot_comparison(__import__("matplotlib.pyplot").pyplot.gca(), t, 20.0, 0.8, mass=1.0, drag=0.3, gravity=9.81)
"""


def test_zip_files_are_graded_and_broken_or_huge_files_are_notes(run, tree, scores, solution_text):
    work = packed({f"{HW08}.py": solution_text(HW08), "plot.png": "x"})
    bomb = packed({f"hw08{n}.py": bytes(2**23) for n in "abc"})
    zips = {
        "ben": packed({"a/hw08.zip": work, f"a/.b/{HW08}.py": "x"}),
        "dan": packed({"a.pdf": "x"}),
        "eve": b"no zip",
    }
    hand_in(tree, {**zips, "ada": b"no zip", "fay": bomb, "gus": b""}, file="{0}_handin.zip")
    os.truncate(tree / "gus" / f"{HW08}_handin.zip", 2**30)
    hand_in(tree, {"cora": work}, file="{0}/handin.zip")
    (tree / "ben" / HW08 / f"{HW08}.py").unlink()
    assert scores(run(tree / "ben" / f"{HW08}_handin.zip")[1]) == {HW08: 10.0}
    _, lines, _ = run(tree, "--seed", 1)
    notes = dict.fromkeys(("dan", "eve", "fay", "gus"), 0.0)
    assert scores(lines) == notes | dict.fromkeys(("ada", "ben", "cora"), 10.0)
    said = [line["message"] for line in lines if line["status"] == "unreadable"]
    words = ("holds a.pdf", "cannot be unpacked", "more than 20 MiB", "larger than 10 MiB")
    assert all(text in message for text, message in zip(words, said, strict=True))


def test_a_link_to_a_neighbours_work_or_out_of_the_folder_is_not_followed(run, tree, course, scores):
    """Links in place of files or folders score nothing: to others' work, to places outside, to themselves."""
    (tree / "ben" / HW08 / f"{HW08}.py").unlink()
    (tree / "cora" / HW08).rmdir()
    links = {
        f"ben/{HW08}/{HW08}.py": f"../../ada/{HW08}/{HW08}.py",
        f"cora/{HW08}": f"../ada/{HW08}",
        "dan": "ada",
        "hw08_eve.py": f"ada/{HW08}/{HW08}.py",
        f"fay/{HW08}/{HW08}.py": course / "solutions" / f"{HW08}.py",
        f"dev/{HW08}": "/etc",
        f"eli/{HW08}": HW08,
        f"flo/{HW08}": "..",
        f"gus/{HW08}/{HW08}.py": f"{HW08}.py",
    }
    for name, target in links.items():
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        (tree / name).symlink_to(target)
    code, lines, err = run(tree, "--seed", 1)
    said = {line["student"]: line.get("message", "") for line in lines}
    others = ("ben", "cora", "dan", "hw08_eve", "fay", "dev", "eli", "flo", "gus")
    assert code == 0 and scores(lines) == {"ada": 10.0, **dict.fromkeys(others, 0.0)} and "Traceback" not in err
    assert all("link to a place outside" in said[student] for student in ("dev", "flo", "gus")), said
    assert not any("holds" in said[student] for student in ("dev", "flo", "gus")), said


def test_a_link_with_too_long_a_target_is_no_folder(run, tree, scores):
    for folder in (tree, tree / "ada", tree / "ben" / HW08):
        (folder / "notes").symlink_to("a" * 300)
    os.mkfifo(tree / "cora" / HW08 / f"{HW08}.py")  # no process writes to it: reading would block
    code, lines, _ = run(tree)
    assert (code, scores(lines)) == (0, {"ada": 10.0, "ben": 0.0, "cora": 0.0})


def test_names_and_messages_that_are_no_text_are_escaped(tree, tmp_path, capsys):
    for name in (b"\xffeve", b"x\nada  hw08_axis_angle  10", b"x\x1b[31m", "\u202emaet".encode()):
        os.makedirs(os.path.join(os.fsencode(tree), name, HW08.encode()))
    hand_in(tree, {"ben": "raise ValueError('\\x1b[1A\\x1b[2Kben  10 / 10\\n')"})
    assert cli.main(["grade", str(tree), "--out", str(tmp_path / "out"), "--seed", "1"]) == 0
    said = capsys.readouterr().out
    assert all(line.isprintable() for line in said.splitlines()) and "2Kben" not in said
    table = rows(tmp_path / "out" / "grades.csv")
    assert {row["student"]: row["score"] for row in table if row["score"] != "0.0"} == {"ada": "10.0"}
    assert len(table) == 7 and r"\udcffeve" in {row["student"] for row in table}


def test_files_beside_a_module_are_not_run(run, tree, monkeypatch, scores, cold):
    """Files that shadow modules, start files, options of tools: published against nbgrader, issues 170 and 1842."""
    folder = tree / "ada" / HW08
    (folder / "numpy").mkdir()
    beside = ("numpy/__init__.py", "inside.py", "msgpack.py", "sitecustomize.py", "conftest.py", "checks.py", "0.pth")
    for name in beside:
        (folder / name).write_text("raise SystemExit('shadowed')\n")
    monkeypatch.chdir(folder)
    assert scores(run(tree)[1])["ada"] == 10.0


@pytest.mark.parametrize("text", [*UNPARSED, *(json.dumps({"cells": cells, "nbformat": 4}) for cells in CELLS)])
def test_a_text_that_breaks_parsers_harms_nobody_else(grade, solution_text, text):
    assert grade(HW08, text, notebook=isinstance(text, str)).score == 0.0
    assert grade(HW08, solution_text(HW08)).score == 10.0


def test_millions_of_quotation_marks_are_read_in_one_pass():
    """A search that starts again at each of them would take hours."""
    marks = b'"' * 4_000_000
    assert not is_begun(b"#" + marks) and not is_begun(b"def f():" + marks + b" raise NotImplementedError")
    endless = b'{"outputs": [1], "x": "' + marks.replace(b'"', b'\\"')
    assert without_outputs(endless) == endless.replace(b"[1]", b"[]")


def test_a_name_is_a_name_and_nothing_else(run, tmp_path, solution_text, scores):
    """Names of folders with formulas, markup or paths, or of great length, do no harm in tables and pages."""
    out = tmp_path / "out"
    tree = hand_in(tmp_path / "submitted", dict.fromkeys((*NAMES, *ALIKE), solution_text(HW08)))
    _, lines, _ = run(tree, "--out", out)
    assert set(scores(lines).values()) == {10.0} and len(lines) == len(scores(lines)) == len(NAMES + ALIKE)
    assert set(NAMES) <= set(scores(lines))
    assert not any(row["student"].startswith(("=", "+", "-", "@", "\t")) for row in rows(out / "grades.csv"))
    pages = list((out / "feedback").glob("*/*.html"))
    assert len(pages) == len(lines) and {page.parent.name for page in pages} >= set(NAMES)
    assert not any("<img" in page.read_text() for page in pages)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nowhere"], "nowhere does not exist"),
        (["x.py"], "cannot tell which assignment"),
        (["hw08.py", "--only", "hw99"], "no assignment 'hw99'"),
        (["hw08.txt"], "neither a Python module"),
        (["hw08.py", "--out", "hw08.txt"], "cannot write results"),
        (["hw08.py", "--root", "."], "does not hold a course"),
    ],
)
def test_bad_usage_is_said_and_exits_2(here, course, capsys, arguments, words):
    for name in ("x.py", "hw08.py", "hw08.txt"):
        (here / name).write_text(NOTHING)
    assert cli.main(["--root", str(course), "grade", *arguments]) == 2
    assert words in capsys.readouterr().err


def test_what_asks_for_a_kernel_or_a_window_runs_in_the_grader(grade, solution_text):
    kernel = "from IPython import get_ipython\nif 'IPKernelApp' in get_ipython().config:\n    1 / 0"
    window = "import matplotlib.pyplot as plt\nplt.matplotlib.use('TkAgg')\nplt.figure()"
    result = grade(HW08, notebook(kernel, window, solution_text(HW08)), notebook=True)
    assert result.score == 10.0 and not result.message


@pytest.mark.parametrize("form", [3, 4])
def test_the_error_of_a_cell_is_told(grade, solution_text, form):
    text = notebook(solution_text(HW08), "whatever")
    if form == 3:
        cells = [{"cell_type": "code", "input": cell} for cell in ("", solution_text(HW08), "whatever")]
        text = json.dumps({"worksheets": [{"cells": cells}], "nbformat": 3})
    result = grade(HW08, text, notebook=True)
    assert result.score == 10.0 and "cell 3: NameError: name 'whatever' is not defined" in result.message


@pytest.mark.parametrize("form", ["module", "notebook", "notebook of one cell"])
def test_what_a_file_tries_out_at_import_may_use_what_one_function_may_not(grade, solution_text, form):
    slug, correct = "hw02_ballistics", solution_text("hw02_ballistics")
    if form == "module":
        result = grade(slug, f"from __future__ import annotations\n{correct}{AT_IMPORT}")
    else:
        cells = [correct + AT_IMPORT] if form.endswith("cell") else [correct, *AT_IMPORT.splitlines()]
        result = grade(slug, notebook(*cells), notebook=True)
    assert result.score == 10.0 and not result.message


def test_after_a_statement_that_may_not_run_the_rest_does(grade, solution_text):
    """For euler_rates_313, the statement that calls `rotations` is skipped, but not the next one on the same line."""
    calls = "from tam570 import rotations\nturn = rotations.skew([1, 2, 3]); kept = abs\n"
    text = solution_text("hw10_free_rigid_body").replace("import math\n", f"import math\n{calls}", 1)
    result = grade("hw10_free_rigid_body", text.replace("if abs(s) < 1e-12", "if kept(s) < 1e-12"))
    assert result.score == 10.0, result.message


def test_a_cell_that_tries_what_is_off_limits_costs_only_what_needs_it(grade, solution_text):
    tries = "from scipy.spatial.transform import Rotation\nprint(Rotation.identity())"
    result = grade(HW08, notebook(solution_text(HW08), tries), notebook=True)
    assert result.score == 10.0 and "scipy.spatial.transform is off limits" in result.message
    used = "def skew(v): return Rotation.from_rotvec(v).as_matrix()"
    assert grade(HW08, notebook(tries, solution_text(HW08), used), notebook=True).score < 10.0


def test_what_a_later_import_says_reaches_no_page(grade, solution_text):
    """A file is imported again for a function with its own bans; by then it may know hidden inputs."""
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
