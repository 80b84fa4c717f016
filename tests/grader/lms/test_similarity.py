"""Shared code is found behind other names and comments, in notebooks too; right work of one's own is not accused."""

import json
import re

import pytest

from tam570_grader import cli
from tam570_grader.checks import assignments

SLUG = "hw07_double_pendulum"


@pytest.fixture
def alike(tmp_path, capsys):
    """`alike(texts, *options)` -> exit code and what is printed, of these texts by student."""

    def alike(texts, *options):
        for student, (name, text) in texts.items():
            folder = tmp_path / "submitted" / student / SLUG
            folder.mkdir(parents=True)
            (folder / f"{SLUG}.{name}").write_text(text)
        code = cli.main(["alike", str(tmp_path / "submitted"), *options])
        return code, capsys.readouterr()

    return alike


def renamed(text):
    return re.sub(r"#.*", "", text).replace("theta", "th").replace("omega", "w")


def notebook(text):
    source = f"%matplotlib inline\n{text}\nskew?"
    cells = [{"cell_type": "code", "source": source, "metadata": {}, "outputs": [], "execution_count": None}]
    return json.dumps({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5})


def test_renamed_code_is_found_and_right_work_of_ones_own_is_not(alike, course, solution_text):
    mine = sorted((assignments.checks_folder(course, SLUG) / "alternatives").glob("*.py"))
    texts = {f"own{number}": ("py", path.read_text()) for number, path in enumerate(mine)}
    copies = {"ann": ("py", solution_text(SLUG)), "ben": ("ipynb", notebook(renamed(solution_text(SLUG))))}
    code, said = alike({**texts, **copies}, "--least", "0.9")
    first, *_, last = said.out.splitlines()
    assert code == 0 and re.match(rf"{SLUG}  ann \s*\d+ %  ben \s*\d+ %", first)
    assert last.startswith("1 pair of") and not re.search("own", said.out)


def test_what_was_handed_out_is_nobodys(alike, course):
    stub = (course / "assignments" / SLUG / f"{SLUG}.py").read_text()
    _, said = alike({"ann": ("py", stub), "ben": ("py", stub)}, "--least", "0.1")
    assert said.out.startswith("0 pairs of 2")


@pytest.mark.parametrize(
    "text", ["\t\n" * 50_000, "f'{{" * 25_000, "x = 1\n" * 40_000, "(" * 99_999, "x = '" + "\\\\" * 40_000 + "'"]
)
def test_no_text_keeps_the_others_waiting(alike, solution_text, text):
    copies = {"ann": ("py", solution_text(SLUG)), "ben": ("py", solution_text(SLUG)), "eve": ("py", text)}
    _, said = alike(copies, "--least", "0.9")
    assert "1 pair of" in said.out


def test_a_long_sum_is_compared_and_what_is_not_is_told_at_the_end(alike, solution_text):
    text = solution_text(SLUG) + "\n\nLONG = " + " + ".join(f"x{n}" for n in range(2000)) + "\n"
    code, said = alike({"ann": ("py", text), "ben": ("py", renamed(text)), "eve": ("py", "(" * 1000)}, "--least", "0.9")
    first, *_, last = said.out.splitlines()
    assert code == 1 and "ann" in first and "ben" in first and last.endswith(f"eve {SLUG}")
