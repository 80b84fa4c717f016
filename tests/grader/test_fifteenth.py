"""An assignment is six places: a fifteenth, hw08 under another name, is added to a copy of the course and graded."""

import json
import os
import shutil
import subprocess
import sys

import pytest

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import mistakes

MODEL, SLUG = "hw08_axis_angle", "hw15_turning"
SCENE, NOTATION = "shared/tam570/show/scenes/hw15.py", "NOTATION.md"
PLACES = ("solutions/{}.py", "assignments/{}", "autograder/checks/{}", "shared/tam570/show/scenes/{:.4}.py")


def renamed(text):
    return text.replace(MODEL, SLUG).replace(MODEL[:4], SLUG[:4])


def add_assignment(course):
    """Copy the places of the model, with its name exchanged in names and texts."""
    for place in PLACES:
        old, new = course / place.format(MODEL), course / place.format(SLUG)
        for path in [old] if old.is_file() else [path for path in old.rglob("*") if path.is_file()]:
            copy = new if old.is_file() else new / renamed(path.relative_to(old).as_posix())
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(renamed(path.read_text()))
    notation = course / NOTATION
    notation.write_text(notation.read_text().replace("(hw08)", "(hw08, hw15)"))


@pytest.fixture(scope="module")
def fifteen(tmp_path_factory, course):
    """A copy of the course with the new assignment."""
    copy = tmp_path_factory.mktemp("fifteen")
    for part in ("assignments", "solutions", "autograder", "shared", "tests"):
        shutil.copytree(course / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", NOTATION):
        shutil.copy(course / name, copy)
    add_assignment(copy)
    (copy / "assignments" / SLUG / f"{SLUG}.py").unlink()
    assert cli.main(["--root", str(copy), "stubs"]) == 0
    return copy


def test_it_is_found_graded_audited_and_released(fifteen, tmp_path, capsys):
    assert SLUG in assignments.slugs(fifteen)
    solution = (fifteen / "solutions" / f"{SLUG}.py").read_text()
    slip = mistakes(fifteen / "autograder" / "checks" / SLUG)[0]
    for student, text in {"ada": solution, "ben": f"{solution}\n\n{slip.text}"}.items():
        (work := tmp_path / "submitted" / student / SLUG).mkdir(parents=True)
        (work / f"{SLUG}.py").write_text(text)
    capsys.readouterr()
    root = ["--root", str(fifteen)]
    assert cli.main([*root, "grade", str(tmp_path / "submitted"), "--json", "--jobs", "1", "--seed", "2"]) == 0
    ada, ben = sorted(map(json.loads, capsys.readouterr().out.splitlines()), key=lambda line: line["student"])
    assert ada["score"] == 10.0 and slip.message in [check["suspect"] for check in ben["checks"]]
    assert cli.main([*root, "audit", SLUG, "--function", "skew", "--jobs", "1"]) == 0
    assert cli.main([*root, "course", str(tmp_path / "course"), SLUG]) == 0
    assert list((tmp_path / "course" / "source" / SLUG).glob("*.ipynb"))


@pytest.mark.slow
def test_the_command_of_contributing_passes_and_sees_every_place(fifteen, course):
    assert "`pytest tests -m '' -k hwNN`" in (course / "CONTRIBUTING.md").read_text()
    fields = {**os.environ, "PYTHONPATH": f"{fifteen / 'autograder'}{os.pathsep}{fifteen / 'shared'}"}

    def fails(*files):
        command = [sys.executable, "-m", "pytest", "-q", *files, "-k", "hw15", "-m", ""]
        return subprocess.run(command, cwd=fifteen, env=fields, capture_output=True, text=True).returncode

    places = {"tests/shared/show/test_show.py": SCENE, "tests/test_notation.py": NOTATION}
    assert not fails("tests/test_laws.py", *places)
    (fifteen / SCENE).unlink()
    shutil.copy(course / NOTATION, fifteen)
    assert [fails(file) for file in places] == [1, 1]
