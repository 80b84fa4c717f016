"""Whatever a student hands in has a row, or a warning that names the file and the remedy."""

import pytest

from tam570_grader import cli
from tam570_grader.grading.skipped_files import skipped_files
from tam570_grader.grading.submissions import submissions

SLUG = "hw08_axis_angle"
KNOWN = ["hw07_double_pendulum", SLUG]
GRADED = (
    f"ada/{SLUG}/{SLUG}.py",
    f"ben/{SLUG}/solution.py",
    "cho/HW8.py",
    "dan/axis_angle.py",
    "eve/homework8/hw08_final.py",
    "fay/Axis_Angle-2.ipynb",
    "hal/hw08_axis_angle.py.txt",
    "ivy/HW08.PY",
)
ROWS_THAT_SAY_WHY = {"gus/hw08.zip": "unpack it", "joe/hw08.txt": "rename it"}


@pytest.fixture
def class_of(tmp_path):
    """`class_of(files)` -> a tree with these files in it."""

    def class_of(files):
        for name in files:
            path = tmp_path / "submitted" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("def skew(v): return None\n")
        return tmp_path / "submitted"

    return class_of


def test_files_are_known_by_number_by_title_and_alone(class_of):
    found = {one.student: one for one in submissions([class_of(GRADED)], KNOWN)}
    assert sorted(found) == sorted(name.split("/")[0] for name in GRADED)
    assert all(one.path and one.slug == SLUG for one in found.values())


def test_what_is_packed_or_misnamed_has_a_row_that_says_so(class_of, run):
    _, lines, _ = run(class_of([GRADED[0], *ROWS_THAT_SAY_WHY]), "--seed", "1")
    rows = {line["student"]: line for line in lines}
    for name, remedy in ROWS_THAT_SAY_WHY.items():
        row = rows[name.split("/")[0]]
        assert row["status"] == "unreadable" and remedy in row["message"]


@pytest.mark.parametrize("packed", [("hw08.zip", "hw08 (1).zip"), ("hw08.zip", "hw08.txt")])
def test_two_packed_files_of_a_student_are_one_row_and_hold_up_nobody(class_of, run, packed):
    _, lines, _ = run(class_of([GRADED[0], *(f"bob/{name}" for name in packed)]), "--seed", "1")
    assert [(line["student"], line["status"]) for line in lines] == [("ada", "graded"), ("bob", "unreadable")]
    assert all(name in lines[1]["message"] for name in (*packed, "unpacked"))


def test_two_folders_of_one_assignment_are_one_row(class_of):
    (one,) = submissions([class_of(["hw08/hw08.py", "hw08_old/hw08.py"])], KNOWN)
    assert one.path is None and one.note.endswith("hw08, hw08_old")


@pytest.mark.parametrize("name", ["ida/work.py", "ida/final.zip", "ida/mine/a.py", "loose.zip", "ida/notes.pdf"])
def test_what_tells_no_assignment_is_warned_of(class_of, name):
    tree = class_of([GRADED[0], name])
    (says,) = skipped_files([tree], submissions([tree], KNOWN), KNOWN)
    assert all(part in says for part in name.split("/")[:2]) and "--assignment" in says


def test_a_file_beside_a_graded_one_is_warned_of(class_of):
    tree = class_of(["ada/hw08.py", "ada/scratch.py", "ada/test_mine.py", "ada/notes.md"])
    (says,) = skipped_files([tree], submissions([tree], KNOWN), KNOWN)
    assert says.startswith("ada/scratch.py is not graded")


def test_a_named_assignment_takes_lone_files_and_leaves_those_of_others(class_of):
    tree = class_of(["ada/work.py", "ben/hw07.py", "cho/hw08.py"])
    found = submissions([tree], KNOWN, SLUG)
    assert {one.student for one in found} == {"ada", "cho"} and all(one.path for one in found)


def test_gradescope_takes_a_lone_file_of_any_name(class_of):
    folder = class_of(["my_work.py"])
    (one,) = submissions([folder], KNOWN, SLUG)
    assert one.path and one.path.name == "my_work.py"


def test_the_roster_gives_everyone_a_row(class_of, run, tmp_path):
    (tmp_path / "roster.csv").write_text("ada\nzoe\n")
    code, lines, _ = run(class_of(["ada/hw08.py"]), "--seed", "1", "--roster", tmp_path / "roster.csv")
    assert code == 0 and {line["student"]: line["status"] for line in lines} == {"ada": "graded", "zoe": "missing"}


@pytest.mark.parametrize("login", ["../../up", "\x1b[2J", "a\0b", "z" * 300])
def test_no_login_leads_out_of_the_results(class_of, run, tmp_path, login):
    (tmp_path / "roster.csv").write_text(f"ada\n{login}\n")
    where = ["--seed", "1", "--roster", tmp_path / "roster.csv", "--out", tmp_path / "results"]
    code, lines, _ = run(class_of(["ada/hw08.py"]), *where)
    (name,) = {line["student"] for line in lines} - {"ada"}
    assert code == 0 and name.isprintable() and not (tmp_path / "up").exists()
    assert {path.name for path in (tmp_path / "results" / "feedback").iterdir()} == {"ada", name}


def test_grade_prints_the_warnings(class_of, capsys):
    assert cli.main(["grade", str(class_of(["ada/hw08.py", "ben/thing.py"])), "--seed", "1"]) == 0
    assert "ben (it holds thing.py) is not graded" in capsys.readouterr().err
