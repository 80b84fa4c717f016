"""by_hand.csv as somebody may have edited it in a spreadsheet."""

import csv

import pytest

from tam570_grader import cli
from tam570_grader.results import manual_points
from tam570_grader.results.manual_points import Entry, ManualAdjustments

SLUG = "hw08_axis_angle"


def edited(folder, *rows):
    folder.mkdir(exist_ok=True)
    (folder / "by_hand.csv").write_text("\n".join([",".join(manual_points.COLUMNS), *rows]) + "\n")


@pytest.mark.parametrize("item", [*manual_points.WORDS, "skew_is_the_cross_product"])
def test_a_row_without_points_takes_back_what_there_was(tmp_path, item):
    edited(tmp_path, f"ada,{SLUG},{item},1,,why", f"ada,{SLUG},{item},,,why")
    assert not manual_points.read(tmp_path).entries


def test_a_word_has_no_most_and_adds_none(tmp_path):
    edited(tmp_path, f"ada,{SLUG},adjust,1,10,why", f"ben,{SLUG},adjust,,10,why")
    hand = manual_points.read(tmp_path)
    found = [hand.adjust((who, SLUG), 8.0, 10.0, dict) for who in ("ada", "ben")]
    assert [(one.score, one.most) for one in found] == [(9.0, 10.0), (8.0, 10.0)]


@pytest.mark.parametrize("item", ["adjust", "total"])
def test_grading_and_the_report_go_on(tree, tmp_path, capsys, item):
    out = tmp_path / "out"
    edited(out, f"ada,{SLUG},{item},,,Nothing yet.")
    assert cli.main(["grade", str(tree), "--out", str(out), "--seed", "1"]) == 0
    assert cli.main(["report", str(out)]) == 0
    assert "Traceback" not in capsys.readouterr().err
    with open(out / "grades.csv", newline="") as file:
        assert {row["student"]: row["score"] for row in csv.DictReader(file)}["ada"] == "10.0"


HW = ("hw01_a", "hw02_b", "hw03_c")


def adjusted(*entries):
    """Scores of ten points in three assignments, two days late in each, half a point off a day."""
    made = ManualAdjustments(
        [
            *(Entry("ann", slug, "late", 2.0) for slug in HW),
            Entry("*", "*", "off a day", 0.1),
            *(Entry(*one) for one in entries),
        ]
    )
    rows = [("ann", slug, "graded", 10.0 - n, 10.0) for n, slug in enumerate(HW)]
    return [row[3] for row in made.table(made.row(row, dict) for row in rows)]


def test_rows_of_the_term_hold_in_every_assignment():
    assert adjusted() == pytest.approx([8.0, 7.2, 6.4])
    assert adjusted(("ann", "*", "extension", 2.0)) == [10.0, 9.0, 8.0]
    assert adjusted(("ben", "*", "extension", 2.0)) == pytest.approx([8.0, 7.2, 6.4])
    assert adjusted(("*", "*", "slip days", 3.0)) == pytest.approx([10.0, 8.1, 6.4])  # in their order
    assert adjusted(("*", "*", "slip days", 3.0), ("ann", HW[0], "extension", 1.0)) == pytest.approx([10.0, 9.0, 6.4])
    assert adjusted(("*", "*", "drop lowest", 1.0))[2] == "EX" and adjusted(("*", "*", "drop lowest", 9.0))[0] == 8.0
    assert adjusted(("ann", HW[1], "excused", 1.0, None, "She was ill."))[1] == "EX"
