"""Points by hand: every table and page has them, grading again keeps them, and a wrong row changes nothing."""

import csv
import re
import shutil

import pytest

from tam570_grader import cli
from tam570_grader.lms import points as command
from tam570_grader.results import manual_points
from tam570_grader.results.manual_points import Entry, ManualAdjustments
from tam570_grader.results.store import ResultStore

SLUG = "hw07_double_pendulum"
HEADING = "student,assignment,item,points,comment\n"


@pytest.fixture(scope="module")
def graded_stubs(tmp_path_factory, course):
    """What ann and ben handed in, stubs, and the results."""
    place, stub = tmp_path_factory.mktemp("points"), course / "assignments" / SLUG / f"{SLUG}.py"
    for student in ("ann", "ben"):
        folder = place / "submitted" / student / SLUG
        folder.mkdir(parents=True)
        shutil.copy(stub, folder)
    graded(place)
    return place


@pytest.fixture
def results(tmp_path, graded_stubs):
    """The results of ann and ben, of the test's own."""
    shutil.copytree(graded_stubs, tmp_path, dirs_exist_ok=True)
    return tmp_path / "results"


def graded(folder):
    assert cli.main(["grade", str(folder / "submitted"), "--out", str(folder / "results"), "--seed", "1"]) == 0


def points(results, *rows):
    table = results.parent / "points.csv"
    table.write_text(HEADING + "".join(f"{row}\n" for row in rows))
    return cli.main(["points", str(results), str(table)])


def scores(results):
    rows = csv.DictReader((results / "grades.csv").read_text().splitlines())
    return {row["student"]: (row["score"], row["max_score"]) for row in rows}


def test_everything_has_the_points(results, capsys):
    assert points(results, 'ann,hw07,c,1.5,"Nice, but short."', "ben,hw07,adjust,3,The file came by mail.") == 0
    assert scores(results) == {"ann": ("1.5", "12.0"), "ben": ("3.0", "12.0")}
    page = (results / "feedback" / "ann" / f"{SLUG}.html").read_text()
    assert "1.5 of 12 points" in page and "Part (c): 1.5 of 2 points, by hand. Nice, but short." in page
    page = (results / "feedback" / "ben" / f"{SLUG}.html").read_text()
    assert "3 of 12 points" in page and "not yet" in page and "The file came by mail." in page
    assert cli.main(["report", str(results)]) == 0
    assert re.search(r"1\.5\b", (results / "report.html").read_text())
    capsys.readouterr()
    assert cli.main(["lms", "--ungraded", "zero", str(results / "grades.csv"), "--to", "canvas"]) == 0
    assert "12.0" in capsys.readouterr().out


def test_a_check_has_the_points_given_by_hand_whatever_it_earned(results, solution_text, capsys):
    points(results, "ann,hw07,wireframe_shows_the_bars,.25,It was right on paper.", "ben,hw07,c,1,")
    assert scores(results) == {"ann": ("0.25", "12.0"), "ben": ("1.0", "12.0")}
    page = (results / "feedback" / "ann" / f"{SLUG}.html").read_text()
    assert "0.25 of 12 points" in page
    assert "wireframe shows the bars: 0.25 points, by hand: It was right on paper." in page
    assert cli.main(["report", str(results)]) == 0
    assert re.search(r"<td>0\.25<td>0\.25\b", (results / "report.html").read_text())
    (results.parent / "submitted" / "ann" / SLUG / f"{SLUG}.py").write_text(solution_text(SLUG))
    capsys.readouterr()
    graded(results.parent)
    assert scores(results)["ann"] == ("9.75", "12.0")
    table = capsys.readouterr().out
    assert "9.75 / 12" in table and "    1 / 12" in table and "by hand" not in table


def test_the_table_says_which_points_are_not_in_it(results, capsys):
    graded(results.parent)
    assert "not in it yet: 2 of hw07_double_pendulum" in capsys.readouterr().out


def test_grading_again_keeps_them_and_an_empty_cell_takes_them_back(results):
    points(results, "ann,hw07,c,2,")
    graded(results.parent)
    assert scores(results)["ann"] == ("2.0", "12.0")
    points(results, "ann,hw07,c,,")
    assert scores(results)["ann"] == ("0.0", "12.0")


@pytest.mark.parametrize(
    ("row", "says"),
    [
        ("ann,hw07,c,3,", "from 0 to 2 points, not 3"),
        ("ann,hw07,c,many,", "'many', not a number"),
        ("ann,hw07,c,nan,", "'nan', not a number"),
        ("ann,hw07,q,1,", "there is no item 'q'; the parts graded by hand are c"),
        ("ann,hw08,c,1,", "no results of an assignment 'hw08'"),
        ("ann,hw,c,1,", "no results of an assignment 'hw'"),
        ("zoe,hw07,c,1,", "no results of a student 'zoe'"),
        ("*,hw07,c,1,", "one student's"),
        ("ann,hw07,total,1,", "needs a reason"),
        ("ann,hw07,late,-1,", "no negative number"),
        ("*,hw07,off a day,10,", "from 0 to 1"),
        ("ann,hw07,wireframe_shows_the_bars,.5,", "needs a reason"),
        ("ann,hw07,wireframe_shows_the_bars,.6,why", "from 0 to 0.5 points, not 0.6"),
        ("ann,hw07,wireframe_shows_bars,.5,why", "do you mean the check wireframe_shows_the_bars?"),
    ],
)
def test_a_wrong_row_is_named_and_nothing_is_written(results, capsys, row, says):
    assert points(results, "ben,hw07,c,1,", row) == 2
    assert says in (err := capsys.readouterr().err) and "line 3" in err
    assert not (results / "by_hand.csv").exists() and scores(results)["ben"] == ("0.0", "10.0")


def test_a_row_that_somebody_else_adds_meanwhile_stays(results, monkeypatch):
    def opened(folder):
        """The book, which another command has just closed."""
        manual_points.write(folder, ManualAdjustments([Entry("ben", SLUG, "adjust", 2.0, None, "It came by mail.")]))
        return ResultStore(folder)

    monkeypatch.setattr(command, "ResultStore", opened)
    assert points(results, "ann,hw07,c,1,") == 0
    assert scores(results) == {"ann": ("1.0", "12.0"), "ben": ("2.0", "12.0")}


@pytest.mark.parametrize("row", ["ann", "ann,hw07", "ann,hw07,q"])
def test_a_row_that_ends_early_is_named(results, capsys, row):
    assert points(results, row) == 2
    assert "line 2" in capsys.readouterr().err


def test_lines_are_counted_as_an_editor_counts_them(results, capsys):
    assert points(results, "", 'ann,hw07,c,1,"Nice,\nbut short."', "", "ben,hw07,c,9,") == 2
    assert "line 6" in capsys.readouterr().err


def test_a_table_that_is_being_filled_in_stays(results, capsys):
    table = results.parent / "fill.csv"
    table.write_text("ann has 1.5")
    assert cli.main(["points", str(results), str(table), "--template"]) == 2
    assert "name a new file" in capsys.readouterr().err and table.read_text() == "ann has 1.5"


def test_joined_results_bring_their_points(results, tmp_path):
    points(results, "ann,hw07,c,1,", "ben,hw07,c,1,")
    command = ["grade", str(tmp_path / "submitted"), "--out", str(tmp_path / "all"), "--join"]
    assert cli.main([*command, str(results / "results.jsonl")]) == 0
    points(tmp_path / "all", "ann,hw07,c,2,")
    assert cli.main([*command, str(results)]) == 0
    assert scores(tmp_path / "all") == {"ann": ("2.0", "12.0"), "ben": ("1.0", "12.0")}


def test_the_report_shows_points_of_whom_no_file_came(results, tmp_path):
    (tmp_path / "roster.txt").write_text("ann\nben\ncat\n")
    command = ["grade", str(tmp_path / "submitted"), "--out", str(results), "--roster", str(tmp_path / "roster.txt")]
    assert cli.main(command) == 0
    points(results, "cat,hw07,total,8,It came on paper.")
    assert cli.main(["report", str(results)]) == 0
    assert re.search(r"<th scope=row>cat</th><td>8<td>8\b", (results / "report.html").read_text())


def test_the_template_has_a_row_for_each_part_with_what_is_known(results):
    points(results, "ann,hw07,c,1.5,so so")
    assert cli.main(["points", str(results), str(results / "fill.csv"), "--template"]) == 0
    rows = list(csv.DictReader((results / "fill.csv").read_text().splitlines()))
    assert [(row["student"], row["item"], row["points"], row["of"]) for row in rows] == [
        ("ann", "c", "1.5", "2"),
        ("ben", "c", "", "2"),
    ]
    assert all("a motion against what it must conserve" in row["claims"] for row in rows)
    assert cli.main(["points", str(results), str(results / "fill.csv")]) == 0  # as it is, it changes nothing
    assert scores(results)["ann"] == ("1.5", "12.0")


def settlement(score, **items):
    entries = [Entry("ann", SLUG, item.replace("_", " "), points, None, "why") for item, points in items.items()]
    return ManualAdjustments(entries).adjust(("ann", SLUG), score, 10.0, dict)


def settled(score, **items):
    return settlement(score, **items).score


def test_days_beyond_an_extension_cost_their_share_of_the_score():
    assert settled(8.0, late=3, extension=1, off_a_day=0.1) == pytest.approx(6.4)
    assert settled(8.0, late=0.5, off_a_day=0.1) == pytest.approx(7.2)  # a day that has begun counts
    assert settled(8.0, late=20, off_a_day=0.1) == 0.0
    assert settled(8.0, late=1, extension=2, off_a_day=0.1) == 8.0
    assert settled(None, late=1, off_a_day=0.1) is None


def test_a_total_stands_in_the_place_of_all_else():
    assert settled(8.0, late=3, off_a_day=0.5, adjust=1, total=9) == 9.0
    assert settled(None, total=9) == 9.0
    assert settled(0.5, adjust=-2) == 0.0
    says = settlement(8.0, late=1, off_a_day=0.5, total=9).message
    assert [one[:10] for one in says] == ["1 day late", "9 points i"]  # what counts is said last


def test_everybodys_rows_are_for_those_without_their_own():
    rows = [Entry("*", SLUG, "extension", 2.0), Entry("ann", SLUG, "extension", 5.0)]
    late = [Entry(who, SLUG, "late", 4.0) for who in ("ann", "ben")]
    hand = ManualAdjustments([*rows, *late, Entry("*", SLUG, "off a day", 0.1)])
    assert [hand.adjust((who, SLUG), 10.0, 10.0, dict).score for who in ("ann", "ben")] == [10.0, 8.0]
