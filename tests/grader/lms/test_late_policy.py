"""Late work by course.toml: dates, what days cost, more time; tables and pages obey, what disagrees is named."""

import pytest
from classes import HW08, hand_in, rows

from tam570_grader import cli
from tam570_grader.course.late_policy import policies

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
    """The results of right work of everybody, which tests copy."""
    place = tmp_path_factory.mktemp("graded")
    tree = hand_in(place / "submitted", dict.fromkeys(CAME, solution_text(HW08)))
    assert cli.main(["grade", str(tree), "--out", str(place / "results"), "--seed", "1", "--jobs", "1"]) == 0
    return place / "results" / "results.jsonl"


@pytest.fixture
def term(desk, monkeypatch, graded):
    """The desk of a trusted course, with results and the times of what was collected."""
    (desk.place / "results").mkdir()
    desk.write("results/results.jsonl", graded.read_bytes())
    desk.write("course.toml", COURSE)
    monkeypatch.setenv("TAM570_HOME", str(desk.place / "home"))
    assert cli.main(["trust"]) == 0
    collect(desk, [(who, when, "") for who, (when, _) in CAME.items()])
    return desk


def collect(desk, came):
    lines = [f"{who},,{HW08},{HW08}.py,{when},{late},{HW08}.py," for who, when, late in came]
    desk.write("collected.csv", "\n".join(["student,name,assignment,file,when,late,from,note", *lines]))


def points(*lines):
    if lines:
        with open("points.csv", "w") as file:
            file.write("\n".join(["student,assignment,item,points,comment", *lines]))
    return cli.main(["points", "results", *(["points.csv"] if lines else []), "--collected", "collected.csv"])


def scores():
    return {row["student"]: float(row["score"]) for row in rows("results/grades.csv")}


def test_tables_and_pages_obey(term, capsys):
    assert points() == 0
    assert scores() == {who: left for who, (_, left) in CAME.items()}
    page = (term.place / "results" / "feedback" / "fay" / f"{HW08}.html").read_text()
    assert "7.5 of 10 points" in page and "25 %" in page
    capsys.readouterr()
    assert cli.main(["report", "results"]) == 0
    assert cli.main(["lms", "results/grades.csv", "--to", "moodle", "--out", "up.csv"]) == 0
    assert "fay,7.5" in (term.place / "up.csv").read_text() and "warning" not in capsys.readouterr().err


def test_changed_terms_are_told_until_they_are_obeyed(term, capsys):
    points()
    term.write("course.toml", COURSE.replace("0.1", "0.2").replace("cas = 2", "dan = 1").replace("-14T", "-15T"))
    capsys.readouterr()
    for command in (["report", "results"], ["lms", "results/grades.csv", "--to", "moodle"]):
        assert cli.main(command) == 0
        assert "tam570-grader points results --collected collected.csv" in capsys.readouterr().err
    assert points() == 0 and scores() == {"ann": 10, "ben": 10, "cas": 8, "dan": 10, "eve": 10, "fay": 7.5}
    term.write("course.toml", "")
    assert points() == 0 and set(scores().values()) == {10.0}


def test_a_row_by_hand_counts_in_the_place_of_the_time(term):
    assert points("fay,hw08,late,1,It came by mail.") == 0
    assert scores()["fay"] == 9.0
    assert points() == 0 and scores()["fay"] == 9.0


@pytest.mark.parametrize("row", ["*,hw08,off a day,.5,", "cas,hw08,extension,1,"])
def test_what_disagrees_is_named_and_nothing_is_written(term, capsys, row):
    assert points(row) == 2
    assert "in course.toml" in capsys.readouterr().err and not (term.place / "results" / "by_hand.csv").exists()


def test_whose_time_is_not_known_is_named(term, capsys):
    collect(term, [("ann", "", ""), ("ben", "", "LATE")])
    assert points() == 1
    assert "ben is late" in (err := capsys.readouterr().err) and "ann" not in err
    collect(term, [("ann", "2026-09-16T04:59:00 UTC", ""), ("ben", "yesterday", "")])
    assert points() == 2 and "'yesterday'" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("[late]\noff_a_day = 10", "[late] off_a_day is 10"),
        ("[late]\nof_a_day = .1", "cannot read"),
        ("[late]\nof_a_day = 0.1", "do you mean off_a_day?"),
        ("late = 3", "late must be a table"),
        ('[hw08]\ndue = "Monday"', "[hw08] due is 'Monday'"),
        ("[hw08]\nextension = 2", "write [hw08.extension]"),
        ("[hw08.extension]\nann = -1", "[hw08.extension] ann is -1"),
    ],
)
def test_what_does_not_fit_is_named_with_its_key(term, capsys, text, says):
    term.write("course.toml", text)
    assert points() == 2
    assert says in capsys.readouterr().err


@pytest.mark.parametrize("key", ["hw1", "HW01", "homework 1"])
def test_an_assignment_has_the_names_that_it_has_elsewhere(tmp_path, key):
    actual = policies(tmp_path / "course.toml", {key: {"extension": {"ann": 1}}}, ["hw01_pendulum", "hw10_disk"])
    assert [dict(policy.extension) for policy in actual.values()] == [{"ann": 1}, {}]
