"""Fixtures of the grader's tests: the submissions of a class of three, the command `grade`, and its output."""

import json

import pytest
from classes import HW08, hand_in

from tam570_grader import cli
from tam570_grader.grading import supervisor


@pytest.fixture
def run(capsys):
    """`run(*arguments)` -> (exit code of `grade`, its JSON lines, the text on stderr)."""

    def run(*arguments):
        code = cli.main(["grade", *map(str, arguments), "--json"])
        out, err = capsys.readouterr()
        return code, [json.loads(line) for line in out.splitlines()], err

    return run


@pytest.fixture
def tree(tmp_path, solution_text):
    """Return the folder of a class of three: a correct, an incomplete and a missing submission."""
    (tmp_path / "submitted" / "cora" / HW08).mkdir(parents=True)
    return hand_in(tmp_path / "submitted", {"ada": solution_text(HW08), "ben": "def skew(v): return None\n"})


@pytest.fixture
def graded_works(monkeypatch):
    """Return a list of (student, assignment), to which each grading of a submission appends."""
    works, graded = [], supervisor.graded

    def noted(name, source, assignment, *rest, **more):
        works.append((name, assignment.slug))
        return graded(name, source, assignment, *rest, **more)

    monkeypatch.setattr(supervisor, "graded", noted)
    return works


@pytest.fixture(scope="session")
def scores():
    """`scores(lines)` -> {student: score} of JSON lines."""
    return lambda lines: {line["student"]: line["score"] for line in lines}
