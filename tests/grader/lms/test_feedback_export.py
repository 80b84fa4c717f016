"""Pages go back by the names that Canvas and Moodle gave to the files of a download."""

import re
import zipfile

import pytest

from tam570_grader import cli

SLUG = "hw08_axis_angle"
HEADING = "student,name,assignment,file,when,late,from,note\n"
COLLECTED = {
    "canvas": [
        f"ann,,{SLUG},{SLUG}.py,,,adamsann_17_600_hw08_axis_angle-2.py,",
        f"ann,,{SLUG},,,,adamsann_17_500_hw08_axis_angle.py,older",
        f"bo,,{SLUG},{SLUG}.py,,LATE,all/brownbo_LATE_18_550_hw08.zip/mine/hw08.py,",
    ],
    "moodle": [
        f"ann,,{SLUG},{SLUG}.py,,,Ann Adams_17_assignsubmission_file/hw08.py,",
        f"bo,,{SLUG},{SLUG}.py,,,Bo Brown_18_assignsubmission_file_hw08.py,",
    ],
}


@pytest.fixture
def hand_back(tmp_path):
    """`hand_back(system, rows, *more)` -> exit code and name: text of what is in the zip file."""
    (tmp_path / "grades.csv").write_text(
        f"student,assignment,status,score,max_score\nann,{SLUG},graded,9,10\nbo,{SLUG},graded,8,10\n"
    )
    for student in ("ann", "bo"):
        (tmp_path / "feedback" / student).mkdir(parents=True)
        (tmp_path / "feedback" / student / f"{SLUG}.html").write_text(f"page of {student}")

    def hand_back(system, rows, *more):
        (tmp_path / "collected.csv").write_text(HEADING + "".join(f"{row}\n" for row in rows))
        where = [str(tmp_path / name) for name in ("grades.csv", "pages.zip", "collected.csv", "table.csv")]
        options = ["--pages", where[1], "--collected", where[2], "--out", where[3]]
        code = cli.main(["lms", where[0], "--to", system, *options, *more])
        if not (tmp_path / "pages.zip").exists():
            return code, {}
        with zipfile.ZipFile(tmp_path / "pages.zip") as archive:
            return code, {name: archive.read(name).decode() for name in archive.namelist()}

    return hand_back


def test_canvas_tells_student_and_attachment(hand_back):
    code, found = hand_back("canvas", COLLECTED["canvas"])
    assert code == 0 and found == {
        f"adamsann_17_600_{SLUG}.html": "page of ann",
        f"brownbo_LATE_18_550_{SLUG}.html": "page of bo",
    }
    users = [re.findall(r"(?<=_)\d+(?=_)", name)[:2] for name in found]
    assert users == [["17", "600"], ["18", "550"]]


def test_moodle_tells_the_participant(hand_back):
    code, found = hand_back("moodle", COLLECTED["moodle"])
    assert code == 0 and [name.split("_", 4)[1:] for name in found] == [
        ["17", "assignsubmission", "file", f"{SLUG}.html"],
        ["18", "assignsubmission", "file", f"{SLUG}.html"],
    ]


def test_a_page_goes_to_who_handed_in_whatever_the_file_is_named(hand_back):
    file = "Ann Adams_17_assignsubmission_file_Bo Brown_18_assignsubmission_file_hw08.py"
    code, found = hand_back("moodle", [f"ann,,{SLUG},{SLUG}.py,,,{file},"])
    assert code == 0 and found == {f"Ann Adams_17_assignsubmission_file_{SLUG}.html": "page of ann"}


def test_a_student_without_a_page_is_named(hand_back, tmp_path, capsys):
    (tmp_path / "feedback" / "bo" / f"{SLUG}.html").unlink()
    code, found = hand_back("canvas", COLLECTED["canvas"])
    assert code == 1 and len(found) == 1 and "bo has no page" in capsys.readouterr().err


def test_names_of_another_system_are_refused(hand_back, capsys):
    assert hand_back("canvas", COLLECTED["moodle"]) == (2, {})
    assert "is --to right?" in capsys.readouterr().err


OTHER = "ann,,hw07_x,hw07_x.py,,,Ann Adams_17_assignsubmission_file/hw07.py,"


def test_a_zip_file_holds_the_pages_of_one_assignment(hand_back, tmp_path, capsys):
    (tmp_path / "grades.csv").write_text(
        f"student,assignment,status,score,max_score\nann,hw07_x,graded,9,10\nann,{SLUG},graded,9,10\n"
    )
    assert hand_back("moodle", [*COLLECTED["moodle"], OTHER]) == (2, {})
    assert f"choose with --only: hw07_x, {SLUG}" in capsys.readouterr().err
    code, found = hand_back("moodle", [*COLLECTED["moodle"], OTHER], "--only", "hw08")
    assert code == 0 and len(found) == 2 and all(SLUG in name for name in found)


NBGRADER = """assignment,duedate,timestamp,student_id,raw_score,score,max_score
hw07_x,,2026-02-03,ann,9,9.0,12
hw07_x,,,bo,0,0.0,12
hw08_x,,,ann,0,0.0,10
hw08_x,,,bo,0,0.0,10
"""


def test_what_nobody_handed_in_is_blank_and_only_takes_some(tmp_path, capsys):
    (tmp_path / "grades.csv").write_text(NBGRADER)
    command = ["lms", str(tmp_path / "grades.csv"), "--to", "moodle"]
    assert cli.main(command) == 0
    assert capsys.readouterr().out.splitlines() == ["Username,hw07_x,hw08_x", "ann,9.0,", "bo,0.0,"]
    assert cli.main([*command, "--only", "hw07"]) == 0
    assert capsys.readouterr().out.splitlines() == ["Username,hw07_x", "ann,9.0", "bo,0.0"]
    assert cli.main([*command, "--only", "hw7"]) == 0
    assert capsys.readouterr().out.splitlines() == ["Username,hw07_x", "ann,9.0", "bo,0.0"]
    assert cli.main([*command, "--only", "hw09"]) == 2


def test_only_hw1_is_not_hw10(tmp_path, capsys):
    (tmp_path / "grades.csv").write_text("student,assignment,score,max_score\nann,hw01_x,1,10\nann,hw10_x,2,10\n")
    command = ["lms", str(tmp_path / "grades.csv"), "--to", "moodle", "--only"]
    assert cli.main([*command, "hw1"]) == 0
    assert capsys.readouterr().out.splitlines() == ["Username,hw01_x", "ann,1"]


OURS = """student,assignment,status,score,max_score
ann,hw07_x,graded,0.0,12.0
bo,hw07_x,missing,0.0,12.0
cy,hw07_x,missing,8.0,12.0
"""


@pytest.mark.parametrize(("table", "absent"), [(OURS, "bo"), (NBGRADER, "bo")])
def test_who_is_absent_has_zero_or_a_blank(tmp_path, capsys, table, absent):
    (tmp_path / "grades.csv").write_text(table)
    command = ["lms", str(tmp_path / "grades.csv"), "--to", "moodle", "--only", "hw07"]
    assert cli.main(command) == 0
    zero = capsys.readouterr().out.splitlines()
    assert cli.main([*command, "--absent", "blank"]) == 0
    assert f"{absent},0.0" in zero  # unless it is asked for, a row of who handed in nothing is a zero
    assert capsys.readouterr().out.splitlines() == [f"{absent}," if row == f"{absent},0.0" else row for row in zero]
