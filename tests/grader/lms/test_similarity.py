"""Shared code is found behind other names and comments, in notebooks too; right work of one's own is not accused."""

import re

import pytest
from classes import hand_in, notebook

from tam570_grader import cli
from tam570_grader.checks import assignments

SLUG = "hw07_double_pendulum"


@pytest.fixture
def compare(tmp_path, capsys):
    """`compare(texts, least)` -> exit code and the lines printed, of these texts by student."""

    def compare(texts, least="0.9"):
        hand_in(tmp_path / "submitted", texts, SLUG)
        code = cli.main(["alike", str(tmp_path / "submitted"), "--least", least])
        return code, capsys.readouterr().out.splitlines()

    return compare


def renamed(text):
    return re.sub(r"#.*", "", text).replace("theta", "th").replace("omega", "w")


def test_renamed_code_is_found_and_right_work_of_ones_own_is_not(compare, tmp_path, course, solution_text):
    mine = sorted((assignments.checks_folder(course, SLUG) / "alternatives").glob("*.py"))
    texts = {f"own{number}": path.read_text() for number, path in enumerate(mine)}
    book = tmp_path / "submitted" / "ben" / SLUG / f"{SLUG}.ipynb"
    book.parent.mkdir(parents=True)
    book.write_text(notebook(f"%matplotlib inline\n{renamed(solution_text(SLUG))}\nskew?"))
    code, (first, *_, last) = compare({**texts, "ann": solution_text(SLUG)})
    assert code == 0 and re.match(rf"{SLUG}  ann \s*\d+ %  ben \s*\d+ %", first) and last.startswith("1 pair of")


def test_what_was_handed_out_is_nobodys(compare, course):
    stub = (course / "assignments" / SLUG / f"{SLUG}.py").read_text()
    assert compare(dict.fromkeys(("ann", "ben"), stub), "0.1")[1][0].startswith("0 pairs of 2")


@pytest.mark.parametrize(
    "text", ["\t\n" * 50_000, "f'{{" * 25_000, "x = 1\n" * 40_000, "(" * 99_999, "x = '" + "\\\\" * 40_000 + "'"]
)
def test_no_text_keeps_the_others_waiting(compare, solution_text, text):
    copies = dict.fromkeys(("ann", "ben"), solution_text(SLUG))
    assert any(line.startswith("1 pair of") for line in compare({**copies, "eve": text})[1])


def test_a_long_sum_is_compared_and_what_is_not_is_told_at_the_end(compare, solution_text):
    text = solution_text(SLUG) + "\n\nLONG = " + " + ".join(f"x{n}" for n in range(2000)) + "\n"
    code, (first, *_, last) = compare({"ann": text, "ben": renamed(text), "eve": "(" * 1000})
    assert code == 1 and "ann" in first and "ben" in first and last.endswith(f"eve {SLUG}")
