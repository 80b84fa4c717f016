"""Submissions for Dolos, JPlag and Moss: numbers for names, notebooks as modules, the stub as base."""

import csv

import pytest
from classes import notebook

from tam570_grader import cli

SLUG = "hw08_axis_angle"
TEXT = "def skew(v): return v\n"


@pytest.fixture
def exported(course, tmp_path, tree, capsys):
    """`exported(tool)` -> exit code, the folder, number by student, what was said."""
    (tree / "ada" / SLUG / f"{SLUG}.py").unlink()
    (tree / "ada" / SLUG / f"{SLUG}.ipynb").write_text(notebook("import numpy as np", TEXT))

    def exported(tool):
        out = tmp_path / "out"
        code = cli.main(["--root", str(course), "export", str(tree), "--for", tool, "--to", str(out)])
        with open(out / "names.csv", newline="") as file:
            numbers = {row["student"]: row["number"] for row in csv.DictReader(file)}
        return code, out, numbers, "".join(capsys.readouterr())

    return exported


@pytest.mark.parametrize("tool", ["dolos", "jplag", "moss"])
def test_every_submission_is_a_module_under_a_number(exported, course, tool):
    code, out, numbers, said = exported(tool)
    texts = {path.parent.name: path.read_text() for path in (out / SLUG / "submissions").glob(f"*/{SLUG}.py")}
    assert texts == {numbers["ada"]: f"import numpy as np\n\n{TEXT}\n", numbers["ben"]: "def skew(v): return None\n"}
    stub = course / "assignments" / SLUG / f"{SLUG}.py"
    assert (out / SLUG / "base" / f"{SLUG}.py").read_text() == stub.read_text()
    assert code == 1 and f"cora {SLUG} is left out" in said  # who handed in nothing
    assert tool in said and "base" in said


def test_no_name_is_in_what_is_sent_and_the_names_are_the_instructors(exported):
    _, out, numbers, _ = exported("dolos")
    sent = [path for path in (out / SLUG).rglob("*")]
    assert not any(name in str(path.relative_to(out)) for path in sent for name in numbers)
    assert (out / "names.csv").stat().st_mode & 0o077 == 0
    with open(out / SLUG / "info.csv", newline="") as file:
        assert all((out / SLUG / row["filename"]).is_file() for row in csv.DictReader(file))
