"""`tam570-grader replay`: the very call that failed, and the same call made again."""

import re

import pytest

from tam570_grader import cli
from tam570_grader.writing import assignments

SLUG = "hw08_axis_angle"


@pytest.fixture(scope="module")
def results(tmp_path_factory, course):
    """A class of one, whose rotation matrix is the transpose."""
    folder = tmp_path_factory.mktemp("replay")
    work = folder / "submitted" / "ada" / SLUG
    work.mkdir(parents=True)
    solution = (course / "solutions" / f"{SLUG}.py").read_text()
    slip = (assignments.checks_folder(course, SLUG) / "mistakes" / "transposed.py").read_text()
    (work / f"{SLUG}.py").write_text(f"{solution}\n\n{slip}")
    (folder / "right.py").write_text(solution)
    arguments = ["grade", str(folder / "submitted"), "--out", str(folder / "out"), "--seed", "3", "--jobs", "1"]
    assert cli.main(["--root", str(course), *arguments]) == 0
    return folder


def failed(course):
    text = (assignments.checks_folder(course, SLUG) / "mistakes" / "transposed.py").read_text()
    return re.search(r"^fails: (\w+)", text, re.MULTILINE)[1]


def numbers(line):
    return [float(one) for one in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", line)]


def test_the_call_is_printed_whole_and_made_again(results, course, capsys):
    capsys.readouterr()
    mine = str(results / "submitted" / "ada" / SLUG / f"{SLUG}.py")
    assert cli.main(["--root", str(course), "replay", str(results / "out"), "ada", failed(course), mine]) == 0
    said = capsys.readouterr().out
    expected, actual, now = (numbers(re.search(rf"^{what}: +(.+)$", said, re.MULTILINE)[1]) for what in WHAT)
    assert now == actual != expected


def test_what_is_right_gives_what_is_expected(results, course, capsys):
    capsys.readouterr()
    right = str(results / "right.py")
    assert cli.main(["--root", str(course), "replay", str(results / "out"), "ada", failed(course), right]) == 0
    said = capsys.readouterr().out
    expected, _, now = (numbers(re.search(rf"^{what}: +(.+)$", said, re.MULTILINE)[1]) for what in WHAT)
    assert now == pytest.approx(expected, abs=1e-12)


WHAT = ("expected", "actual", "now")


@pytest.mark.parametrize(("student", "says"), [("bob", "no result of bob"), ("ada", "failed checks: ")])
def test_what_is_not_there_is_named(results, course, capsys, student, says):
    assert cli.main(["--root", str(course), "replay", str(results / "out"), student, "no_check"]) == 2
    assert says in capsys.readouterr().err
