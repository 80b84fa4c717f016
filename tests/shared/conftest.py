"""A student's desk: a folder to work in, and the command as a student gives it."""

import subprocess
import sys

import pytest

from tam570 import cli

HW08 = "hw08_axis_angle"


@pytest.fixture
def desk(tmp_path, monkeypatch):
    """A student's empty folder, and nothing remembered."""
    desk = tmp_path / "desk"
    desk.mkdir()
    monkeypatch.chdir(desk)
    monkeypatch.setenv("TAM570_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("PYTHONUNBUFFERED", "1")
    monkeypatch.setenv("TAM570_CALL_LIMIT", "2")  # s: tests do not wait for longer
    return desk


@pytest.fixture
def tam570(desk):
    """`tam570(*arguments)` -> the exit code, and what is printed."""

    def tam570(*arguments, **options):
        command = [sys.executable, "-m", "tam570", *map(str, arguments)]
        process = subprocess.run(command, capture_output=True, text=True, check=False, **options)
        return process.returncode, process.stdout + process.stderr

    return tam570


@pytest.fixture
def hw08(desk, solution_text):
    """`hw08(text)` -> the file of hw08, started: the solution, and this text below it; None for the stub."""
    assert cli.main(["start", "hw08"]) == 0
    file = desk / HW08 / f"{HW08}.py"

    def hw08(below="", above=""):
        if below is not None:
            file.write_text(f"{above}{solution_text(HW08)}\n\n{below}\n")
        return file

    return hw08
