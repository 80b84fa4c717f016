"""Late work by the rules of course.toml: dates, days, extensions, successive downloads, and contradictions."""

import re

import pytest
from classes import HW08

from tam570_grader.course.late_policy import policies

HW07 = "hw07_double_pendulum"
COURSE = """
[late]
off_a_day = 0.1
most_off = 0.25
grace = 15

[hw07]
due = 2026-09-07T23:59:00

[hw08]
due = 2026-09-14T23:59:00

[hw08.extension]
cas = 2
"""
# student: (time when the file came, points left of ten)
CAME = {
    "ann": ("2026-09-14 23:58:00", 10),
    "ben": ("2026-09-15 00:13:00", 10),  # within the grace period
    "cas": ("2026-09-16 20:00:00", 10),  # within the extension of two days
    "dan": ("2026-09-15 00:15:00", 9),  # a day that has begun counts
    "eve": ("2026-09-16 00:13:00", 9),  # the grace period applies to each day
    "fay": ("2026-10-30 00:00:00", 7.5),  # at most a quarter is taken off
}
STUB = "def rotate(r, axis, angle):\n    raise NotImplementedError\n"
NOTEBOOK = '{"cells": [{"cell_type": "code", "source": ["def rotate(r, axis, angle):\\n"]}], "nbformat": 4}'
BEGUN = "def rotate(r, axis, angle):\n    return r\n"


@pytest.fixture
def term(desk):
    """Return the desk of a trusted course, with results of ten points and the times of the files."""
    desk.trust(COURSE)
    desk.write_results(dict.fromkeys(((student, HW08) for student in CAME), 10.0))
    write_collected(desk, [(student, when, "") for student, (when, _) in CAME.items()])
    return desk


def write_collected(desk, came):
    lines = [f"{student},,{HW08},{HW08}.py,{when},{late},{HW08}.py," for student, when, late in came]
    desk.write("collected.csv", "\n".join(["student,name,assignment,file,when,late,from,note", *lines]))


def points(desk, *lines):
    """Run the command `points`, with a table of these rows if there are any."""
    desk.write("points.csv", "\n".join(["student,assignment,item,points,comment", *lines]))
    return desk("points", "results", *["points.csv"] * bool(lines), "--collected", "collected.csv")


def test_tables_and_pages_obey(term):
    assert points(term)[0] == 0
    assert term.scores() == {student: rest for student, (_, rest) in CAME.items()}
    page = (term.folder / "results" / "feedback" / "fay" / f"{HW08}.html").read_text()
    assert "7.5 of 10 points" in page and "25 %" in page
    for command in (["report", "results"], ["lms", "results/grades.csv", "--to", "moodle", "--out", "up.csv"]):
        code, printed = term(*command)
        assert code == 0 and "warning" not in printed
    assert ["fay", "7.5"] in term.read("up.csv")


def test_the_report_counts_who_is_late_and_sums_what_counts(term):
    term.write_results({(student, HW07): 4.0 for student in CAME})
    rows = ["*,*,drop lowest,1,", "ann,hw08,excused,1,She was ill.", "dan,*,extension,1,"]
    assert points(term, *rows)[0] == 0
    term.write("roster.csv", [("Username", "Name"), *((student, student.title()) for student in CAME)])
    assert term("report", "results", "--roster", "roster.csv", "--collected", "collected.csv")[0] == 0
    page = (term.folder / "results" / "report.html").read_text()
    sums = dict(re.findall(r"<tr><th scope=row>([^<]*)</th>.*<td>([\d.]*)</td></tr>", page))
    rest = {student: rest for student, (_, rest) in CAME.items()} | {"ann": 4, "dan": 10}  # ann's only score counts
    assert {student: float(total) for student, total in sums.items()} == rest
    cells = re.search(r'<th scope="row">hw08</th>(.*?)<svg', page)[1]
    assert re.findall(r'class="n">(\d+)<', cells)[-1] == "4"  # all except ann and ben


def test_changed_terms_are_told_until_they_are_obeyed(term):
    assert points(term)[0] == 0
    term.write("course.toml", COURSE.replace("0.1", "0.2").replace("cas = 2", "dan = 1").replace("-14T", "-15T"))
    for command in (["report", "results"], ["lms", "results/grades.csv", "--to", "moodle"]):
        code, printed = term(*command)
        assert code == 0 and "tam570-grader points results --collected collected.csv" in printed
    assert points(term)[0] == 0
    assert term.scores() == {"ann": 10, "ben": 10, "cas": 8, "dan": 10, "eve": 10, "fay": 7.5}
    term.write("course.toml", "")
    assert points(term)[0] == 0 and set(term.scores().values()) == {10.0}


def test_a_row_by_hand_counts_in_the_place_of_the_time(term):
    for rows in (["fay,hw08,late,1,It came by mail."], []):
        assert points(term, *rows)[0] == 0 and term.scores()["fay"] == 9.0


@pytest.mark.parametrize("row", ["*,hw08,off a day,.5,", "cas,hw08,extension,1,"])
def test_what_disagrees_is_named_and_nothing_is_written(term, row):
    code, printed = points(term, row)
    assert code == 2 and "in course.toml" in printed and not (term.folder / "results" / "by_hand.csv").exists()


def test_whose_time_is_not_known_is_named(term):
    write_collected(term, [("ann", "", ""), ("ben", "", "LATE")])
    code, printed = points(term)
    assert code == 1 and "ben is late" in printed and "ann is late" not in printed
    write_collected(term, [("ann", "2026-09-16T04:59:00 UTC", ""), ("ben", "yesterday", "")])
    code, printed = points(term)
    assert code == 2 and "'yesterday'" in printed


@pytest.mark.parametrize(
    ("text", "words"),
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
def test_what_does_not_fit_is_named_with_its_key(term, text, words):
    term.write("course.toml", text)
    code, printed = points(term)
    assert code == 2 and words in printed


@pytest.mark.parametrize("key", ["hw1", "HW01", "homework 1"])
def test_an_assignment_has_the_names_that_it_has_elsewhere(tmp_path, key):
    actual = policies(tmp_path / "course.toml", {key: {"extension": {"ann": 1}}}, ["hw01_pendulum", "hw10_disk"])
    assert [dict(policy.extension) for policy in actual.values()] == [{"ann": 1}, {}]


@pytest.fixture
def download(desk, download):
    """`download((student, file, day, text), ...)` -> (exit code, output) of `collect` with Blackboard's download."""
    desk.trust(COURSE.partition("[hw08.extension]")[0])

    def from_blackboard(*came):
        files = {f"HW_{who}_attempt_2026-09-{day:02}-12-00-00_{file}": text for who, file, day, text in came}
        return download("blackboard", files)

    return from_blackboard


def test_the_next_homework_leaves_the_rows_and_late_days_of_the_last(desk, download):
    assert download(("ann", "hw07.py", 6, "x"), ("ben", "hw07.py", 9, "x"))[0] == 0
    assert download(("ann", "hw08.py", 16, "x"), ("ben", "hw08.py", 13, "x"))[0] == 0
    desk.write_results({(row["student"], row["assignment"]): 10.0 for row in desk.rows("collected.csv")})
    assert points(desk)[0] == 0
    assert (desk.scores(HW07), desk.scores(HW08)) == ({"ann": 10, "ben": 8}, {"ann": 8, "ben": 10})


def test_what_is_collected_again_replaces_its_row_and_no_other(desk, download):
    download(("ann", "hw07.py", 6, "first"), ("ben", "hw07.py", 6, ""))
    download(("ann", "hw07.py", 9, "second"))
    days = {row["student"]: row["when"][:10] for row in desk.rows("collected.csv")}
    assert days == {"ann": "2026-09-09", "ben": "2026-09-06"}
    assert [path.read_text() for path in desk.folder.glob("submitted/ann/*/*")] == ["second"]


@pytest.mark.parametrize(
    ("module", "day", "code", "late"),
    [(BEGUN, 12, 1, ["ben"]), (BEGUN, 16, 0, ["ann", "ben"]), (STUB, 12, 0, ["ann", "ben"])],
)
def test_the_time_of_what_is_graded_counts_and_a_newer_notebook_is_named(desk, download, module, day, code, late):
    """A late notebook beside a module costs days only if the notebook is graded."""
    ann = ("ann", "hw08.py", day, module), ("ann", "hw08.ipynb", 16, NOTEBOOK)
    actual, printed = download(*ann, ("ben", "hw08.py", 16, "x = 1\n"))
    assert actual == code and ("hw08.ipynb of ann is newer than submitted/ann/" in printed) == bool(code)
    assert desk("grade", "submitted", "--out", "results", "--seed", "1")[0] == points(desk)[0] == 0
    days = {row["student"]: float(row["points"]) for row in desk.rows("results/by_hand.csv") if row["item"] == "late"}
    assert days == {student: pytest.approx(1.5, abs=0.02) for student in late}
