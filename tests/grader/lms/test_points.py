"""Points by hand: all tables and pages have them, regrading keeps them, and a table with a wrong row changes none."""

import shutil

import pytest
from classes import HW08, hand_in, rows

from tam570_grader import cli
from tam570_grader.cli import points as command
from tam570_grader.results import manual_points
from tam570_grader.results.manual_points import Entry, GradeRow, ManualAdjustments
from tam570_grader.results.store import ResultStore

SLUG = "hw07_double_pendulum"
TERM = ("hw01_a", "hw02_b", "hw03_c")


@pytest.fixture(scope="module")
def graded_stubs(tmp_path_factory, course):
    """Return a folder with the stubs that ann and ben handed in, and their results."""
    folder, stub = tmp_path_factory.mktemp("points"), course / "assignments" / SLUG / f"{SLUG}.py"
    hand_in(folder / "submitted", dict.fromkeys(("ann", "ben"), stub.read_text()), SLUG)
    graded(folder)
    return folder


@pytest.fixture
def results(tmp_path, graded_stubs):
    """Return a copy of the results of ann and ben for one test."""
    shutil.copytree(graded_stubs, tmp_path, dirs_exist_ok=True)
    return tmp_path / "results"


def graded(folder):
    assert cli.main(["grade", str(folder / "submitted"), "--out", str(folder / "results"), "--seed", "1"]) == 0


def points(results, *lines):
    table = results.parent / "points.csv"
    table.write_text("\n".join(["student,assignment,item,points,comment", *lines]) + "\n")
    return cli.main(["points", str(results), str(table)])


def scores(results):
    return {row["student"]: (row["score"], row["max_score"]) for row in rows(results / "grades.csv")}


def test_everything_has_the_points(results, capsys):
    assert points(results, 'ann,hw07,c,1.5,"Nice, but short."', "ben,hw07,adjust,3,The file came by mail.") == 0
    assert scores(results) == {"ann": ("1.5", "12.0"), "ben": ("3.0", "12.0")}
    page = (results / "feedback" / "ann" / f"{SLUG}.html").read_text()
    assert "1.5 of 12 points" in page and "1.5 of 2 points, by hand. Nice, but short." in page
    page = (results / "feedback" / "ben" / f"{SLUG}.html").read_text()
    assert "3 of 12 points" in page and "The file came by mail." in page
    assert cli.main(["report", str(results)]) == 0
    assert "<td>1.5<td>1.5" in (results / "report.html").read_text()
    capsys.readouterr()
    assert cli.main(["lms", "--ungraded", "zero", str(results / "grades.csv"), "--to", "canvas"]) == 0
    assert "12.0" in capsys.readouterr().out


def test_a_check_has_the_points_given_by_hand_whatever_it_earned_and_keeps_them(results, solution_text):
    points(results, "ann,hw07,wireframe_shows_the_bars,.25,It was right on paper.", "ben,hw07,c,1,")
    assert scores(results) == {"ann": ("0.25", "12.0"), "ben": ("1.0", "12.0")}
    assert "0.25 points, by hand: It was right on paper." in (results / "feedback/ann" / f"{SLUG}.html").read_text()
    hand_in(results.parent / "submitted", {"ann": solution_text(SLUG)}, SLUG)
    graded(results.parent)
    assert scores(results) == {"ann": ("9.75", "12.0"), "ben": ("1.0", "12.0")}


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ("ann,hw07,c,3,", "from 0 to 2 points, not 3"),
        ("ann,hw07,c,nan,", "'nan', not a number"),
        ("ann,hw07,q,1,", "there is no item 'q'; the parts graded by hand are c"),
        ("ann,hw08,c,1,", "no results of an assignment 'hw08'"),
        ("zoe,hw07,c,1,", "no results of a student 'zoe'"),
        ("*,hw07,c,1,", "one student's"),
        ("ann,hw07,total,1,", "needs a reason"),
        ("ann,hw07,late,-1,", "no negative number"),
        ("*,hw07,off a day,10,", "from 0 to 1"),
        ("ann,hw07,wireframe_shows_the_bars,.6,why", "from 0 to 0.5 points, not 0.6"),
        ("ann,hw07,wireframe_shows_bars,.5,why", "do you mean the check wireframe_shows_the_bars?"),
        ("ann,hw07", ""),
    ],
)
def test_a_wrong_row_is_named_and_nothing_is_written(results, capsys, row, words):
    assert points(results, "ben,hw07,c,1,", row) == 2
    assert words in (err := capsys.readouterr().err) and "line 3" in err
    assert not (results / "by_hand.csv").exists() and scores(results)["ben"] == ("0.0", "10.0")


def test_a_row_that_somebody_else_adds_meanwhile_stays(results, monkeypatch):
    def opened(folder):
        """Write a row as another command does, then open the store."""
        manual_points.write(folder, ManualAdjustments([Entry("ben", SLUG, "adjust", 2.0, None, "It came by mail.")]))
        return ResultStore(folder)

    monkeypatch.setattr(command, "ResultStore", opened)
    assert points(results, "ann,hw07,c,1,") == 0
    assert scores(results) == {"ann": ("1.0", "12.0"), "ben": ("2.0", "12.0")}


def test_joined_results_bring_their_points(results, tmp_path):
    points(results, "ann,hw07,c,1,", 'ben,hw07,c,"1,5",')
    command = ["grade", str(tmp_path / "submitted"), "--out", str(tmp_path / "all"), "--join"]
    assert cli.main([*command, str(results / "results.jsonl")]) == 0
    points(tmp_path / "all", "ann,hw07,c,2,")
    assert cli.main([*command, str(results)]) == 0
    assert scores(tmp_path / "all") == {"ann": ("2.0", "12.0"), "ben": ("1.5", "12.0")}


def test_the_template_has_a_row_for_each_part_with_what_is_known(results, capsys):
    points(results, "ann,hw07,c,1.5,so so")
    fill = ["points", str(results), str(results / "fill.csv")]
    assert cli.main([*fill[:-1], "--template", fill[-1]]) == 0 and " ".join(fill) in capsys.readouterr().out
    filled = [(row["student"], row["item"], row["points"], row["of"]) for row in rows(results / "fill.csv")]
    assert filled == [("ann", "c", "1.5", "2"), ("ben", "c", "", "2")]
    assert cli.main(fill) == 0 and scores(results)["ann"] == ("1.5", "12.0")  # unchanged, it changes no score
    assert cli.main([*fill, "--template"]) == 2  # an existing table is not overwritten


def test_a_template_without_parts_is_no_table(desk):
    desk.write_results({("ann", HW08): 10.0})
    code, printed = desk("points", "results", "fill.csv", "--template")
    assert code == 2 and "graded by hand" in printed and not (desk.folder / "fill.csv").exists()


def test_a_row_that_takes_points_back_is_named(results, capsys):
    """The template of somebody who grades other students has empty cells for these."""
    points(results, "ann,hw07,c,1.5,")
    assert points(results, "ann,hw07,c,,", "ben,hw07,c,2,") == 0
    assert "c of ann in hw07_double_pendulum had 1.5" in capsys.readouterr().err


def test_late_days_that_cost_nothing_are_warned_of(results, capsys):
    assert points(results, late := "ann,hw07,late,1,") == 0 and "cost nothing" in capsys.readouterr().err
    assert points(results, late, "*,hw07,off a day,.1,") == 0 and "cost nothing" not in capsys.readouterr().err


@pytest.mark.parametrize(
    ("score", "items", "rest"),
    [
        (8.0, {"late": 0.5, "off_a_day": 0.1}, 7.2),  # a day that has begun counts
        (8.0, {"late": 20, "off_a_day": 0.1}, 0.0),
        (None, {"late": 1, "off_a_day": 0.1}, None),
        (8.0, {"late": 3, "off_a_day": 0.5, "adjust": 1, "total": 9}, 9.0),  # replaces all other items
        (None, {"total": 9}, 9.0),
        (0.5, {"adjust": -2}, 0.0),
    ],
)
def test_days_beyond_an_extension_cost_their_share_and_a_total_stands_for_all(score, items, rest):
    entries = [Entry("ann", SLUG, item.replace("_", " "), points, None, "why") for item, points in items.items()]
    adjusted = ManualAdjustments(entries).adjust(GradeRow("ann", SLUG, "graded", score, 10.0), dict).score
    assert adjusted == (rest if rest is None else pytest.approx(rest))


@pytest.mark.parametrize(
    ("rows", "rest"),
    [
        ([], [8.0, 7.2, 6.4]),
        ([("ann", "*", "extension", 2.0)], [10.0, 9.0, 8.0]),
        ([("ben", "*", "extension", 2.0)], [8.0, 7.2, 6.4]),
        ([("*", "*", "slip days", 3.0)], [10.0, 8.1, 6.4]),  # used in the order of the assignments
        ([("*", "*", "slip days", 3.0), ("ann", TERM[0], "extension", 1.0)], [10.0, 9.0, 6.4]),
        ([("*", TERM[0], "extension", 1.0), ("ann", TERM[0], "extension", 2.0)], [10.0, 7.2, 6.4]),
        ([("*", "*", "drop lowest", 1.0)], [8.0, 7.2, "EX"]),
        ([("ann", TERM[1], "excused", 1.0, None, "She was ill.")], [8.0, "EX", 6.4]),
    ],
)
def test_rows_of_the_term_hold_in_every_assignment(rows, rest):
    """Ann's scores are 10, 9 and 8, each two days late; each day takes off a tenth of the score."""
    late = [Entry("ann", slug, "late", 2.0) for slug in TERM]
    adjustments = ManualAdjustments([*late, Entry("*", "*", "off a day", 0.1), *(Entry(*row) for row in rows)])
    graded = (GradeRow("ann", slug, "graded", 10.0 - n, 10.0) for n, slug in enumerate(TERM))
    table = adjustments.table(adjustments.row(row, dict) for row in graded)
    assert [row[3] for row in table] == [score if score == "EX" else pytest.approx(score) for score in rest]


@pytest.mark.parametrize(("row", "code"), [("adjust,1", 1), ("total,9", 0), ("excused,1", 0), ("c,2", 0)])
def test_lms_stops_for_a_part_that_nobody_graded_where_the_score_depends_on_it(results, row, code):
    assert points(results, "ann,hw07,c,1,", f"ben,hw07,{row},why") == 0
    assert cli.main(["lms", str(results), "--to", "moodle"]) == code


@pytest.mark.parametrize("item", [*manual_points.WORDS, "skew_is_the_cross_product"])
def test_a_row_without_points_takes_back_what_there_was(tmp_path, item):
    lines = [",".join(manual_points.COLUMNS), f"ada,{SLUG},{item},1,,why", f"ada,{SLUG},{item},,,why"]
    (tmp_path / "by_hand.csv").write_text("\n".join(lines) + "\n")
    assert not manual_points.read(tmp_path).entries
