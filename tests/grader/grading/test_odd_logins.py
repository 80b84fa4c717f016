"""A roster or the shape of a tree decides what is a student's folder; names never do."""

import shutil
import unicodedata

import pytest
from parameters import first

SLUG, OTHER = "hw08_axis_angle", "hw03_angular_momentum_rate"
ODD = ["hw7", "HW08", "homework 3", "juan@pol.una.py", "hw07_double_pendulum", "notes.ipynb", "jos\u0065\u0301"]


@pytest.fixture
def hand_in(tmp_path, solution_text):
    def hand_in(student, place=f"{SLUG}/{SLUG}.py", slug=SLUG):
        path = tmp_path / "submitted" / student / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(solution_text(slug))
        return tmp_path / "submitted"

    return hand_in


@pytest.mark.parametrize("place", [f"{SLUG}/{SLUG}.py", f"{SLUG}.py", "hw08.PY", "hw08/hw08.py.txt"])
def test_an_odd_login_among_others(run, hand_in, scores, place):
    for student in ("ann", *ODD):
        tree = hand_in(student, place)
    code, lines, _ = run(tree, "--seed", 1, "--jobs", 1)
    assert code == 0 and scores(lines) == {"ann": 10.0, **{unicodedata.normalize("NFC", item): 10.0 for item in ODD}}
    assert {line["assignment"] for line in lines} == {SLUG}


@pytest.mark.parametrize("login", first(3, ODD))
def test_an_odd_login_alone_and_with_a_roster(run, hand_in, tmp_path, login):
    tree = hand_in(login, f"{SLUG}.py")
    (tmp_path / "roster.csv").write_text(f"Username,Name\n{login},A B\nann,Ann Lee\n")
    for path in (tree, tree / login):
        code, lines, _ = run(path, "--roster", tmp_path / "roster.csv", "--seed", 1)
        rows = {(line["student"], line["assignment"], line["score"]) for line in lines}
        assert code == 0 and rows == {(unicodedata.normalize("NFC", login), SLUG, 10.0), ("ann", SLUG, 0.0)}


def test_the_assignments_of_one_student_are_no_students(run, hand_in):
    tree = hand_in("ann")
    hand_in("ann", f"{OTHER}/{OTHER}.py", OTHER)
    shutil.copytree(tree / "ann" / SLUG, tree / "ann" / "old")
    _, lines, _ = run(tree / "ann", "--seed", 1)
    assert {("ann", SLUG), ("ann", OTHER)} <= {(line["student"], line["assignment"]) for line in lines}
