"""A student's copy of an assignment follows a new kit, and work is never lost."""

import re
import shutil

import pytest

from tam570 import cli, course, releases
from tam570.checking.final import ACCURACY
from tam570.course import contract

SLUG = "hw08_axis_angle"


@pytest.fixture
def new_kit(hw08, tmp_path, monkeypatch):
    """`new_kit(name, text)`: after hw08 was started, a kit comes in which this file ends in this text; the file."""
    mine = hw08(None)
    home = tmp_path / "assignments"
    shutil.copytree(course.folder(SLUG).parent, home)
    monkeypatch.setattr(course, "_home", lambda: home)

    def new_kit(name, text):
        released = home / SLUG / name
        released.write_text(released.read_text() + text)
        return mine.parent / name

    return new_kit


MORE = "\n\ndef unskew(matrix, *, scale):\n    raise NotImplementedError\n"


@pytest.mark.parametrize(
    ("name", "text", "mine", "recorded", "message"),
    [
        ("README.md", "\nmore\n", None, True, "README.md"),
        (f"test_{SLUG}.py", "\n# new\n", "# mine\n", True, f"test_{SLUG}.py is not as this kit has it"),
        (f"{SLUG}.py", MORE, "def skew(v):\n    return 1\n", True, "this kit asks for unskew(matrix, *, scale)"),
        ("README.md", "\nmore\n", None, False, "README.md is not as"),
    ],
    ids=["not touched", "touched", "work", "without a record"],
)
def test_update_brings_what_was_not_touched_and_names_the_rest(new_kit, capsys, name, text, mine, recorded, message):
    file = new_kit(name, text)
    if mine:
        file.write_text(mine)
    if not recorded:
        (file.parent / releases.RECORD).unlink()
    before = file.read_text()
    assert cli.main(["update", "hw08"]) == 0 and message in capsys.readouterr().out
    assert file.read_text() == (before if mine or not recorded else before + text)
    if not mine and recorded:
        assert cli.main(["update"]) == 0 and "up to date" in capsys.readouterr().out


def test_each_readme_says_how_closely_motions_are_compared(slug):
    """And which tolerance is safe; in words that `check --final` finds."""
    text = (course.folder(slug) / "README.md").read_text()
    simulates = any(name.startswith("simulate") for name in contract(slug)["results"])
    sentences = [" ".join(sentence.split()) for sentence in ACCURACY.findall(text)]
    assert len(sentences) == simulates
    assert all(re.search(r"to \d?·?10⁻. of .*`rtol=1e-9, atol=1e-9`.* is safe\.", sentence) for sentence in sentences)
