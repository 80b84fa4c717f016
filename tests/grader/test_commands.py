"""The grader's commands: imports, help, threads, output that cannot be written, and completion in shells."""

import itertools
import json
import signal
import subprocess
import sys

import pytest
from classes import HW08 as SLUG
from classes import hand_in, result
from processes import imported_modules

from tam570_grader import cli as grader

HEAVY = {"scipy", "matplotlib", "sympy", "pytest", "llvmlite", "nbgrader", "tqdm", "hatchling", "IPython"}
FOLDERS = "kit", "course", "gradescope"
FILES = "report results --out", "lms grades.csv --to canvas --out", "audit hw08 --fairness 1 --jobs 1 --keep"
TARGETS = [*itertools.product(FOLDERS, ["file", "file/x"]), *itertools.product(FILES, ["none/x", "file/x"])]


def test_grading_hw08_imports_numpy_and_nothing_heavier(here, course):
    path = course / "solutions" / f"{SLUG}.py"
    code = f"from tam570_grader.cli import main\nassert main(['--root', {str(course)!r}, 'grade', {str(path)!r}]) == 0"
    modules = imported_modules(code)
    assert "numpy" in modules and not modules & {*HEAVY, "difflib", "html", "tomllib", "zipfile"}


def test_the_help_of_the_grader_imports_nothing_heavy(here):
    code = "from contextlib import suppress\nfrom tam570_grader.cli import main\n"
    code += "for words in ['grade', '--help'], ['--help', 'grade']:\n    with suppress(SystemExit): main(words)"
    assert not imported_modules(code) & HEAVY


def test_the_help_lists_every_command_whatever_follows(capsys):
    with pytest.raises(SystemExit):
        grader.main(["--help", "grade"])
    assert set(grader.COMMANDS) <= set(capsys.readouterr().out.split())


@pytest.mark.parametrize("package", ["tam570", "tam570_grader"])
def test_ctrl_c_during_the_imports_prints_no_traceback(tmp_path, package):
    (tmp_path / "argparse.py").write_text("import os, signal\nos.kill(os.getpid(), signal.SIGINT)\n")
    code = f"import sys\nsys.path.insert(0, {str(tmp_path)!r})\nimport {package}.__main__"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (run.returncode, run.stderr) == (-signal.SIGINT, "")  # a shell reports 130


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="counts threads in /proc")
def test_algebra_has_one_thread(monkeypatch):
    """NumPy's linear algebra uses one thread, because a second one would busy-wait beside each supervisor."""
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)
    code = "import tam570_grader, numpy, os\nnumpy.eye(500) @ numpy.eye(500)\nprint(len(os.listdir('/proc/self/task')))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout.split() == [b"1"]


@pytest.mark.parametrize(("command", "path"), TARGETS)
def test_what_cannot_be_written_is_named(here, capsys, command, path):
    """The error names the output path if a file is in the place of its folder, or if its folder does not exist."""
    hand_in(here, {"results": json.dumps(result("ada").record()) + "\n"}, file="results.jsonl")
    (here / "grades.csv").write_text(f"student,assignment,score,max_score\nada,{SLUG},1,1\n")
    (here / "file").touch()
    assert grader.main([*command.split(), path]) == 2
    err = capsys.readouterr().err
    assert f"tam570-grader: error: cannot write to {path}" in err and len(err.splitlines()) == 2


@pytest.mark.parametrize("shell", ["bash", "zsh", "tcsh"])
def test_a_shell_completes_every_command(shell):
    command = [sys.executable, "-m", "tam570_grader", "completion", shell]
    script = subprocess.run(command, capture_output=True, check=True, text=True).stdout
    assert all(name in script for name in ("grade", "gradescope", "against", "vary"))
