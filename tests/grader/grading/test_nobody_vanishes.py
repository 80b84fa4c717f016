"""Whatever a student hands in has a row, or a warning that names the file and the remedy."""

import pytest

from tam570_grader.grading.skipped_files import skipped_files
from tam570_grader.grading.submissions import submissions

SLUG = "hw08_axis_angle"
SLUGS = ["hw07_double_pendulum", SLUG]
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
    actual = {item.student: item for item in submissions([class_of(GRADED)], SLUGS)}
    assert sorted(actual) == sorted(name.split("/")[0] for name in GRADED)
    assert all(item.path and item.slug == SLUG for item in actual.values())


def test_what_cannot_be_told_is_one_row_that_says_why_and_holds_up_nobody(class_of, run):
    odd = {
        "bob": ("hw08.zip", "hw08 (1).zip"),
        "dan": ("hw08.zip", "hw08.txt"),
        "gus": ("hw08.zip",),
        "joe": ("hw08.txt",),
        "kim": ("hw08.py", "hw08_old.py"),
    }
    files = [f"{student}/{name}" for student, names in odd.items() for name in names]
    _, lines, _ = run(class_of([GRADED[0], *files]), "--seed", "1", "--jobs", "1")
    said = {line["student"]: line.get("message", "") for line in lines if line["student"] in odd}
    assert len(lines) == 6 and set(said) == set(odd)
    assert "unpack it" in said["gus"] and "rename it" in said["joe"]
    assert all(name in said[student] for student in ("bob", "dan", "kim") for name in odd[student])


@pytest.mark.parametrize(
    "name", ["ida/work.py", "ida/hw080.py", "ida/final.zip", "ida/mine/a.py", "lone.zip", "ida/notes.pdf"]
)
def test_what_tells_no_assignment_is_warned_of(class_of, name):
    tree = class_of([GRADED[0], name])
    (warning,) = skipped_files([tree], submissions([tree], SLUGS), SLUGS)
    assert all(part in warning for part in name.split("/")[:2]) and "--assignment" in warning


def test_a_file_beside_a_graded_one_is_warned_of(class_of):
    tree = class_of(["ada/hw08.py", "ada/scratch.py", "ada/test_mine.py", "ada/notes.md"])
    (warning,) = skipped_files([tree], submissions([tree], SLUGS), SLUGS)
    assert warning.startswith("ada/scratch.py is not graded")


def test_a_named_assignment_takes_lone_files_and_leaves_those_of_others(class_of):
    tree = class_of(["ada/work.py", "ben/hw07.py", "cho/hw08.py"])
    actual = submissions([tree], SLUGS, SLUG)
    assert {item.student for item in actual} == {"ada", "cho"} and all(item.path for item in actual)


@pytest.mark.parametrize("login", ["zoe", "../../up", "\x1b[2J", "a\0b", "z" * 300])
def test_the_roster_gives_everyone_a_row_and_no_login_leads_out_of_the_results(class_of, run, tmp_path, login):
    (tmp_path / "roster.csv").write_text(f"ada\n{login}\n")
    where = ["--seed", "1", "--roster", tmp_path / "roster.csv", "--out", tmp_path / "results"]
    code, lines, _ = run(class_of(["ada/hw08.py"]), *where)
    (name,) = {line["student"] for line in lines if line["status"] == "missing"}
    assert code == 0 and name.isprintable() and not (tmp_path / "up").exists() and (name == login) == (login == "zoe")
    assert {path.name for path in (tmp_path / "results" / "feedback").iterdir()} == {"ada", name}
