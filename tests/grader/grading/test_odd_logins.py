"""A roster or the shape of a tree decides what is a student's folder; names never do."""

import shutil
import unicodedata

import pytest
from classes import HW08, hand_in
from parameters import first

OTHER = "hw03_angular_momentum_rate"
ODD = ["hw7", "HW08", "homework 3", "juan@pol.una.py", "hw07_double_pendulum", "notes.ipynb", "jos\u0065\u0301"]


@pytest.mark.parametrize("file", ["{0}/{0}.py", "{0}.py", "hw08.PY", "hw08/hw08.py.txt"])
def test_an_odd_login_among_others(run, tmp_path, solution_text, scores, file):
    tree = hand_in(tmp_path / "submitted", dict.fromkeys(["ann", *ODD], solution_text(HW08)), file=file)
    code, lines, _ = run(tree, "--seed", 1, "--jobs", 1)
    assert code == 0 and scores(lines) == {unicodedata.normalize("NFC", item): 10.0 for item in ("ann", *ODD)}
    assert {line["assignment"] for line in lines} == {HW08}


@pytest.mark.parametrize("login", first(3, ODD))
def test_an_odd_login_alone_and_with_a_roster(run, tmp_path, solution_text, login):
    tree = hand_in(tmp_path / "submitted", {login: solution_text(HW08)}, file="{0}.py")
    (tmp_path / "roster.csv").write_text(f"Username,Name\n{login},A B\nann,Ann Lee\n")
    for path in (tree, tree / login):
        code, lines, _ = run(path, "--roster", tmp_path / "roster.csv", "--seed", 1)
        rows = {(line["student"], line["assignment"], line["score"]) for line in lines}
        assert code == 0 and rows == {(unicodedata.normalize("NFC", login), HW08, 10.0), ("ann", HW08, 0.0)}


def test_the_assignments_of_one_student_are_no_students(run, tmp_path, solution_text):
    for slug in (HW08, OTHER):
        tree = hand_in(tmp_path / "submitted", {"ann": solution_text(slug)}, slug)
    shutil.copytree(tree / "ann" / HW08, tree / "ann" / "old")
    _, lines, _ = run(tree / "ann", "--seed", 1)
    assert {("ann", HW08), ("ann", OTHER)} <= {(line["student"], line["assignment"]) for line in lines}
