"""Pages go back by the names that Canvas and Moodle gave to the files of a download."""

import zipfile

import pytest
from classes import HW08 as SLUG

HEADING = "student,name,assignment,file,when,late,from,note\n"
CANVAS = [
    f"ann,,{SLUG},{SLUG}.py,,,adamsann_17_600_hw08_axis_angle-2.py,",
    f"ann,,{SLUG},,,,adamsann_17_500_hw08_axis_angle.py,older",
    f"bo,,{SLUG},{SLUG}.py,,LATE,all/brownbo_LATE_18_550_hw08.zip/mine/hw08.py,",
]
MOODLE = [
    f"ann,,{SLUG},{SLUG}.py,,,Ann Adams_17_assignsubmission_file_Bo Brown_18_assignsubmission_file_hw08.py,",
    f"bo,,{SLUG},{SLUG}.py,,,Bo Brown_18_assignsubmission_file/hw08.py,",
]


@pytest.fixture
def hand_back(desk):
    """`hand_back(system, rows, *more)` -> exit code, and name: text of what is in the zip file."""
    desk.write_grades({"ann": 9, "bo": 8})
    for student in ("ann", "bo"):
        (desk.folder / "feedback" / student).mkdir(parents=True)
        desk.write(f"feedback/{student}/{SLUG}.html", f"page of {student}")

    def hand_back(system, rows, *more):
        desk.write("collected.csv", HEADING + "".join(f"{row}\n" for row in rows))
        pages = ["--pages", "pages.zip", "--collected", "collected.csv", "--out", "table.csv"]
        code, _ = desk("lms", "grades.csv", "--to", system, *pages, *more)
        if not (desk.folder / "pages.zip").exists():
            return code, {}
        with zipfile.ZipFile("pages.zip") as archive:
            return code, {name: archive.read(name).decode() for name in archive.namelist()}

    return hand_back


@pytest.mark.parametrize(
    ("system", "rows", "ann", "bo"),
    [
        ("canvas", CANVAS, f"adamsann_17_600_{SLUG}.html", f"brownbo_LATE_18_550_{SLUG}.html"),
        ("moodle", MOODLE, *(f"{who}_assignsubmission_file_{SLUG}.html" for who in ("Ann Adams_17", "Bo Brown_18"))),
    ],
)
def test_a_page_goes_to_who_handed_in(hand_back, desk, system, rows, ann, bo):
    assert hand_back(system, rows) == (0, {ann: "page of ann", bo: "page of bo"})
    (desk.folder / "pages.zip").unlink()
    assert hand_back(system, MOODLE if rows is CANVAS else CANVAS) == (2, {})
    (desk.folder / "feedback" / "bo" / f"{SLUG}.html").unlink()
    assert hand_back(system, rows) == (1, {ann: "page of ann"})


def test_a_zip_file_holds_the_pages_of_one_assignment(hand_back, desk):
    rows = [*MOODLE, "ann,,hw07_x,hw07_x.py,,,Ann Adams_17_assignsubmission_file/hw07.py,"]
    grades = f"student,assignment,status,score,max_score\nann,hw07_x,graded,9,10\nann,{SLUG},graded,9,10\n"
    desk.write("grades.csv", grades)
    assert hand_back("moodle", rows) == (2, {})
    code, actual = hand_back("moodle", rows, "--only", "hw08")
    assert code == 0 and len(actual) == 2 and all(SLUG in name for name in actual)


NBGRADER = """assignment,duedate,timestamp,student_id,raw_score,score,max_score
hw01_x,,2026-02-03,ann,9,9.0,12
hw01_x,,,bo,0,0.0,12
hw10_x,,,ann,0,0.0,10
hw10_x,,,bo,0,0.0,10
"""
OURS = """student,assignment,status,score,max_score
ann,hw01_x,graded,0.0,12.0
bo,hw01_x,missing,0.0,12.0
cy,hw01_x,missing,8.0,12.0
"""


@pytest.mark.parametrize(
    ("table", "more", "lines"),
    [
        (NBGRADER, [], ["Username,hw01_x,hw10_x", "ann,9.0,", "bo,0.0,"]),  # nobody handed in hw10
        (NBGRADER, ["--only", "hw1"], ["Username,hw01_x", "ann,9.0", "bo,0.0"]),
        (NBGRADER, ["--only", "hw1", "--absent", "blank"], ["Username,hw01_x", "ann,9.0", "bo,"]),
        (OURS, [], ["Username,hw01_x", "ann,0.0", "bo,0.0", "cy,8.0"]),
        (OURS, ["--absent", "blank", "--identity", "email"], ["Email address,hw01_x", "ann,0.0", "bo,", "cy,8.0"]),
    ],
)
def test_who_is_absent_has_zero_or_a_blank(desk, table, more, lines):
    desk.write("grades.csv", table)
    assert desk("lms", "grades.csv", "--to", "moodle", "--out", "up.csv", *more)[0] == 0
    assert (desk.folder / "up.csv").read_text().splitlines() == lines
