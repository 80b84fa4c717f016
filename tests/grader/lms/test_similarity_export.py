"""Submissions for Dolos, JPlag and Moss: numbers for names, notebooks as modules, the stub as base."""

import pytest
from classes import HW08, notebook

TEXT = "def skew(v): return v\n"


@pytest.fixture
def exported(desk, tree):
    """`exported(tool)` -> exit code, number by student, what was printed."""
    (tree / "ada" / HW08 / f"{HW08}.py").unlink()
    (tree / "ada" / HW08 / f"{HW08}.ipynb").write_text(notebook("import numpy as np", TEXT))

    def exported(tool):
        code, printed = desk("export", tree, "--for", tool, "--to", "out")
        return code, {row["student"]: row["number"] for row in desk.rows("out/names.csv")}, printed

    return exported


@pytest.mark.parametrize("tool", ["dolos", "jplag", "moss"])
def test_every_submission_is_a_module_under_a_number(exported, desk, course, tool):
    code, numbers, printed = exported(tool)
    folder = desk.folder / "out" / HW08
    texts = {path.parent.name: path.read_text() for path in (folder / "submissions").glob(f"*/{HW08}.py")}
    assert texts == {numbers["ada"]: f"import numpy as np\n\n{TEXT}\n", numbers["ben"]: "def skew(v): return None\n"}
    stub = course / "assignments" / HW08 / f"{HW08}.py"
    assert (folder / "base" / f"{HW08}.py").read_text() == stub.read_text()
    assert code == 1 and f"cora {HW08} is left out" in printed and tool in printed  # cora handed in nothing


def test_no_name_is_in_what_is_sent_and_the_names_are_the_instructors(exported, desk):
    _, numbers, _ = exported("dolos")
    folder = desk.folder / "out"
    sent = [path.relative_to(folder).as_posix() for path in (folder / HW08).rglob("*")]
    assert not any(name in path for path in sent for name in numbers)
    assert (folder / "names.csv").stat().st_mode & 0o077 == 0
    assert all((folder / HW08 / row["filename"]).is_file() for row in desk.rows(f"out/{HW08}/info.csv"))
