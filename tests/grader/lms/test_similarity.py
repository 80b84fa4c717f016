"""`alike` finds shared code with other names, not independent work; `export` replaces students' names by numbers."""

import re

import pytest
from classes import HW08, hand_in, notebook

from tam570_grader import cli
from tam570_grader.checks import assignments

SLUG = "hw07_double_pendulum"
LONG = ["\t\n" * 50_000, "f'{{" * 25_000, "x = 1\n" * 40_000, "(" * 99_999, "x = '" + "\\\\" * 40_000 + "'"]
TEXT = "def skew(v): return v\n"


@pytest.fixture
def compare(tmp_path, capsys):
    """`compare({student: text}, least)` -> (exit code, printed lines) of `alike`."""

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
    book = notebook(f"%matplotlib inline\n{renamed(solution_text(SLUG))}\nskew?")
    hand_in(tmp_path / "submitted", {"ben": book}, SLUG, "{0}/{0}.ipynb")
    code, (first, *_, last) = compare({**texts, "ann": solution_text(SLUG)})
    assert code == 0 and re.match(rf"{SLUG}  ann \s*\d+ %  ben \s*\d+ %", first) and last.startswith("1 pair of")


def test_what_was_handed_out_is_nobodys(compare, course):
    stub = (course / "assignments" / SLUG / f"{SLUG}.py").read_text()
    assert compare(dict.fromkeys(("ann", "ben"), stub), "0.1")[1][0].startswith("0 pairs of 2")


@pytest.mark.parametrize("text", LONG)
def test_no_text_keeps_the_others_waiting(compare, solution_text, text):
    copies = dict.fromkeys(("ann", "ben"), solution_text(SLUG))
    assert any(line.startswith("1 pair of") for line in compare({**copies, "eve": text})[1])


def test_a_long_sum_is_compared_and_what_is_not_is_told_at_the_end(compare, solution_text):
    text = solution_text(SLUG) + "\n\nLONG = " + " + ".join(f"x{n}" for n in range(2000)) + "\n"
    code, (first, *_, last) = compare({"ann": text, "ben": renamed(text), "eve": "(" * 1000})
    assert code == 1 and "ann" in first and "ben" in first and last.endswith(f"eve {SLUG}")


@pytest.fixture
def exported(desk, tree):
    """`exported(tool)` -> (exit code, {student: number}, output) of `export`."""
    (tree / "ada" / HW08 / f"{HW08}.py").unlink()
    (tree / "ada" / HW08 / f"{HW08}.ipynb").write_text(notebook("import numpy as np", TEXT))

    def exported(tool):
        code, printed = desk("export", tree, "--for", tool, "--to", "out")
        return code, {row["student"]: row["number"] for row in desk.rows("out/names.csv")}, printed

    return exported


@pytest.mark.parametrize("tool", ["dolos", "jplag", "moss"])
def test_every_submission_is_a_module_under_a_number_and_the_names_are_the_instructors(exported, desk, course, tool):
    code, numbers, printed = exported(tool)
    folder = desk.folder / "out" / HW08
    texts = {path.parent.name: path.read_text() for path in (folder / "submissions").glob(f"*/{HW08}.py")}
    assert texts == {numbers["ada"]: f"import numpy as np\n\n{TEXT}\n", numbers["ben"]: "def skew(v): return None\n"}
    stub = course / "assignments" / HW08 / f"{HW08}.py"
    assert (folder / "base" / f"{HW08}.py").read_text() == stub.read_text()
    assert code == 1 and f"cora {HW08} is left out" in printed and tool in printed  # cora handed in nothing
    assert (desk.folder / "out" / "names.csv").stat().st_mode & 0o077 == 0
    assert not any(name in path.name for path in folder.rglob("*") for name in numbers)
    if tool == "dolos":
        assert all((folder / row["filename"]).is_file() for row in desk.rows(f"out/{HW08}/info.csv"))
