"""Bad input: what cannot be loaded or read costs its own student alone; bad usage exits with 2."""

import csv
import json
import os
from pathlib import Path

import pytest

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.grading import submissions

SLUG = "hw08_axis_angle"
NOTHING = "def skew(v): return None\n"


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


def test_a_link_out_of_the_tree_is_not_followed(run, tree, course, scores):
    path = tree / "ben" / SLUG / f"{SLUG}.py"
    path.unlink()
    path.symlink_to(course / "solutions" / f"{SLUG}.py")
    _, lines, _ = run(tree)
    assert scores(lines)["ben"] == 0.0


def test_a_link_to_a_neighbours_work_is_not_followed(run, tree, scores):
    (tree / "ben" / SLUG / f"{SLUG}.py").unlink()
    (tree / "ben" / SLUG / f"{SLUG}.py").symlink_to(f"../../ada/{SLUG}/{SLUG}.py")
    (tree / "cora" / SLUG).rmdir()
    (tree / "cora" / SLUG).symlink_to(f"../ada/{SLUG}")
    (tree / "dan").symlink_to("ada")
    (tree / "hw08_eve.py").symlink_to(f"ada/{SLUG}/{SLUG}.py")
    _, lines, _ = run(tree)
    assert scores(lines) == {"ada": 10.0, "ben": 0.0, "cora": 0.0, "dan": 0.0, "hw08_eve": 0.0}


def test_a_link_within_the_own_folder_is_followed(run, tree, scores):
    path = tree / "ada" / SLUG / f"{SLUG}.py"
    path.rename(tree / "ada" / "final.py")
    path.symlink_to("../final.py")
    assert scores(run(tree)[1])["ada"] == 10.0
    (tree.parent / "class").symlink_to(tree)
    assert scores(run(tree.parent / "class")[1])["ada"] == 10.0


def test_a_student_with_two_files_holds_up_nobody(run, tree, scores):
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


def test_files_beside_a_module_are_not_run(run, tree, monkeypatch, scores):
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
def test_a_text_that_breaks_parsers_harms_nobody_else(run, tmp_path, solution_text, text, scores):
    for name, content in {"ann": text, "ben": solution_text(SLUG).encode()}.items():
        (tmp_path / name / SLUG).mkdir(parents=True)
        (tmp_path / name / SLUG / f"{SLUG}.py").write_bytes(content)
    code, lines, _ = run(tmp_path, "--jobs", 1)
    assert (code, scores(lines)) == (0, {"ann": 0.0, "ben": 10.0})


NAMES = ("=cmd|'calc'!A0", "@sum", "+1", "<img src=x onerror=alert(1)>", "%2e%2e%2fada", "a'b\"c", "l" * 255)


def test_a_name_is_a_name_and_nothing_else(run, tmp_path, solution_text, scores):
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


def test_names_that_print_alike_or_too_long_are_two_students_with_pages(run, tmp_path, solution_text, scores):
    submitted, out = tmp_path / "submitted", tmp_path / "out"
    for name in ("x\ny", r"x\ny", "\u200b" * 80, "\u200b" * 81):
        (submitted / name / SLUG).mkdir(parents=True)
        (submitted / name / SLUG / f"{SLUG}.py").write_text(solution_text(SLUG))
    _, lines, _ = run(submitted, "--out", out)
    assert [line["score"] for line in lines] == [10.0] * 4 and len(scores(lines)) == 4
    assert len(list((out / "feedback").glob("*/*.html"))) == 4


def test_a_link_that_leads_away_or_nowhere_is_a_note_and_lists_nothing(run, tree, scores):
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


def test_a_link_with_too_long_a_target_is_no_folder(run, tree, scores):
    for folder in (tree, tree / "ada", tree / "ben" / SLUG):
        (folder / "notes").symlink_to("a" * 300)
    code, lines, _ = run(tree)
    assert (code, scores(lines)) == (0, {"ada": 10.0, "ben": 0.0, "cora": 0.0})


def test_a_students_folder_that_is_closed_is_a_note(run, tree, monkeypatch, scores):
    entries = submissions.entries

    def closed(folder, most=None):
        if folder.name == "dan":
            raise submissions.BadPath("dan cannot be read")
        return entries(folder, most)

    monkeypatch.setattr(submissions, "entries", closed)
    (tree / "dan").mkdir()
    code, lines, _ = run(tree)
    assert (code, scores(lines)) == (0, {"ada": 10.0, "ben": 0.0, "cora": 0.0, "dan": 0.0})
    assert next(line for line in lines if line["student"] == "dan")["message"] == "dan cannot be read"


def test_a_pipe_is_not_read(run, tree, scores):
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
        (["README.md"], "neither a Python module"),
        (["hw08.py", "--out", "hw08.txt"], "cannot write results"),
        (["hw08.py", "--root", "."], "does not hold a course"),
    ],
)
def test_bad_usage_is_said_and_exits_2(tmp_path, monkeypatch, capsys, arguments, says):
    monkeypatch.chdir(tmp_path)
    for name in ("x.py", "hw08.py", "hw08.txt", "README.md"):
        (tmp_path / name).write_text(NOTHING)
    if arguments == ["."]:
        arguments = [str((tmp_path / "empty").mkdir() or tmp_path / "empty")]
    assert cli.main(["--root", str(assignments.find(Path(__file__).parents[3])), "grade", *arguments]) == 2
    assert says in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [["--jobs", "0"], ["--seed", "-1"], ["--seed", "x"], ["--memory", "0"]])
def test_bad_numbers_exit_2(arguments):
    with pytest.raises(SystemExit) as stop:
        cli.main(["grade", "hw08.py", *arguments])
    assert stop.value.code == 2
