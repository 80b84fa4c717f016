"""What an instructor does in a test: a class of three, `grade` as a command, and what it prints."""

import json

import pytest

from tam570_grader import cli

SLUG = "hw08_axis_angle"


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
    texts = {"ada": solution_text(SLUG), "ben": "def skew(v): return None\n", "cora": None}
    for student, text in texts.items():
        folder = tmp_path / "submitted" / student / SLUG
        folder.mkdir(parents=True)
        if text is not None:
            (folder / f"{SLUG}.py").write_text(text)
    return tmp_path / "submitted"


@pytest.fixture(scope="session")
def scores():
    """`scores(lines)` -> student: score, of result lines."""
    return lambda lines: {line["student"]: line["score"] for line in lines}


@pytest.fixture(scope="session")
def notebook():
    """`notebook(*cells)` -> the text of a notebook with these code cells."""

    def notebook(*cells):
        code = [{"cell_type": "code", "source": text.splitlines(keepends=True)} for text in cells]
        return json.dumps({"cells": [{"cell_type": "markdown", "source": ["# hw08"]}, *code], "nbformat": 4})

    return notebook
