"""The kit: the files in it, its version, and that a student can work with it alone."""

import json
import os
import re
import shutil
import subprocess
import sys
import zipfile

import pytest
from classes import HW08 as SLUG
from classes import notebook

from tam570_grader.checks import assignments
from tam570_grader.errors import UsageError
from tam570_grader.release.kit import run as make_kit


@pytest.fixture(scope="module")
def kit(tmp_path_factory, course):
    folder = tmp_path_factory.mktemp("kit")
    assert make_kit(course, folder) == 0
    return folder


@pytest.fixture(scope="module")
def unpacked(kit, tmp_path_factory):
    """Return the folder of the unpacked wheel, as pip would install it."""
    (wheel,) = kit.glob("*.whl")
    folder = tmp_path_factory.mktemp("installed")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
    return folder


def test_the_kit_holds_the_assignments_and_no_secret(unpacked, course):
    names = {path.relative_to(unpacked).as_posix() for path in unpacked.rglob("*")}
    assert {f"tam570/assignments/{slug}/{slug}.py" for slug in assignments.slugs(course)} <= names
    assert not [name for name in names if "solutions" in name or "checks/" in name or "__pycache__" in name]
    assert not [name for name in names if "tam570_grader" in name]
    text = b"\n".join(path.read_bytes() for path in unpacked.rglob("*") if path.is_file())
    for slug in assignments.slugs(course):
        assert f"def {assignments.assignment(course, slug).checks[0].name}".encode() not in text


def test_its_only_command_is_the_students(unpacked):
    (entry_points,) = unpacked.glob("*.dist-info/entry_points.txt")
    assert entry_points.read_text().split() == ["[console_scripts]", "tam570", "=", "tam570.__main__:main"]
    (metadata,) = unpacked.glob("*.dist-info/METADATA")
    required = re.findall("^Requires-Dist: ([a-z]+)", metadata.read_text().partition("\n\n")[0], re.MULTILINE)
    assert {"numpy", "scipy", "matplotlib", "sympy", "pytest"} <= set(required) and "msgpack" not in required


def test_its_version_says_its_content(kit, course, tmp_path):
    """The same content has the same version; changed content has another version, so that pip installs it."""
    for name in ("shared", "assignments", "solutions", "autograder"):
        shutil.copytree(course / name, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("README.md", "LICENSE", "NOTATION.md", "pyproject.toml"):
        shutil.copy(course / name, tmp_path)
    (before,) = kit.glob("*.whl")
    (tmp_path / "kit").mkdir()
    assert make_kit(tmp_path, tmp_path / "kit") == 0
    assert [path.name for path in (tmp_path / "kit").glob("*.whl")] == [before.name]
    with open(tmp_path / "assignments" / SLUG / "README.md", "a") as readme:
        readme.write("\nA line more.\n")
    assert make_kit(tmp_path, tmp_path / "kit") == 0
    (after,) = (tmp_path / "kit").glob("*.whl")
    assert after.name != before.name


def test_it_overwrites_no_other_page(course, tmp_path):
    (tmp_path / "README.md").write_text("of a course, say")
    with pytest.raises(UsageError):
        make_kit(course, tmp_path)
    assert [path.read_text() for path in tmp_path.iterdir()] == ["of a course, say"]


def test_the_command_works_from_the_wheel_alone(unpacked, tmp_path):
    environment = {**os.environ, "PYTHONPATH": str(unpacked), "TAM570_HOME": str(tmp_path / "home")}

    def tam570(*arguments, fails=False):
        command = [sys.executable, "-m", "tam570", *arguments]
        run = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
        assert bool(run.returncode) == fails, run.stdout + run.stderr
        return run.stdout

    assert "+" in tam570("--version")
    assert f"{SLUG}.ipynb" in tam570("start", "hw08", "--notebook")
    assert "nothing is written yet" in tam570("check", "hw08", fails=True)
    book = json.loads((tmp_path / SLUG / f"{SLUG}.ipynb").read_text())
    assert any("lab.tests" in "".join(cell["source"]) for cell in book["cells"])
    mine = json.loads(notebook("def skew(v): return v", "1 / 0"))["cells"]
    (tmp_path / SLUG / f"{SLUG}.ipynb").write_text(json.dumps(book | {"cells": book["cells"] + mine}))
    said = tam570("check", f"{SLUG}/{SLUG}.ipynb", fails=True)
    assert said.count("left out") == 1 and "ZeroDivisionError" in said  # the kit's cells need the kernel
