"""Rosters as Canvas, Moodle and Gradescope export them, and plain lists."""

import pytest

from tam570_grader.grading.roster import Directory, people, students

CANVAS = """Student,ID,SIS User ID,SIS Login ID,Section,hw07_double_pendulum (4711),Final Score
,,,,,Manual Posting,
    Points Possible,,,,,10,(read only)
"Adams, Ann",17,A1,aadams,570,,
"Brown, Bo",18,A2,bbrown,"570, evening",,
"Student, Test",99,,f00,570,,
"""
MOODLE = """"First name",Surname,Username,"ID number","Email address"
Ann,Adams,aadams,A1,ann@x.edu
Bo,Brown,bbrown,A2,bo@x.edu
"""
WORKSHEET = """Identifier;"Full name";"Email address";Status;Grade
"Participant 17";"Ann Adams";aadams;Submitted;
"Participant 18";"Bo Brown";bbrown;Submitted;
"""
GRADESCOPE = (
    "First Name,Last Name,SID,Email,Role\nAnn,Adams,aadams,ann@x.edu,Student\nBo,Brown,bbrown,bo@x.edu,Student\n"
)
NBGRADER = "id,first_name,last_name,email\naadams,Ann,Adams,a@x\nbbrown,Bo,Brown,b@x\n"


@pytest.mark.parametrize(
    "text", [CANVAS, MOODLE, WORKSHEET, GRADESCOPE, NBGRADER, "aadams\nbbrown\n", "student\naadams\nbbrown\n"]
)
def test_students_are_rows_and_nobody_else_is(tmp_path, text):
    (tmp_path / "roster.csv").write_text("\ufeff" + text, encoding="utf-8")
    assert students(tmp_path / "roster.csv") == ["aadams", "bbrown"]


def test_a_worksheet_is_joined_by_participant(tmp_path):
    (tmp_path / "roster.csv").write_text(WORKSHEET)
    actual = Directory(people(tmp_path / "roster.csv"))
    assert actual.owner([("participant", "18")], "Bo Brown", must_agree=True).name == "Bo Brown"
    assert "whose name is another" in actual.owner([("participant", "18")], "Team 18", must_agree=True)


def test_what_two_share_tells_neither(tmp_path):
    (tmp_path / "roster.csv").write_text("Username,First name,Surname\nli1,Li,Wu\nli2,Li,Wu\n")
    actual = Directory(people(tmp_path / "roster.csv"))
    assert actual.owner([("participant", "5")], "Li Wu", must_agree=True) == ""
    assert actual.owner([("login", "li2")], "Li Wu", must_agree=True).folder == "li2"
