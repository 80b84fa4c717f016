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


def test_update_brings_what_was_not_touched(new_kit, capsys):
    readme = new_kit("README.md", "\nmore\n")
    assert cli.main(["update", "hw08"]) == 0
    assert readme.read_text().endswith("\nmore\n") and "README.md" in capsys.readouterr().out
    assert cli.main(["update"]) == 0 and "up to date" in capsys.readouterr().out


def test_update_names_what_was_touched_and_leaves_it(new_kit, capsys):
    tests = new_kit(f"test_{SLUG}.py", "\n# new\n")
    tests.write_text(tests.read_text() + "\n# mine\n")
    assert cli.main(["update", "hw08"]) == 0
    assert (
        tests.read_text().endswith("# mine\n") and f"{tests.name} is not as this kit has it" in capsys.readouterr().out
    )


def test_update_never_changes_work_and_tells_new_signatures(new_kit, capsys):
    stub = new_kit(f"{SLUG}.py", "\n\ndef unskew(matrix, *, scale):\n    raise NotImplementedError\n")
    stub.write_text("def skew(v):\n    return 1\n")
    assert cli.main(["update", "hw08"]) == 0
    said = capsys.readouterr().out
    assert stub.read_text() == "def skew(v):\n    return 1\n" and "this kit asks for unskew(matrix, *, scale)" in said


def test_update_of_a_folder_without_a_record_changes_nothing(new_kit, capsys):
    readme = new_kit("README.md", "\nmore\n")
    (readme.parent / releases.RECORD).unlink()
    assert cli.main(["update", "hw08"]) == 0
    assert not readme.read_text().endswith("\nmore\n") and "README.md is not as" in capsys.readouterr().out


def test_each_readme_says_how_closely_motions_are_compared(slug):
    """And which tolerance is safe; in words that `check --final` finds."""
    text = (course.folder(slug) / "README.md").read_text()
    simulates = any(name.startswith("simulate") for name in contract(slug)["results"])
    sentences = [" ".join(sentence.split()) for sentence in ACCURACY.findall(text)]
    assert len(sentences) == simulates
    assert all(re.search(r"to \d?·?10⁻. of .*`rtol=1e-9, atol=1e-9`.* is safe\.", sentence) for sentence in sentences)
