"""What a change concerns, what is remembered of it, and `check --watch` from a save to the result."""

import re
import signal
import subprocess
import sys

import pytest

from tam570 import cli
from tam570.changes import ANY, calls, keys
from tam570.progress import kept, progress
from tam570_grader.writing import assignments

SLUG = "hw08_axis_angle"

CODE = '''
import numpy as np

RATE = 2.0  # 1/s


def helper(x):
    """Says what it does."""
    return RATE * x


def first(x):
    return helper(x)


def second(x):
    return x


def third(x):
    return np.sin(x)
'''
TESTS = """
import code_of_mine as hw
import pytest
from code_of_mine import third as another

POINT = 1.0


@pytest.fixture
def value():
    return hw.second(POINT)


def apart(f):
    return f(POINT)


def test_first():
    assert hw.first(POINT) == 2.0


def test_second(value):
    assert value == POINT


def test_third():
    assert apart(another) < POINT


def test_all():
    assert callable(getattr(hw, "first"))
"""
EVERY = {"test_first", "test_second", "test_third", "test_all"}


def concerned(code=None, tests=None):
    """The tests whose key becomes another."""
    before, after = (keys(TESTS, CODE, "code_of_mine"), keys(tests or TESTS, code or CODE, "code_of_mine"))
    return {test for test in before | after if before.get(test) != after.get(test)}


def test_the_functions_that_a_test_calls_are_found_in_helpers_and_fixtures():
    assert calls(TESTS, "code_of_mine") == {
        "test_first": {"first"},
        "test_second": {"second"},
        "test_third": {"third"},
        "test_all": {"first", ANY},
    }


@pytest.mark.parametrize(
    ("old", "new", "which"),
    [
        ("return x\n", "return 1 * x\n", {"test_second", "test_all"}),
        ("return RATE * x", "return x * RATE", {"test_first", "test_all"}),
        ("RATE = 2.0", "RATE = 3.0", {"test_first", "test_all"}),
        ("import numpy as np", "import math as np", {"test_third", "test_all"}),
        ("def second(x)", "def second(x, y=0)", {"test_second", "test_all"}),
        ("RATE = 2.0", "if 1 < 2:\n    RATE = 2.0", EVERY),
        ("# 1/s", "# per second", set()),
        ("Says what it does.", "Says it better.", set()),
        ("\n\n\ndef third", "\n\n\n\n\ndef third", set()),
        ("def third(x):\n    return np.sin(x)\n", "", {"test_third", "test_all"}),
    ],
)
def test_a_change_concerns_the_tests_that_see_it(old, new, which):
    assert old in CODE
    assert concerned(code=CODE.replace(old, new)) == which


@pytest.mark.parametrize(
    ("old", "new", "which"),
    [("POINT = 1.0", "POINT = 1.5", EVERY - {"test_all"}), ("return f(POINT)", "return f(2)", {"test_third"})],
)
def test_a_change_of_the_tests_concerns_those_that_it_changes(old, new, which):
    assert concerned(tests=TESTS.replace(old, new)) == which


def test_every_visible_test_says_which_functions_it_calls(slug, course):
    """So that the points by visible tests are whole."""
    text = (course / "assignments" / slug / f"test_{slug}.py").read_text()
    found = calls(text, slug)
    assert set.union(*found.values()) >= set(assignments.assignment(course, slug).results)


def test_all_tests_passed_are_all_points(slug, course):
    found = calls((course / "assignments" / slug / f"test_{slug}.py").read_text(), slug)
    come = progress(slug, dict.fromkeys(found, "passed"), found)
    assert (come["points"], come["most"], come["next"]) == (10, 10, None)
    come = progress(slug, dict.fromkeys(found, "failed"), found)
    assert come["points"] == come["passed"] == 0 and come["next"] == next(
        iter(assignments.assignment(course, slug).results)
    )


def test_a_failure_is_charged_to_what_no_test_has_proven():
    found = {"test_a": {"skew"}, "test_b": {"skew", "rotate"}}
    come = progress(SLUG, {"test_a": "passed", "test_b": "failed"}, found)
    assert come["next"] == "rotate" and come["points"] > 0
    come = progress(SLUG, {"test_a": "failed", "test_b": "passed"}, found)
    assert come["next"] == "skew"


# The commands


@pytest.fixture
def desk(tmp_path, monkeypatch):
    """A student's folder with hw08 started."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TAM570_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("PYTHONUNBUFFERED", "1")
    assert cli.main(["start", "hw08"]) == 0
    return tmp_path


def checked(*arguments):
    command = [sys.executable, "-m", "tam570.cli", "check", *arguments]
    return subprocess.run(command, capture_output=True, text=True)


def line(capsys, slug=SLUG):
    capsys.readouterr()
    assert cli.main(["list"]) == 0
    out = capsys.readouterr().out
    return next(one for one in out.splitlines() if one.startswith(slug)), out


def test_list_tells_points_next_step_and_a_change_since(desk, capsys, solution_text):
    file = desk / SLUG / f"{SLUG}.py"
    assert line(capsys)[0].endswith("started")
    checked("hw08")
    assert "0 of 10, next: skew" in line(capsys)[0]
    file.write_text(solution_text(SLUG))
    assert "changed since" in line(capsys)[0]
    assert "10 of 10 points by the visible tests; all done" in checked("hw08").stdout
    said, out = line(capsys)
    assert said.endswith("10 of 10, done") and out.endswith(
        "10 of 10 points by the visible tests of what you have checked here\n"
    )


def test_list_runs_nothing_of_the_students(desk, capsys):
    (desk / SLUG / f"{SLUG}.py").write_text("raise SystemExit('run')")
    assert "started" in line(capsys)[0]


def test_what_cannot_be_remembered_stops_nothing(desk, monkeypatch, solution_text):
    (desk / "home").write_text("not a folder")
    (desk / SLUG / f"{SLUG}.py").write_text(solution_text(SLUG))
    assert checked("hw08").returncode == 0


def hinted(capsys):
    capsys.readouterr()
    assert cli.main(["hint", "hw08", "skew"]) == 0
    out, err = capsys.readouterr()
    assert not err
    return out


def test_hints_that_cannot_be_remembered_are_given_from_the_first(desk, capsys):
    (desk / "home").write_text("not a folder")
    assert "(1 of 2)" in hinted(capsys) and "(1 of 2)" in hinted(capsys)


@pytest.mark.parametrize("text", ["", "[1]", "null", f'{{"{SLUG} skew": "two"}}', f'{{"{SLUG}": {{"skew": 1}}}}'])
def test_what_is_no_memory_of_hints_is_overwritten(desk, capsys, text):
    (desk / "home").mkdir()
    (desk / "home" / "hints.json").write_text(text)
    assert "(1 of 2)" in hinted(capsys) and "(2 of 2" in hinted(capsys)


def test_of_a_test_with_several_parameters_the_worst_is_remembered(desk, solution_text):
    file = desk / SLUG / f"{SLUG}.py"
    file.write_text(solution_text(SLUG))
    (file.parent / f"test_{SLUG}.py").write_text(
        f"import {SLUG} as hw\nimport pytest\n\n\n@pytest.mark.parametrize('k', [0, 1, 2])\n"
        "def test_one(k):\n    assert hw.skew([1, 2, 3]) is not None and k != 1\n"
    )
    assert checked("hw08").returncode == 1
    assert [outcome for _, outcome in kept(file).values()] == ["failed"]


@pytest.fixture
def watching(desk, solution_text):
    """`watching(text)` -> what is said after this text is saved; None waits for the first result."""
    file = desk / SLUG / f"{SLUG}.py"
    file.write_text(solution_text(SLUG))
    command = [sys.executable, "-m", "tam570.cli", "check", "hw08", "--watch"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def after(text=None, until="points by the visible tests"):
        if text is not None:
            draft = file.with_suffix(".new")
            draft.write_text(text)
            draft.replace(file)  # as editors do
        said = ""
        for one in process.stdout:
            said += one
            if until in one:
                return said
        raise AssertionError(f"ended with {process.wait()}: {said}")

    after.process = process
    yield after
    process.kill()
    process.communicate()


def count(said):
    return sum(map(int, re.findall(r"(\d+) (?:passed|failed)", said)))


def test_a_save_runs_the_tests_that_it_concerns_and_no_other(watching, desk, solution_text):
    everything = count(watching())
    right = solution_text(SLUG)
    last = "\n\ndef {}(*args):\n    return None\n"
    assert "nothing has changed that a test sees" in watching(right + "\n# a remark\n")
    wrong = watching(right + last.format("rotate"))
    assert 0 < count(wrong) < everything and "next: rotate" in wrong
    text = (desk / SLUG / f"test_{SLUG}.py").read_text()
    apart = sum("rotate" not in used for used in calls(text, SLUG).values())
    assert f"{apart} of {len(calls(text, SLUG))} tests pass" in wrong
    again = watching(right + last.format("unused"))
    assert "all done" in again and count(again) == count(wrong)


def test_a_file_that_is_half_written_is_said_so_and_the_next_save_is_tested(watching, solution_text):
    watching()
    assert "SyntaxError" in watching("def skew(", until="SyntaxError")
    assert "all done" in watching(solution_text(SLUG) + "\nMORE = 1\n")


def test_a_save_ends_tests_that_hang(watching, solution_text):
    watching()
    hanging = solution_text(SLUG) + "\n\ndef skew(v):\n    print('hangs', flush=True)\n    while True:\n        pass\n"
    hanging += "\n\nprint('loaded', flush=True)\n"
    watching(hanging, until="loaded")
    assert "all done" in watching(solution_text(SLUG) + "\nMORE = 2\n")


def test_ctrl_c_ends_it_without_a_traceback(watching):
    watching()
    watching.process.send_signal(signal.SIGINT)
    out, _ = watching.process.communicate(timeout=60)
    assert watching.process.returncode == 0 and "Traceback" not in out and "no longer watching" in out


def test_bad_usage_of_watch_exits_2(desk, monkeypatch, tmp_path):
    assert checked("hw09", "--watch").returncode == 2
