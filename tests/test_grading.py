"""`tam570-grader grade` as an instructor runs it: inputs of every kind, exit codes, results that last."""

import contextlib
import csv
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import time
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy

from tam570_grader import cli
from tam570_grader.grading import submissions
from tam570_grader.grading.one import graded
from tam570_grader.pages.sentences import message
from tam570_grader.sandbox.cell import Cell
from tam570_grader.sandbox.inside.answer import MODES
from tam570_grader.sandbox.inside.wire import Foreign, Unreadable, packed, portable, unpacked
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.preload import imported
from tam570_grader.sandbox.student import Source, Student
from tam570_grader.sandbox.worker import Allowance
from tam570_grader.writing import assignments
from tam570_grader.writing.assignments import slug_of
from tam570_grader.writing.check import given
from tam570_grader.writing.curves import readable
from tam570_grader.writing.drawings import distances, judge_axes_of_lengths
from tam570_grader.writing.expect import Failed, expect
from tam570_grader.writing.returns import Drawing, array, group, number, result, rows

SLUG = "hw08_axis_angle"
NOTHING = "def skew(v): return None\n"


@pytest.fixture
def run(capsys):
    """`run(*arguments)` -> (exit code, result lines, what was said on stderr)."""

    def run(*arguments):
        code = cli.main(["grade", *map(str, arguments), "--json"])
        out, err = capsys.readouterr()
        return code, [json.loads(line) for line in out.splitlines()], err

    return run


@pytest.fixture
def tree(tmp_path, solution_text):
    """A class of three: right, half done, and not handed in."""
    texts = {"ada": solution_text(SLUG), "ben": NOTHING, "cora": None}
    for student, text in texts.items():
        folder = tmp_path / "submitted" / student / SLUG
        folder.mkdir(parents=True)
        if text is not None:
            (folder / f"{SLUG}.py").write_text(text)
    return tmp_path / "submitted"


def scores(lines):
    return {line["student"]: line["score"] for line in lines}


# What is graded


def test_a_tree_is_graded(run, tree):
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


def notebook(*cells):
    code = [{"cell_type": "code", "source": text.splitlines(keepends=True)} for text in cells]
    return json.dumps({"cells": [{"cell_type": "markdown", "source": ["# hw08"]}, *code], "nbformat": 4})


def test_a_notebook_is_graded_by_its_code_cells(run, tmp_path, solution_text):
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
)
def test_what_runs_in_a_kernel_runs_in_the_grader(run, tmp_path, solution_text, cell):
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
def test_what_a_file_tries_out_at_import_may_use_what_one_function_may_not(run, tmp_path, solution_text, form):
    slug = "hw02_ballistics"
    right, tries = solution_text(slug), AT_IMPORT.replace("from __future__ import annotations\n", "")
    if form == "module":
        (tmp_path / "hw02.py").write_text(f"from __future__ import annotations\n{right}{tries}")
    else:
        cells = [right + tries] if form.endswith("cell") else [right, *tries.splitlines()]
        (tmp_path / "hw02.ipynb").write_text(notebook(*cells))
    _, (line,), _ = run(next(tmp_path.iterdir()))
    assert line["score"] == 10.0 and "message" not in line


def test_a_cell_that_tries_what_is_off_limits_costs_only_what_needs_it(run, tmp_path, solution_text):
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


def test_a_notebook_wins_over_a_module_that_nobody_has_written(run, tree, course, solution_text):
    own = tree / "ada" / SLUG
    shutil.copy(course / "assignments" / SLUG / f"{SLUG}.py", own)
    (own / f"{SLUG}.ipynb").write_text(notebook("import hw08_axis_angle as hw"))
    _, (line,), _ = run(tree / "ada")
    assert line["score"] == 0.0 and "not written yet" in line["checks"][0]["message"]
    (own / f"{SLUG}.ipynb").write_text(notebook(solution_text(SLUG)))
    _, (line,), _ = run(tree / "ada")
    assert line["score"] == 10.0


# Bad input


@pytest.mark.parametrize(
    ("name", "content", "status"),
    [
        ("syntax.py", b"def skew(v:\n", "unreadable"),
        ("binary.py", bytes(range(256)) * 40, "unreadable"),
        ("forbidden.py", b"from scipy.spatial.transform import Rotation", "unreadable"),
        ("raises.py", b"1 / 0", "unreadable"),
        ("notebook.ipynb", b'{"cells": 3}', "unreadable"),
        ("broken.ipynb", b"{" * 100_000, "unreadable"),
        ("exits.py", b"import os; os._exit(0)", "crashed"),
        ("loops.py", b"while True: pass", "timeout"),
    ],
)
def test_what_cannot_be_loaded_scores_nothing(run, tmp_path, name, content, status):
    (tmp_path / name).write_bytes(content)
    code, (line,), _ = run(tmp_path / name, "--assignment", "hw08", "--call", 1)
    assert (code, line["status"], line["score"]) == (0, status, 0.0)
    assert all(mark["outcome"] == "not_run" for mark in line["checks"]) and line["message"]


def test_a_huge_file_is_not_read(run, tmp_path):
    with open(tmp_path / "hw08.py", "wb") as file:
        file.truncate(2**30)
    _, (line,), _ = run(tmp_path / "hw08.py")
    assert line["status"] == "unreadable" and "larger than 10 MiB" in line["message"]


def test_a_link_out_of_the_tree_is_not_followed(run, tree, course):
    path = tree / "ben" / SLUG / f"{SLUG}.py"
    path.unlink()
    path.symlink_to(course / "solutions" / f"{SLUG}.py")
    _, lines, _ = run(tree)
    assert scores(lines)["ben"] == 0.0


def test_a_link_to_a_neighbours_work_is_not_followed(run, tree):
    (tree / "ben" / SLUG / f"{SLUG}.py").unlink()
    (tree / "ben" / SLUG / f"{SLUG}.py").symlink_to(f"../../ada/{SLUG}/{SLUG}.py")
    (tree / "cora" / SLUG).rmdir()
    (tree / "cora" / SLUG).symlink_to(f"../ada/{SLUG}")
    (tree / "dan").symlink_to("ada")
    (tree / "hw08_eve.py").symlink_to(f"ada/{SLUG}/{SLUG}.py")
    _, lines, _ = run(tree)
    assert scores(lines) == {"ada": 10.0, "ben": 0.0, "cora": 0.0, "dan": 0.0, "hw08_eve": 0.0}


def test_a_link_within_the_own_folder_is_followed(run, tree):
    path = tree / "ada" / SLUG / f"{SLUG}.py"
    path.rename(tree / "ada" / "final.py")
    path.symlink_to("../final.py")
    assert scores(run(tree)[1])["ada"] == 10.0
    (tree.parent / "class").symlink_to(tree)
    assert scores(run(tree.parent / "class")[1])["ada"] == 10.0


def test_a_student_with_two_files_holds_up_nobody(run, tree):
    for name in ("hw08.py", "hw08_old.py"):
        (tree / "dan").mkdir(exist_ok=True)
        (tree / "dan" / name).write_text(NOTHING)
    code, lines, _ = run(tree)
    assert (code, scores(lines)) == (0, {"ada": 10.0, "ben": 0.0, "cora": 0.0, "dan": 0.0})
    assert next(line for line in lines if line["student"] == "dan")["message"].endswith("hw08.py, hw08_old.py")


def test_names_and_messages_that_are_no_text_are_escaped(tree, tmp_path, capsys):
    for name in (b"\xffeve", b"x\nada  hw08_axis_angle  10", b"x\x1b[31m", "\u202emaet".encode()):
        os.makedirs(os.path.join(os.fsencode(tree), name, SLUG.encode()))
    (tree / "ben" / SLUG / f"{SLUG}.py").write_text("raise ValueError('\\x1b[1A\\x1b[2Kben  10 / 10\\n')")
    assert cli.main(["grade", str(tree), "--out", str(tmp_path / "out"), "--seed", "1"]) == 0
    said = capsys.readouterr().out
    assert all(line.isprintable() for line in said.splitlines()) and "2Kben" not in said
    rows = list(csv.DictReader((tmp_path / "out" / "grades.csv").read_text().splitlines()))
    assert {row["student"]: row["score"] for row in rows if row["score"] != "0.0"} == {"ada": "10.0"}
    assert len(rows) == 7 and r"\udcffeve" in {row["student"] for row in rows}


def test_files_beside_a_module_are_not_run(run, tree, monkeypatch):
    """A module shadowed by a file, start files, options of tools: published against nbgrader, issues 170 and 1842."""
    folder = tree / "ada" / SLUG
    (folder / "numpy").mkdir()
    beside = ("numpy/__init__.py", "inside.py", "msgpack.py", "sitecustomize.py", "conftest.py", "checks.py", "0.pth")
    for name in beside:
        (folder / name).write_text("raise SystemExit('shadowed')\n")
    monkeypatch.chdir(folder)
    _, lines, _ = run(tree)
    assert scores(lines)["ada"] == 10.0


@pytest.mark.parametrize(
    "cells",
    [[3], ["x"], [{}], [{"cell_type": "code"}], [{"cell_type": "code", "source": [1]}], {"a": 1}, None, "code", []],
)
def test_a_notebook_with_strange_cells_scores_nothing(run, tmp_path, cells):
    (tmp_path / "hw08.ipynb").write_text(json.dumps({"cells": cells, "nbformat": 4}))
    code, (line,), _ = run(tmp_path / "hw08.ipynb")
    assert (code, line["score"]) == (0, 0.0)


@pytest.mark.parametrize(
    "text",
    [
        b"# -*- coding: rot13 -*-\nqrs f(): cnff",
        b"# coding: no-such-codec\n",
        b"# coding: utf-7\n+AGEAYgBj-\n",
        b"x = 1\0\n",
        b"\xff\xfea\0",
        b"-" * 100_000 + b"1",
        b"(" * 100_000,
        b"x = " + b"9" * 100_000,
        b"a = b" + b".c" * 100_000,
    ],
    ids=["rot13", "no codec", "utf-7", "null", "utf-16", "minus", "brackets", "digits", "dots"],
)
def test_a_text_that_breaks_parsers_harms_nobody_else(run, tmp_path, solution_text, text):
    for name, content in {"ann": text, "ben": solution_text(SLUG).encode()}.items():
        (tmp_path / name / SLUG).mkdir(parents=True)
        (tmp_path / name / SLUG / f"{SLUG}.py").write_bytes(content)
    code, lines, _ = run(tmp_path, "--jobs", 1)
    assert (code, scores(lines)) == (0, {"ann": 0.0, "ben": 10.0})


NAMES = ("=cmd|'calc'!A0", "@sum", "+1", "<img src=x onerror=alert(1)>", "%2e%2e%2fada", "a'b\"c", "l" * 255)


def test_a_name_is_a_name_and_nothing_else(run, tmp_path, solution_text):
    """Formulas, markup, paths and lengths in names of folders, which students or their systems choose."""
    submitted, out = tmp_path / "submitted", tmp_path / "out"
    for name in NAMES:
        (submitted / name / SLUG).mkdir(parents=True)
        (submitted / name / SLUG / f"{SLUG}.py").write_text(solution_text(SLUG))
    _, lines, _ = run(submitted, "--out", out)
    assert scores(lines) == dict.fromkeys(NAMES, 10.0)
    rows = list(csv.reader((out / "grades.csv").read_text().splitlines()))
    assert len(rows) == 1 + len(NAMES) and not any(row[0].startswith(("=", "+", "-", "@", "\t")) for row in rows)
    pages = sorted(page.parent.name for page in (out / "feedback").glob("*/*.html"))
    assert pages == sorted(NAMES) and not any("<img" in page.read_text() for page in out.rglob("*.html"))


def test_names_that_print_alike_or_too_long_are_two_students_with_pages(run, tmp_path, solution_text):
    submitted, out = tmp_path / "submitted", tmp_path / "out"
    for name in ("x\ny", r"x\ny", "\u200b" * 80, "\u200b" * 81):
        (submitted / name / SLUG).mkdir(parents=True)
        (submitted / name / SLUG / f"{SLUG}.py").write_text(solution_text(SLUG))
    _, lines, _ = run(submitted, "--out", out)
    assert [line["score"] for line in lines] == [10.0] * 4 and len(scores(lines)) == 4
    assert len(list((out / "feedback").glob("*/*.html"))) == 4


def test_a_link_that_leads_away_or_nowhere_is_a_note_and_lists_nothing(run, tree):
    for student, target in (("dev", "/etc"), ("eli", SLUG), ("fay", "..")):
        (tree / student).mkdir()
        (tree / student / SLUG).symlink_to(target)
    own = tree / "gus" / SLUG
    own.mkdir(parents=True)
    (own / f"{SLUG}.py").symlink_to(f"{SLUG}.py")
    code, lines, err = run(tree, "--seed", 1)
    said = {line["student"]: f"{line['status']} {line.get('message', '')}" for line in lines}
    assert code == 0 and scores(lines)["ada"] == 10.0 and "Traceback" not in err
    assert all("link to a place outside" in said[student] for student in ("dev", "fay", "gus")), said
    assert not any("holds" in said[student] for student in ("dev", "fay", "gus")), said


def test_a_link_with_too_long_a_target_is_no_folder(run, tree):
    for folder in (tree, tree / "ada", tree / "ben" / SLUG):
        (folder / "notes").symlink_to("a" * 300)
    code, lines, _ = run(tree)
    assert (code, scores(lines)) == (0, {"ada": 10.0, "ben": 0.0, "cora": 0.0})


def test_a_students_folder_that_is_closed_is_a_note(run, tree, monkeypatch):
    entries = submissions._entries

    def closed(folder, most=None):
        if folder.name == "dan":
            raise submissions.BadPath("dan cannot be read")
        return entries(folder, most)

    monkeypatch.setattr(submissions, "_entries", closed)
    (tree / "dan").mkdir()
    code, lines, _ = run(tree)
    assert (code, scores(lines)) == (0, {"ada": 10.0, "ben": 0.0, "cora": 0.0, "dan": 0.0})
    assert next(line for line in lines if line["student"] == "dan")["message"] == "dan cannot be read"


def test_a_pipe_is_not_read(run, tree):
    path = tree / "ben" / SLUG / f"{SLUG}.py"
    path.unlink()
    os.mkfifo(path)
    _, lines, _ = run(tree)
    assert scores(lines) == {"ada": 10.0, "ben": 0.0, "cora": 0.0}


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["nowhere"], "nowhere does not exist"),
        (["."], "holds no submission"),
        (["x.py"], "cannot tell which assignment"),
        (["x.py", "--assignment", "hw99"], "no assignment 'hw99'"),
        (["hw08.py", "--only", "hw99"], "no assignment 'hw99'"),
        (["hw08.txt"], "neither a Python module"),
        (["hw08.py", "--out", "hw08.txt"], "cannot write results"),
        (["hw08.py", "--root", "."], "is no course"),
    ],
)
def test_bad_usage_is_said_and_exits_2(tmp_path, monkeypatch, capsys, arguments, says):
    monkeypatch.chdir(tmp_path)
    for name in ("x.py", "hw08.py", "hw08.txt"):
        (tmp_path / name).write_text(NOTHING)
    if arguments == ["."]:
        arguments = [str((tmp_path / "empty").mkdir() or tmp_path / "empty")]
    assert cli.main(["--root", str(assignments.find(Path(__file__).parents[1])), "grade", *arguments]) == 2
    assert says in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [["--jobs", "0"], ["--seed", "-1"], ["--seed", "x"], ["--memory", "0"]])
def test_bad_numbers_exit_2(arguments):
    with pytest.raises(SystemExit) as stop:
        cli.main(["grade", "hw08.py", *arguments])
    assert stop.value.code == 2


# Results that last


def test_scores_do_not_depend_on_jobs_and_runs(run, tree):
    def stable(lines):
        return sorted(json.dumps({k: v for k, v in line.items() if k != "seconds"}) for line in lines)

    first = stable(run(tree, "--seed", 3, "--jobs", 1)[1])
    assert first == stable(run(tree, "--seed", 3, "--jobs", 3)[1]) == stable(run(tree, "--seed", 3, "--jobs", 3)[1])


def test_results_are_written_and_found_again(run, tree, tmp_path, monkeypatch):
    out = tmp_path / "out"
    _, first, _ = run(tree, "--out", out)
    monkeypatch.setattr("tam570_grader.grading.many.graded", None)  # nothing may be graded again
    _, second, _ = run(tree, "--out", out)
    assert sorted(map(json.dumps, first)) == sorted(map(json.dumps, second))
    assert len((out / "results.jsonl").read_text().splitlines()) == 3
    table = csv.DictReader((out / "grades.csv").read_text().splitlines())
    assert [(row["student"], row["score"]) for row in table] == [("ada", "10.0"), ("ben", "0.0"), ("cora", "0.0")]
    assert "10 of 10" in (out / "feedback" / "ada" / f"{SLUG}.html").read_text()


def test_a_changed_submission_is_graded_again_with_the_same_seed(run, tree, tmp_path, solution_text):
    _, first, _ = run(tree, "--out", tmp_path / "out")
    (tree / "ben" / SLUG / f"{SLUG}.py").write_text(solution_text(SLUG))
    _, second, _ = run(tree, "--out", tmp_path / "out")
    assert scores(second) == {"ada": 10.0, "ben": 10.0, "cora": 0.0}
    assert {line["seed"] for line in first + second} == {first[0]["seed"]}
    assert len((tmp_path / "out" / "results.jsonl").read_text().splitlines()) == 3


def test_a_line_cut_short_by_a_kill_is_graded_again(run, tree, tmp_path):
    _, first, _ = run(tree, "--out", tmp_path / "out")
    path = tmp_path / "out" / "results.jsonl"
    path.write_bytes(path.read_bytes()[:-20])
    _, again, _ = run(tree, "--out", tmp_path / "out")
    assert scores(first) == scores(again)
    assert len(path.read_text().splitlines()) == 3


def test_a_foreign_results_file_is_not_overwritten(run, tree, tmp_path):
    path = tmp_path / "results.jsonl"
    path.write_text("my notes\n")
    assert run(tree, "--out", tmp_path)[0] == 2
    assert path.read_text() == "my notes\n"


def test_random_seeds_differ(run, tree):
    assert run(tree / "ben")[1][0]["seed"] != run(tree / "ben")[1][0]["seed"]


def command(*arguments, **options):
    return subprocess.Popen(
        [sys.executable, "-m", "tam570_grader.cli", *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        **options,
    )


@pytest.mark.parametrize(("how", "code"), [(signal.SIGINT, 130), (signal.SIGKILL, -9)])
def test_what_was_finished_survives_an_interrupt(tree, tmp_path, how, code):
    (tree / "zoe" / SLUG).mkdir(parents=True)
    (tree / "zoe" / SLUG / f"{SLUG}.py").write_text("def skew(v):\n    while True: pass\n")
    process = command("grade", tree, "--out", tmp_path / "out", "--jobs", 1, "--seed", 1, "--call", 50)
    results = tmp_path / "out" / "results.jsonl"
    while not results.exists() or results.read_text().count("\n") < 3:
        time.sleep(0.05)
    process.send_signal(how)
    _, err = process.communicate(timeout=60)
    assert process.returncode == code
    assert "Traceback" not in err and (how == signal.SIGKILL or "interrupted" in err)
    assert results.read_text().count("\n") == 3


@pytest.mark.parametrize("call", [1, 2])
def test_an_interrupt_while_a_line_is_written_loses_none(tree, tmp_path, monkeypatch, call):
    real, calls = os.fsync, []

    def interrupted(file):
        real(file)
        calls.append(file)
        if len(calls) == call:
            raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupted)
    assert cli.main(["grade", str(tree), "--out", str(tmp_path / "out"), "--seed", "1"]) == 130
    assert (tmp_path / "out" / "results.jsonl").read_text().count("\n") == call
    assert (tmp_path / "out" / "grades.csv").read_text().count("\n") == call + 1


@pytest.mark.skipif(os.geteuid() != 0 or sys.platform != "linux", reason="mounts a small disk")
def test_a_full_disk_keeps_what_was_finished(tree, tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=8k", "none", disk], check=True)
    try:
        for n in range(20):
            folder = tree / f"s{n}" / SLUG
            folder.mkdir(parents=True)
            (folder / f"{SLUG}.py").write_text(NOTHING)
        process = command("grade", tree, "--out", disk, "--seed", 1)
        _, err = process.communicate(timeout=60)
        assert process.returncode == 1
        assert "No space left" in err and "Traceback" not in err
        lines = (disk / "results.jsonl").read_text().split("\n")[:-1]
        assert lines and all(json.loads(line)["student"] for line in lines)
    finally:
        subprocess.run(["umount", disk], check=True)


def test_a_fault_of_the_grader_is_no_score_and_exits_1(run, tree, monkeypatch):
    def broken(function, calls):
        raise RuntimeError("a fault of ours")

    monkeypatch.setattr("tam570_grader.sandbox.student.Function.many", broken)
    code, (line,), err = run(tree / "ada")
    assert code == 1 and line["score"] is None and "a fault of ours" in err
    assert {mark["outcome"] for mark in line["checks"]} >= {"grader_error"}


def test_where_the_grader_failed_it_tries_again(run, tree, tmp_path, monkeypatch):
    def broken(function, calls):
        raise RuntimeError("a fault of ours")

    with monkeypatch.context() as fault:
        fault.setattr("tam570_grader.sandbox.student.Function.many", broken)
        run(tree / "ada", "--out", tmp_path / "out")
    code, (line,), _ = run(tree / "ada", "--out", tmp_path / "out")
    assert code == 0 and line["score"] == 10.0
    assert "10" in (tmp_path / "out" / "grades.csv").read_text()


def test_a_suspect_that_raises_costs_no_grade(run, tree, monkeypatch):
    def broken(solution, suspects, calls):
        raise IndexError("a fault of ours")

    monkeypatch.setattr("tam570_grader.grading.one.known", broken)
    (tree / "ben" / SLUG / f"{SLUG}.py").write_text("def rotate(axis, angle, r):\n    return r\n")
    code, (line,), _ = run(tree / "ben", "--seed", 1)
    failed = [mark for mark in line["checks"] if mark["outcome"] == "failed"]
    assert code == 0 and line["score"] is not None and failed
    assert any("a fault of ours" in mark["failure"].get("fault", "") for mark in failed)


STOPPER = """
import os, signal, sys, time
from pathlib import Path

def descendants(pid):
    for task in Path(f"/proc/{pid}/task").glob("*/children"):
        for child in map(int, task.read_text().split()):
            if child != os.getpid():
                yield child
                yield from descendants(child)

time.sleep(0.3)
everybody = [int(sys.argv[1]), *descendants(int(sys.argv[1]))]
for sign, wait in ((signal.SIGSTOP, 4), (signal.SIGCONT, 0)):
    for pid in everybody:
        os.kill(pid, sign)
    time.sleep(wait)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="finds the sandbox's processes in /proc")
def test_who_is_suspended_with_the_grader_is_not_late(course, workers):
    text = "def skew(v):\n    import time\n    time.sleep(0.8)\n    return [[0.0] * 3] * 3\n"
    allowance = Allowance(call=2.0)
    student = Student(Source(text.encode()), assignments.assignment(course, SLUG), workers(SLUG, allowance))
    student.load()
    with subprocess.Popen([sys.executable, "-c", STOPPER, str(os.getpid())]):
        assert np.array_equal(student.skew([1.0, 2.0, 3.0]), np.zeros((3, 3)))
    student.leave()


def test_a_function_that_hangs_fails_alone(grade, solution_text):
    from tam570_grader.sandbox.worker import Allowance

    text = solution_text(SLUG) + "\ndef rotate(r, axis, angle):\n    while True: pass\n"
    outcome = grade(SLUG, text, allowance=Allowance(call=1))
    assert outcome.score == 6.0 and outcome.status == "graded"
    assert any("did not return within 1 s" in mark.message for mark in outcome.checks)


def test_one_that_sleeps_through_its_calls_is_ended(grade, solution_text, monkeypatch):
    monkeypatch.setattr("tam570_grader.sandbox.student.PATIENCE", 1)
    received, receive = [], Cell.receive
    monkeypatch.setattr(Cell, "receive", lambda *given: received.append(receive(*given)) or received[-1])
    text = solution_text(SLUG) + "\n_skew = skew\ndef skew(v):\n    time.sleep(0.3)\n    return _skew(v)\nimport time\n"
    outcome = grade(SLUG, text, allowance=Allowance(cpu=2, call=1))
    assert outcome.status == "timeout" and outcome.score < 10 and "little processor time" in outcome.message
    assert len(received) < 20, "it is ended within a batch of calls"


def test_one_that_sleeps_at_every_import_and_call_is_ended(grade, solution_text, monkeypatch):
    """Each function of hw02 has bans, and a cell, of its own."""
    monkeypatch.setattr("tam570_grader.sandbox.student.PATIENCE", 1)
    slow = "import time\ntime.sleep(0.8)\n" + solution_text("hw02_ballistics")
    asleep = "import time\nskew = rotate = rotation_matrix = lambda *_, **__: time.sleep(9)\n"
    for slug, text in (("hw02_ballistics", slow), (SLUG, asleep)):
        outcome = grade(slug, text, allowance=Allowance(cpu=1.5, call=1))
        assert outcome.status == "timeout" and "little processor time" in outcome.message


def test_a_submission_has_a_process_group_of_its_own(grade, solution_text):
    text = "import os\nassert os.getpgrp() == os.getpid() == os.getsid(0)\n" + solution_text(SLUG)
    assert grade(SLUG, text).score == 10


def test_what_a_later_import_says_reaches_no_page(run, tmp_path, solution_text):
    """A file is imported again where a function has bans of its own, and may know hidden inputs by then."""
    again = "import scipy.integrate\nif type(scipy.integrate).__name__ != 'module': raise ValueError('1.25')"
    (tmp_path / "hw02.ipynb").write_text(notebook(solution_text("hw02_ballistics"), again, "1 / 0"))
    _, (line,), _ = run(tmp_path / "hw02.ipynb")
    assert line["score"] == 10.0 and line["message"].endswith("cell 4: ZeroDivisionError: division by zero")
    assert "1.25" not in json.dumps(line)


def test_one_that_is_tried_again_is_not_quoted(course, workers):
    source = Source(b"1 / 0")
    assignment, worker = assignments.assignment(course, SLUG), workers(SLUG, Allowance())
    first, second = (graded("dan", source, assignment, worker, 1, again=again) for again in (False, True))
    assert "division" in first.message and "second time" in second.message and "division" not in second.message


# Drawings


@pytest.mark.parametrize(("shape", "equal"), [(1, True), (0.5, False), (None, False)])
def test_a_scale_is_what_is_drawn_and_a_line_in_pieces_is_one_curve(shape, equal):
    from matplotlib.collections import LineCollection

    def coloured(axes):
        axes.add_collection(LineCollection([[(0, 0), (1, 1)], [(1, 1), (2, 0)], [(2, 0), (3, 3)]]))
        axes.set(xlim=(-1, 3), ylim=(-1, 3), box_aspect=shape)

    drawn = MODES["drawing"](coloured, [], {}, {})
    (line,) = drawn["lines"]
    assert line["points"].tolist() == [[0, 0], [1, 1], [2, 0], [3, 3]] and drawn["equal_aspect"] == equal


def test_lines_apart_are_as_many_curves():
    from matplotlib.collections import LineCollection

    drawn = MODES["drawing"](
        lambda axes: axes.add_collection(LineCollection([[(0, 0), (1, 1)], [(2, 1), (2, 0)]])), [], {}, {}
    )
    assert len(drawn["lines"]) == 2


# What crosses the boundary


@pytest.mark.parametrize(
    "value", [None, True, 1.5, [1.0, [2.0]], "x", b"x", np.eye(3), np.ones((2, 0)), Foreign("dict")]
)
def test_messages_arrive_as_they_were_sent(value):
    np.testing.assert_equal(unpacked(packed({"value": value})), {"value": value})


@pytest.mark.parametrize(
    "data", [b"", b"\xc1", b"\x81\xa1x", packed(1) + b"x", b"\xc7\x05\x01\x92\xa3|O8\x90", b"\xd4\x09\x00"]
)
def test_garbage_is_no_message(data):
    with pytest.raises(Unreadable):
        unpacked(data)


@pytest.mark.parametrize("small", [[], {}, Foreign("dict"), 1])
def test_a_short_message_cannot_ask_for_much_memory(small):
    with pytest.raises(Unreadable):
        unpacked(packed([small] * 2**21))


def test_the_search_for_imports_takes_no_longer_than_the_text():
    assert not imported(b"\n" * 2**20 + b" " * 2**20 + b"from \t" * 2**18)
    assert imported(b"\n\n  from scipy import integrate  # quad") == {"scipy.integrate"}


@pytest.mark.parametrize(
    ("value", "numbers"),
    [
        (mpmath.mpf("1.5"), 1.5),
        ([sympy.Rational(1, 2), 2], [0.5, 2.0]),
        ((np.array([1.0]), Fraction(1, 4)), [[1.0], 0.25]),
        (sympy.Matrix([[1, 2]]), [[1.0, 2.0]]),
        (np.array([[Decimal("0.5"), mpmath.pi]], dtype=object), [[0.5, np.pi]]),
    ],
)
def test_numbers_of_other_libraries_are_numbers(value, numbers):
    sent = portable(value)
    np.testing.assert_equal(sent, numbers)


@pytest.mark.parametrize(
    "value", [{}, {1}, "x", b"x", print, object(), [1, "x"], [[1], [object()]], np.array([object()])]
)
def test_what_is_no_number_is_foreign(value):
    assert "Foreign" in repr(portable(value))


@pytest.mark.parametrize(
    ("promise", "value", "says"),
    [
        (number, np.ones(1), "not a single number"),
        (number, float("nan"), "NaN or infinity"),
        (number, float("inf"), "NaN or infinity"),
        (number, np.array(1j), "complex numbers"),
        (number, None, "None"),
        (array(3), np.ones((3, 1)), "shape (3, 1)"),
        (array(3), [1.0, [2.0, 3.0]], "differ in length"),
        (array(None, 2), np.ones((0, 2)), "shape (k, 2)"),
        (rows(2), np.ones((4, 2)), "not an array of shape (5, 2)"),
        (rows(2), np.ones((2, 2)), "shape (5, 2). Rows are missing: did the integration stop early?"),
        (group(number, array(2)), 1.0, "tuple of 2"),
        (group(number, array(2)), [1.0, [2.0]], "result 2"),
    ],
)
def test_a_result_that_breaks_its_promise_says_how(promise, value, says):
    with pytest.raises(Failed) as failed:
        result(promise, value, "f", given(np.zeros(5)))
    assert says in message(failed.value.failure)


def test_infinity_is_a_number_where_it_is_promised():
    assert result(array(infinite=True), np.inf, "f", given()) == np.inf


@pytest.mark.parametrize("actual", [np.nan, np.inf, [1.0, np.nan], []])
def test_expect_lets_nothing_through_that_is_no_number(actual):
    with pytest.raises(Failed):
        expect(actual, np.ones_like(actual), within=1e300)


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


def test_a_worker_that_dies_is_replaced(solution_text, course):
    from tam570_grader.grading.many import Plan, graded_sources
    from tam570_grader.grading.submissions import Submission
    from tam570_grader.sandbox.student import Source
    from tam570_grader.sandbox.worker import Allowance, Worker

    started = []

    class Mortal(Worker):
        """The first worker is killed before it is ready, the second once it is."""

        def __init__(self, *arguments):
            super().__init__(*arguments)
            started.append(self)
            if len(started) == 1:
                self.kill()
            elif len(started) == 2:
                self._await_ready()
                self.kill()

    plan = Plan(course, [], 1, 1, Allowance())
    work = [(Submission("ada", SLUG, None, course), Source(solution_text(SLUG).encode()), "digest")]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("tam570_grader.grading.many.Worker", Mortal)
        ((outcome, _),) = graded_sources(plan, work)
    assert outcome.score == 10.0 and len(started) == 3


@pytest.mark.parametrize("body", ["raise ValueError", "return float('nan')", "return None", "v[0] = 0.0"])
def test_a_call_that_fails_says_for_what_kind_of_input(body, course, workers):
    text = f"def skew(v):\n    {body}\n"
    student = Student(Source(text.encode()), assignments.assignment(course, SLUG), workers(SLUG, Allowance()))
    for call in (
        lambda: student.on("a short v").skew(np.ones(3)),
        lambda: student.skew.many([given(np.ones(3)).on("a short v")]),
    ):
        with pytest.raises(Failed) as failed:
            call()
        assert failed.value.failure.kind == "a short v"
    student.leave()


@pytest.mark.parametrize(
    ("expression", "right"),
    [
        ("(m * l - m * g * sympy.sin(theta)) / (m * l) - 1", True),  # SymPy leaves it so
        ("-g * sympy.sin(theta) / l + m - sympy.sqrt(m**2)", True),  # as a mass is positive
        ("(sympy.exp(-sympy.I * theta) - sympy.exp(sympy.I * theta)) * g / (2 * sympy.I * l)", True),
        ("-g * sympy.sin(theta) / l + sympy.I * g / 10**9", False),
        ("-g * sympy.sin(theta) / (l * m**1e-9)", False),
        ("-g * sympy.sin(theta) / l / sympy.Function('f')(theta)", False),
    ],
)
def test_what_cancels_may_stand_in_a_formula(expression, right, course, workers):
    slug = "hw01_simple_pendulum"
    lines = ["import sympy", "def lagrange_equation():", f"    return {expression}"]
    lines.insert(2, "    m, theta, l, g = sympy.symbols('m theta l g')")
    source = Source("\n".join(lines).encode())
    student = Student(source, assignments.assignment(course, slug), workers(slug, Allowance()))
    points = [{"theta": 0.3, "l": 2.0, "g": 9.0}, {"theta": 2.0, "l": 0.5, "g": 3.0}]
    if right:
        sought = [-p["g"] * math.sin(p["theta"]) / p["l"] for p in points]
        assert student.lagrange_equation.at(points) == pytest.approx(sought, rel=1e-14)
    else:
        with pytest.raises(Failed, match="theta, l, g alone|not real"):
            student.lagrange_equation.at(points)
    student.leave()


@pytest.mark.parametrize(
    ("line", "names"),
    [
        ("import scipy.integrate", {"scipy.integrate"}),
        ("    from scipy.integrate import solve_ivp  # inside a function", {"scipy.integrate"}),
        ("from scipy import optimize, integrate", {"scipy.integrate", "scipy.optimize"}),
        ("import sympy as sp", {"sympy"}),
        ("import sympyx, scipyxintegrate", set()),
        ("# import sympy", set()),
        ("from tam570.integrate import solve", set()),
    ],
)
def test_what_a_submission_imports_is_read_from_its_text(line, names):
    assert imported(f"import math\n{line}\n".encode()) == names


def test_distances_from_a_polygon_are_those_to_its_sides_and_many_points_cost_no_more():
    square = [[0, 0], [2, 0], [2, 0], [2, 2]]  # a corner twice
    assert distances([[1, 0], [1, -3], [3, 3], [-3, 4]], square) == pytest.approx([0, 3, 2**0.5, 5])
    turn = np.linspace(0, 6, 300_000)
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    found = distances(2 * circle, circle)
    assert len(found) <= 400 and found == pytest.approx(1, abs=1e-5)


@pytest.mark.parametrize(
    ("label", "right"),
    [
        *((label, True) for label in ("x (m)", "x [m]", "right, m", "$x$ (m)", r"$x$ $[\mathrm{m}]$", "x in metres")),
        *((label, True) for label in ("Horizontal Distance (Meters)", "X [METRES]", "height in metre(s)")),
        *((f"$x{space}(m)$", True) for space in (r"\quad", r"\qquad", r"\enspace", r"\thinspace", r"\/", r"\>")),
        *((rf"$x\ {font}{{m}}$", True) for font in (r"\rm", r"\rm ", r"\boldsymbol", r"\operatorname", r"\big")),
        *((label, False) for label in ("", "x", "x (mm)", "x (M)", "m(x)", "moment", r"$x\quadm$")),
    ],
)
def test_a_label_names_metres_in_many_forms(label, right):
    axes = Drawing([], label, label, equal_aspect=True)
    with contextlib.nullcontext() if right else pytest.raises(Failed, match="not labelled with their unit"):
        judge_axes_of_lengths(readable(axes))


def test_an_assignment_is_found_by_its_short_name(course):
    assert assignments.assignment(course, "hw08").slug == SLUG
