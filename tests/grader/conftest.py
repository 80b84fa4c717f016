"""What an instructor does in a test: a class of three, `grade` as a command, and what it prints."""

import json

import pytest
from classes import HW08, hand_in

from tam570_grader import cli
from tam570_grader.grading import supervisor


@pytest.fixture
def run(capsys):
    """`run(*arguments)` -> (exit code, result lines, what was said on stderr)."""

    def run(*arguments):
        code = cli.main(["grade", *map(str, arguments), "--json"])
        out, err = capsys.readouterr()
        return code, [json.loads(line) for line in out.splitlines()], err

    return run


@pytest.fixture
def tree(tmp_path, solution_text):
    """A class of three: right, half done, and not handed in."""
    (tmp_path / "submitted" / "cora" / HW08).mkdir(parents=True)
    return hand_in(tmp_path / "submitted", {"ada": solution_text(HW08), "ben": "def skew(v): return None\n"})


@pytest.fixture
def graded_works(monkeypatch):
    """The submissions that were run, by student and assignment."""
    works, graded = [], supervisor.graded

    def noted(name, source, assignment, *rest, **more):
        works.append((name, assignment.slug))
        return graded(name, source, assignment, *rest, **more)

    monkeypatch.setattr(supervisor, "graded", noted)
    return works


@pytest.fixture(scope="session")
def scores():
    """`scores(lines)` -> student: score, of result lines."""
    return lambda lines: {line["student"]: line["score"] for line in lines}
