"""One download after another: collected.csv lists them all, late days stay, a notebook that is overtaken is named."""

import csv
import zipfile
from pathlib import Path

import pytest

from tam570_grader import cli
from tam570_grader.results.records import FORMAT
from tam570_grader.results.store import RESULT_FIELDS, ResultStore

COURSE = """
[late]
off_a_day = 0.1

[hw7]
due = 2026-09-07T23:59:00

[hw8]
due = 2026-09-14T23:59:00
"""
STUB = "def rotate(r, axis, angle):\n    raise NotImplementedError\n"
NOTEBOOK = '{"cells": [{"cell_type": "code", "source": ["def rotate(r, axis, angle):\\n"]}], "nbformat": 4}'


@pytest.fixture
def desk(tmp_path, monkeypatch):
    """An empty folder with course.toml, where the commands are given."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "course.toml").write_text(COURSE)
    monkeypatch.setenv("TAM570_HOME", str(tmp_path / "home"))
    assert cli.main(["trust"]) == 0
    return tmp_path


def collect(*came, more=()):
    """Collect a download of Blackboard's, of (student, file, day of September, text); the exit code."""
    with zipfile.ZipFile("download.zip", "w") as archive:
        for who, file, day, *text in came:
            archive.writestr(f"HW_{who}_attempt_2026-09-{day:02}-12-00-00_{file}", "".join(text))
    return cli.main(["collect", "download.zip", "--from", "blackboard", *more])


def without_the_course(capsys):
    """What was said, but for the line that names the course."""
    said = capsys.readouterr().err.splitlines(keepends=True)
    return "".join(line for line in said if "tam570-grader: course: " not in line)


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def collected():
    return [(row["student"], row["assignment"][:4], row["when"][:10]) for row in rows("collected.csv")]


def scores():
    """What students have by collected.csv and course.toml, where all is right."""
    book = ResultStore(Path("results"))
    for row in rows("collected.csv"):
        fields = {"student": row["student"], "assignment": row["assignment"], "status": "graded", "seed": 1}
        book.add(
            {
                **dict.fromkeys(RESULT_FIELDS, 0),
                "format": FORMAT,
                **fields,
                "score": 10.0,
                "max_score": 10.0,
                "checks": [],
            }
        )
    book.close()
    assert cli.main(["points", "results", "--collected", "collected.csv"]) == 0
    return {(row["student"], row["assignment"][:4]): float(row["score"]) for row in rows("results/grades.csv")}


def test_the_next_homework_leaves_the_rows_and_late_days_of_the_last(desk):
    assert collect(("ann", "hw07.py", 6), ("ben", "hw07.py", 9)) == 0
    assert scores() == {("ann", "hw07"): 10, ("ben", "hw07"): 8}
    assert collect(("ann", "hw08.py", 16), ("ben", "hw08.py", 13)) == 0
    assert len(collected()) == 4
    assert scores() == {("ann", "hw07"): 10, ("ann", "hw08"): 8, ("ben", "hw07"): 8, ("ben", "hw08"): 10}


def test_what_is_collected_again_replaces_its_row_and_no_other(desk):
    collect(("ann", "hw07.py", 6, "first"), ("ben", "hw07.py", 6))
    collect(("ann", "hw07.py", 9, "second"))
    assert collected() == [("ann", "hw07", "2026-09-09"), ("ben", "hw07", "2026-09-06")]
    assert [path.read_text() for path in desk.glob("submitted/ann/*/*")] == ["second"]


@pytest.mark.parametrize(
    ("module", "day", "code"), [("x = 1\n", 12, 1), ("x = 1\n", 13, 0), ("x = 1\n", 14, 0), (STUB, 12, 0)]
)
def test_a_notebook_that_came_after_the_module_that_counts_is_named(desk, capsys, module, day, code):
    assert collect(("ann", "hw08.py", day, module), ("ann", "hw08.ipynb", 13, NOTEBOOK)) == code
    err = without_the_course(capsys)
    assert bool(err) == bool(code) and ("hw08.ipynb of ann is newer than submitted/ann/" in err) == bool(code)


@pytest.mark.parametrize(("module", "late"), [("x = 1\n", ["ben"]), (STUB, ["ann", "ben"])])
def test_the_time_of_what_is_graded_counts(desk, module, late):
    """A notebook that comes late beside a module costs days only where it is the one that is graded."""
    collect(("ann", "hw08.py", 12, module), ("ann", "hw08.ipynb", 16, NOTEBOOK), ("ben", "hw08.py", 16, "x = 1\n"))
    assert cli.main(["grade", "submitted", "--out", "results", "--seed", "1"]) == 0
    assert cli.main(["points", "results", "--collected", "collected.csv"]) == 0
    days = {row["student"]: float(row["points"]) for row in rows("results/by_hand.csv") if row["item"] == "late"}
    assert days == {who: pytest.approx(1.51) for who in late}
