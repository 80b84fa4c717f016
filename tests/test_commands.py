"""The students' command as a student runs it, the kit that they install, and what each command imports."""

import errno
import itertools
import json
import shutil
import signal
import subprocess
import sys
import zipfile

import pytest

from tam570 import cli
from tam570 import course as released
from tam570_grader import cli as grader
from tam570_grader.delivery.kit import run as make_kit
from tam570_grader.results import journal
from tam570_grader.writing import assignments

SLUG = "hw08_axis_angle"
HEAVY = {"scipy", "matplotlib", "sympy", "pytest", "numba", "nbgrader", "tqdm", "hatchling", "IPython"}

EXACT = """
import runpy
import numpy as np
import sympy

def exact(value):
    if isinstance(value, tuple):
        return [exact(one) for one in value]
    numbers = isinstance(value, float | np.ndarray | np.generic)
    return np.vectorize(sympy.Float, otypes=[object])(value) if numbers else value

def strict(function):
    def called(*args, **kwargs):
        for value in (*args, *kwargs.values()):
            steps = isinstance(value, list) and all(isinstance(one, tuple) for one in value)
            plain = steps or isinstance(value, str | float | int) or hasattr(value, "plot")
            assert plain or value.dtype == float, value
        return exact(function(*args, **kwargs))
    return called

right = runpy.run_path({solution!r})
globals().update((name, strict(right[name])) for name in right["__all__"])
"""


@pytest.fixture
def desk(tmp_path, monkeypatch):
    """A student's empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TAM570_HOME", str(tmp_path / "home"))
    return tmp_path


def imported(code):
    """The top-level modules that a fresh interpreter has loaded after running the code."""
    text = f"import sys\n{code}\nprint(*{{name.partition('.')[0] for name in sys.modules}}, file=sys.stderr)"
    process = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    return set(process.stderr.split())


@pytest.mark.parametrize("command", ["list", "start hw08", "hint hw08 skew"])
def test_the_students_command_imports_no_numerical_library(desk, command):
    code = f"from tam570.cli import main\nassert main({command.split()}) == 0"
    assert not imported(code) & (HEAVY | {"numpy"})


def test_grading_hw08_imports_numpy_and_nothing_heavier(desk, course):
    path = course / "solutions" / f"{SLUG}.py"
    code = f"from tam570_grader.cli import main\nassert main(['--root', {str(course)!r}, 'grade', {str(path)!r}]) == 0"
    modules = imported(code)
    assert "numpy" in modules and not modules & HEAVY


def test_the_help_of_the_grader_imports_nothing_heavy(desk):
    code = "from tam570_grader.cli import main\ntry: main(['grade', '--help'])\nexcept SystemExit: pass"
    assert not imported(code) & HEAVY


def test_where_the_grader_cannot_run_it_says_so_in_one_line(desk):
    program = "import os; os.name = 'nt'; import tam570_grader"
    found = subprocess.run([sys.executable, "-c", program], cwd=desk, capture_output=True, text=True, check=False)
    assert found.returncode == 1 and found.stderr.startswith("tam570-grader: error: the grader needs Linux")
    assert len(found.stderr.splitlines()) == 1


def test_every_assignment_is_listed(desk, capsys, course):
    assert cli.main(["list"]) == 0
    assert (
        [line.split()[0] for line in capsys.readouterr().out.splitlines()]
        == assignments.slugs(course)
        == released.assignments()
    )


def test_start_gives_the_problem_the_stub_and_the_tests_and_overwrites_nothing(desk):
    assert cli.main(["start", "hw08"]) == 0
    stub = desk / SLUG / f"{SLUG}.py"
    assert {path.name for path in stub.parent.iterdir()} >= {"README.md", stub.name, f"test_{stub.name}"}
    stub.write_text("my work")
    (stub.parent / "README.md").unlink()
    assert cli.main(["start", "hw08"]) == 0
    assert stub.read_text() == "my work" and (stub.parent / "README.md").exists()


def checked(*arguments):
    process = subprocess.run(
        [sys.executable, "-m", "tam570.cli", "check", *map(str, arguments)], capture_output=True, text=True
    )
    return process.returncode, process.stdout + process.stderr


def test_the_visible_tests_pass_on_the_solution_and_fail_on_the_stub(desk, slug, course):
    code, said = checked(course / "solutions" / f"{slug}.py")
    assert code == 0, said
    code, said = checked(course / "assignments" / slug / f"{slug}.py")
    assert code == 1 and "is not written yet" in said and "passed" not in said.splitlines()[-1]


RIGHT = sorted((assignments.find() / "autograder" / "checks").glob("*/alternatives/*.py"))


@pytest.mark.parametrize("path", RIGHT, ids=[f"{path.parents[1].name[:4]}-{path.stem}" for path in RIGHT])
def test_the_visible_tests_pass_on_right_answers_in_other_styles(desk, path):
    shutil.copy(path, desk / f"{path.parents[1].name}.py")
    code, said = checked(desk / f"{path.parents[1].name}.py")
    assert code == 0, said


def test_the_visible_tests_take_any_numbers_and_give_arrays(desk, slug, course):
    """SymPy's numbers and arrays of them are right results; only hw09's steps are given as a list."""
    name = f"{slug}.py"
    (desk / name).write_text(EXACT.format(solution=str(course / "solutions" / name)))
    shutil.copy(course / "assignments" / slug / f"test_{name}", desk)
    code, said = checked(desk / name)
    assert code == 0, said


def test_check_finds_what_was_started(desk, solution_text):
    cli.main(["start", "hw08"])
    (desk / SLUG / f"{SLUG}.py").write_text(solution_text(SLUG))
    assert checked()[0] == checked("hw08")[0] == checked(f"{SLUG}/{SLUG}.py")[0] == 0


@pytest.mark.parametrize("text", ["def skew(v:", "1 / 0", "import sys; sys.exit(0)"])
def test_a_file_that_cannot_be_imported_is_said_so(desk, text):
    (desk / "hw08.py").write_text(text)
    code, said = checked("hw08.py")
    assert code == 1 and "cannot be imported" in said


BAD = ["check", "check hw08", "check no.py", "check hw99", "start x", "hint hw08 nothing", "hint hw99"]


@pytest.mark.parametrize("arguments", BAD)
def test_bad_usage_exits_2_and_says_what_to_do(desk, capsys, arguments):
    assert cli.main(arguments.split()) == 2
    assert "tam570: error: " in capsys.readouterr().err


@pytest.mark.parametrize(("arguments", "state"), [(["hw08"], "hw08 is not"), ([], "nothing is")])
def test_what_is_not_started_is_said_so(desk, capsys, arguments, state):
    cli.main(["check", *arguments])
    assert f"{state} started here; begin with: tam570 start hw" in capsys.readouterr().err


def test_hints_go_one_step_further_each_time(desk, capsys):
    said = []
    for _ in range(3):
        cli.main(["hint", "hw08", "skew"])
        said.append(capsys.readouterr().out)
    assert said[0] != said[1] == said[2] and "(1 of 2)" in said[0] and "last" in said[1]
    cli.main(["hint", "hw08", "skew", "--again"])
    assert capsys.readouterr().out == said[0]


@pytest.fixture
def graded(desk):
    """Results in a folder, beside a file."""
    (desk / "results").mkdir()
    record = {**dict.fromkeys(journal.RESULT, 0), "student": "ada", "assignment": SLUG, "checks": [], "max_score": 1}
    (desk / "results" / "results.jsonl").write_text(json.dumps(record) + "\n")
    (desk / "grades.csv").write_text(f"student,assignment,score,max_score\nada,{SLUG},1,1\n")
    (desk / "file").touch()


FOLDERS = "kit", "course", "gradescope"
FILES = "report results --out", "lms grades.csv --to canvas --out", "audit hw08 --fairness 1 --jobs 1 --keep"


@pytest.mark.parametrize(
    ("command", "place"),
    [*itertools.product(FOLDERS, ["file", "file/x"]), *itertools.product(FILES, ["none/x", "file/x"])],
)
def test_what_cannot_be_written_is_named(graded, capsys, command, place):
    assert grader.main([*command.split(), place]) == 2
    err = capsys.readouterr().err
    assert err.startswith(f"tam570-grader: error: cannot write to {place}") and len(err.splitlines()) == 1


def test_a_disk_that_fails_is_told_in_a_line(desk, capsys, monkeypatch):
    def full(arguments):
        raise OSError(errno.ENOSPC, "No space left on device", "x")

    monkeypatch.setattr("tam570_grader.delivery.command._kit", full)
    assert grader.main(["kit", "x"]) == 1
    assert capsys.readouterr().err == "tam570-grader: error: [Errno 28] No space left on device: 'x'\n"


@pytest.fixture
def handlers():
    """Those of the signals that the command listens to are set back."""
    ours = {one: signal.getsignal(one) for one in (signal.SIGINT, signal.SIGTERM)}
    yield
    for one, handler in ours.items():
        signal.signal(one, handler)


@pytest.mark.parametrize("first", [signal.SIGINT, signal.SIGTERM])
def test_a_second_interrupt_ends_what_the_first_puts_away(handlers, monkeypatch, first):
    monkeypatch.setattr("tam570_grader.delivery.command._kit", lambda arguments: signal.raise_signal(first))
    assert grader.main(["kit", "x"]) == 130
    assert signal.getsignal(signal.SIGINT) == signal.SIG_DFL


def test_stubs_are_written_and_compared(tmp_path, capsys, course):
    for path in (f"solutions/{SLUG}.py", f"autograder/checks/{SLUG}/checks.py"):
        (tmp_path / path).parent.mkdir(parents=True)
        (tmp_path / path).write_text((course / path).read_text())
    assert grader.main(["--root", str(tmp_path), "stubs", "--check"]) == 1
    assert "run tam570-grader stubs" in capsys.readouterr().err
    assert grader.main(["--root", str(tmp_path), "stubs"]) == 0
    assert grader.main(["--root", str(tmp_path), "stubs", "--check"]) == 0


@pytest.fixture(scope="module")
def kit(tmp_path_factory, course):
    folder = tmp_path_factory.mktemp("kit")
    assert make_kit(course, folder) == 0
    return folder


def test_the_kit_holds_the_assignments_and_no_secret(kit, course):
    (wheel,) = kit.glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        texts = b"\n".join(archive.read(name) for name in names if "/grader/" not in name)
    assert wheel.name in (kit / "README.md").read_text()
    assert {f"tam570/assignments/{slug}/{slug}.py" for slug in assignments.slugs(course)} <= set(names)
    assert not [name for name in names if "solutions" in name or "checks/" in name or "__pycache__" in name]
    for slug in assignments.slugs(course):
        first = assignments.assignment(course, slug).checks[0]
        assert f"def {first.name}".encode() not in texts


@pytest.mark.full
def test_a_student_installs_the_kit_in_an_empty_environment_and_works(kit, tmp_path):
    (wheel,) = kit.glob("*.whl")
    python = tmp_path / "env" / "bin" / "python"
    for command in (
        [sys.executable, "-m", "venv", tmp_path / "env"],
        [python, "-m", "pip", "install", "-q", wheel],
        [python, "-m", "tam570.cli", "start", "hw08"],
    ):
        subprocess.run(command, check=True, cwd=tmp_path)
    process = subprocess.run(
        [python, "-m", "tam570.cli", "check", "hw08"], cwd=tmp_path, capture_output=True, text=True
    )
    assert process.returncode == 1 and "is not written yet" in process.stdout
