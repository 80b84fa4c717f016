"""Late work by course.toml: dates, what days cost, more time; tables and pages obey, what disagrees is named."""

import csv

import pytest

from tam570_grader import cli
from tam570_grader.course.late_policy import policies

SLUG = "hw08_axis_angle"
COURSE = """
[late]
off_a_day = 0.1
most_off = 0.25
grace = 15

[hw08]
due = 2026-09-14T23:59:00

[hw08.extension]
cas = 2
"""
# who, when the file came, what is left of ten points
CAME = {
    "ann": ("2026-09-14 23:58:00", 10),
    "ben": ("2026-09-15 00:13:00", 10),  # within the grace
    "cas": ("2026-09-16 20:00:00", 10),  # within two days
    "dan": ("2026-09-15 00:15:00", 9),  # a day that has begun
    "eve": ("2026-09-16 00:13:00", 9),  # the grace holds each day
    "fay": ("2026-10-30 00:00:00", 7.5),  # no more than a quarter
}


@pytest.fixture(scope="module")
def graded(tmp_path_factory, solution_text):
    """A folder with graded work of everybody, which tests copy."""
    place = tmp_path_factory.mktemp("graded")
    for student in CAME:
        folder = place / "submitted" / student / SLUG
        folder.mkdir(parents=True)
        (folder / f"{SLUG}.py").write_text(solution_text(SLUG))
    assert cli.main(["grade", str(place / "submitted"), "--out", str(place / "results"), "--seed", "1"]) == 0
    return place / "results" / "results.jsonl"


@pytest.fixture
def desk(tmp_path, monkeypatch, graded):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "results").mkdir()
    (tmp_path / "results" / "results.jsonl").write_bytes(graded.read_bytes())
    (tmp_path / "course.toml").write_text(COURSE)
    monkeypatch.setenv("TAM570_HOME", str(tmp_path / "home"))
    assert cli.main(["trust"]) == 0
    collected([(who, when, "") for who, (when, _) in CAME.items()])
    return tmp_path


def collected(rows):
    lines = [f"{who},,{SLUG},{SLUG}.py,{when},{late},{SLUG}.py," for who, when, late in rows]
    with open("collected.csv", "w") as file:
        file.write("\n".join(["student,name,assignment,file,when,late,from,note", *lines]))


def points(*rows, collected=True):
    with open("points.csv", "w") as file:
        file.write("\n".join(["student,assignment,item,points,comment", *rows]))
    times = ["--collected", "collected.csv"] if collected else []
    return cli.main(["points", "results", *(["points.csv"] if rows else []), *times])


def scores():
    with open("results/grades.csv", newline="") as file:
        return {row["student"]: float(row["score"]) for row in csv.DictReader(file)}


def test_tables_and_pages_obey(desk, capsys):
    assert points() == 0
    assert capsys.readouterr().out == "results: 0 rows added by hand, 4 late\n"
    assert scores() == {who: left for who, (_, left) in CAME.items()}
    page = (desk / "results" / "feedback" / "fay" / f"{SLUG}.html").read_text()
    assert "7.5 of 10 points" in page and "25 % of the points are taken off" in page
    capsys.readouterr()
    assert cli.main(["report", "results"]) == 0
    assert cli.main(["lms", "results/grades.csv", "--to", "moodle", "--out", "up.csv"]) == 0
    assert "fay,7.5" in (desk / "up.csv").read_text() and "warning" not in capsys.readouterr().err


def test_changed_terms_are_told_until_they_are_obeyed(desk, capsys):
    points()
    (desk / "course.toml").write_text(
        COURSE.replace("0.1", "0.2").replace("cas = 2", "dan = 1").replace("-14T", "-15T")
    )
    capsys.readouterr()
    for command in (["report", "results"], ["lms", "results/grades.csv", "--to", "moodle"]):
        assert cli.main(command) == 0
        _, line = capsys.readouterr().err.splitlines()
        assert line.endswith("tam570-grader points results --collected collected.csv")
    assert points() == 0 and scores() == {"ann": 10, "ben": 10, "cas": 8, "dan": 10, "eve": 10, "fay": 7.5}
    (desk / "course.toml").write_text("")
    assert cli.main(["report", "results"]) == 0 and "other terms" in capsys.readouterr().err
    assert points() == 0 and set(scores().values()) == {10.0}


def test_a_row_by_hand_counts_in_the_place_of_the_time(desk):
    assert points("fay,hw08,late,1,It came by mail.") == 0
    assert scores()["fay"] == 9.0
    assert points() == 0 and scores()["fay"] == 9.0


@pytest.mark.parametrize("row", ["*,hw08,off a day,.5,", "cas,hw08,extension,1,"])
def test_what_disagrees_is_named_and_nothing_is_written(desk, capsys, row):
    assert points(row) == 2
    _, line = capsys.readouterr().err.splitlines()
    assert "in course.toml" in line and "by hand" in line and "change one" in line
    assert not (desk / "results" / "by_hand.csv").exists()


def test_whose_time_is_not_known_is_named(desk, capsys):
    collected([("ann", "", ""), ("ben", "", "LATE")])
    assert points() == 1
    assert "ben is late" in (err := capsys.readouterr().err) and "ann" not in err
    collected([("ann", "2026-09-16T04:59:00 UTC", ""), ("ben", "yesterday", "")])
    assert points() == 2 and "'yesterday'" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("[late]\noff_a_day = 10", "[late] off_a_day is 10; write a number from 0 to 1"),
        ("[late]\nof_a_day = .1", "cannot read"),
        ("[late]\nof_a_day = 0.1", "do you mean off_a_day?"),
        ("late = 3", "late must be a table"),
        ('[hw08]\ndue = "Monday"', "[hw08] due is 'Monday'; write a date and a time"),
        ("[hw08]\nextension = 2", "write [hw08.extension]"),
        ("[hw08.extension]\nann = -1", "[hw08.extension] ann is -1; write days"),
    ],
)
def test_what_does_not_fit_is_named_with_its_key(desk, capsys, text, says):
    (desk / "course.toml").write_text(text)
    assert points() == 2
    assert says in capsys.readouterr().err


def test_a_name_without_results_is_told(desk, capsys):
    (desk / "course.toml").write_text(COURSE.replace("cas = 2", "cass = 2"))
    assert points() == 1
    assert "cass more time in hw08_axis_angle; no results" in capsys.readouterr().err


@pytest.mark.parametrize("key", ["hw7", "HW07", "homework 7"])
def test_an_assignment_has_the_names_that_it_has_elsewhere(tmp_path, key):
    found = policies(tmp_path / "course.toml", {key: {"extension": {"ann": 1}}}, ["hw07_double_pendulum", SLUG])
    assert [dict(one.extension) for one in found.values()] == [{"ann": 1}, {}]


def test_hw1_is_not_hw10(tmp_path):
    found = policies(tmp_path / "course.toml", {"hw1": {"extension": {"ann": 1}}}, ["hw01_pendulum", "hw10_disk"])
    assert [dict(one.extension) for one in found.values()] == [{"ann": 1}, {}]
