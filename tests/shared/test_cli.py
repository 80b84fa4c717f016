"""The students' command: list, start, hint, handin, update, bad usage, imports, and where it finds work."""

import errno
import os
import shutil
import zipfile
from pathlib import Path

import pytest
from classes import notebook
from parameters import first
from processes import imported_modules

from tam570 import cli, course, predictions, releases
from tam570.course import contract
from tam570.handin import ACCURACY

SLUG = "hw08_axis_angle"
HEAVY = {"numpy", "scipy", "matplotlib", "sympy", "pytest", "numba", "nbgrader", "tqdm", "hatchling", "shtab"}
COMMANDS = ["list", "start hw08", "hint hw08 skew", "update hw08"]
MORE = "\n\ndef unskew(matrix, *, scale):\n    raise NotImplementedError\n"


def test_a_light_command_imports_no_numerical_library(hw08):
    code = f"from tam570.cli import main\nassert not any(main(command.split()) for command in {COMMANDS})"
    assert not imported_modules(code) & HEAVY


def test_an_assignment_goes_by_any_part_that_tells_it():
    for name in ("hw12", "12", "HW12", "bead", "bead-on-wire", "bead_on_wire"):
        assert course.folder(name).name == "hw12_bead_on_wire"
    assert course.folder("2").name == course.folder("02").name == "hw02_ballistics"
    for name in ("pendulum", "rolling", "x", "hw99", "hw8.txt", "hw080", "", "123"):
        with pytest.raises(course.Unknown):
            course.folder(name)


def test_start_gives_the_problem_the_stub_and_the_tests_and_overwrites_nothing(hw08):
    stub = hw08(None)
    names = {"README.md", "figure.svg", stub.name, f"test_{stub.name}"}
    assert {path.name for path in stub.parent.glob("[!.]*")} == names
    stub.write_text("my work")
    (stub.parent / "README.md").unlink()
    assert cli.main(["start", "hw08"]) == 0
    assert stub.read_text() == "my work" and (stub.parent / "README.md").exists()


def test_start_on_a_full_disk_leaves_no_part_of_a_file(here, monkeypatch, capsys):
    def full(source, target):
        Path(target).touch()
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(target))

    monkeypatch.setattr(shutil, "copyfile", full)
    assert cli.main(["start", "hw08"]) == 2 and "No space left" in capsys.readouterr().err
    assert not list((here / SLUG).iterdir())


def test_start_in_the_folder_of_an_assignment_puts_another_one_beside_it(hw08, desk, monkeypatch):
    monkeypatch.chdir(hw08().parent)
    assert cli.main(["start", "hw09"]) == 0
    assert (desk / "hw09_book" / "hw09_book.py").exists()


PLACES = [(f"{SLUG}/plots", "hw08"), ("hw09_book", "hw08"), (".", "mine.py --assignment axis_angle")]
PLACES += [(".", "hw08"), (SLUG, "hw08"), (".", SLUG), (".", f"{SLUG}/{SLUG}.py")]


@pytest.mark.parametrize(("folder", "what"), first(3, PLACES))
def test_check_knows_where_it_is_and_takes_a_folder_and_any_file(hw08, desk, tam570, in_process, folder, what):
    """`check` works above the folder of the assignment, in it, below it, and in the folder of another assignment."""
    (desk / "mine.py").write_text(hw08().read_text())
    (desk / folder).mkdir(exist_ok=True)
    code, said = tam570("check", *what.split(), cwd=desk / folder)
    assert code == 0 and "all done here" in said


def test_check_without_a_name_means_the_folder_where_it_is_given(hw08, desk, tam570, in_process):
    cli.main(["start", "hw03"])
    hw08()
    assert "hw03" not in tam570("check", cwd=desk / SLUG)[1]
    assert tam570("check")[1].startswith("hw03: nothing is written yet")


BAD = {  # arguments: words of the message
    "check": "start hw",
    "check hw08": "start hw08",
    "check no.py": "no.py",
    "check README.md": ".ipynb",
    "check mine.py": "which assignment",
    "check hw08_ballistics.py": "hw08_axis_angle or hw02_ballistics",
    "check hw99": "tam570 list",
    "show hw08": "hw08",
    "check oscillator": "tam570 show oscillator",
    "check double_pendulm": "double_pendulum?",
    "start x": "list --lectures",
    "show oscilator": "oscillator?",
    "start pendulum": "hw01_simple_pendulum, hw05_constrained_pendulum, hw07_double_pendulum",
    "hint hw08 nothing": "skew",
    "check hw09 --watch": "start hw09",
    "start hw0": "hw01_simple_pendulum, hw02_ballistics",
}


@pytest.mark.parametrize("arguments", BAD)
def test_bad_usage_exits_2_and_says_what_to_do(desk, capsys, arguments):
    for name in ("README.md", "mine.py", "hw08_ballistics.py"):
        (desk / name).write_text("text")
    assert cli.main(arguments.split()) == 2
    err = capsys.readouterr().err
    assert BAD[arguments] in " ".join(err.split()) and max(map(len, err.splitlines())) <= 80


def line(capsys):
    capsys.readouterr()
    assert cli.main(["list"]) == 0
    out = capsys.readouterr().out
    return next(row for row in out.splitlines() if row.startswith(SLUG)), out


def test_list_tells_points_next_step_and_a_change_since(hw08, capfd, tam570, in_process):
    hw08(None)
    assert line(capfd)[0].endswith("started")
    tam570("check", "hw08")
    assert "0 of 10, next: skew" in line(capfd)[0]
    hw08()
    assert "changed since" in line(capfd)[0]
    assert "10 of 10 points by the visible tests" in tam570("check", "hw08")[1]
    said, out = line(capfd)
    assert said.endswith("10 of 10, done")
    assert out.endswith("10 of 10 points by the visible tests of what you have checked here\n")


def hinted(capsys, *more):
    capsys.readouterr()
    assert cli.main(["hint", "hw08", "skew", *more]) == 0
    out, err = capsys.readouterr()
    assert not err
    return out


def test_hints_go_one_step_further_each_time(desk, capsys):
    said = [hinted(capsys) for _ in range(3)]
    assert said[0] != said[1] == said[2] and "(1 of 2)" in said[0] and "last" in said[1]
    assert hinted(capsys, "--again") == said[0]
    assert hinted(capsys, "--all") == said[0] + said[1]


@pytest.mark.parametrize("text", ["", "[1]", "null", f'{{"{SLUG} skew": "two"}}', f'{{"{SLUG}": {{"skew": 1}}}}'])
def test_what_is_no_memory_of_hints_is_overwritten(desk, capsys, tmp_path, text):
    (tmp_path / "home").mkdir()
    (tmp_path / "home" / "hints.json").write_text(text)
    assert "(1 of 2)" in hinted(capsys) and "(2 of 2" in hinted(capsys)


def test_in_the_folder_a_function_is_enough_for_a_hint(hw08, monkeypatch, desk, capsys):
    file = hw08(None)
    monkeypatch.chdir(file.parent)
    assert cli.main(["hint", "skew"]) == 0 and "(1 of 2)" in capsys.readouterr().out
    assert cli.main(["hint"]) == 0 and "rotate" in capsys.readouterr().out
    assert cli.main(["hint", "mass_matrix"]) == 2 and "'mass_matrix' is not an" in capsys.readouterr().err


def test_handin_packs_the_work_and_names_what_is_empty(hw08, desk, tam570, solution_text):
    file = hw08(None)
    stub = file.read_text()
    file.write_text(stub.replace("raise Not", "n = axis\n    raise Not"))  # a function that is begun
    (file.parent / "plot.png").write_bytes(b"png")
    code, said = tam570("handin", "hw08")
    packed = file.with_name("hw08_axis_angle_handin.zip")
    assert code == 0 and zipfile.ZipFile(packed).namelist() == ["hw08_axis_angle.py", "plot.png"]
    assert "not written yet: skew, rotation_matrix, rotate" in said
    file.write_text("x = (")
    assert "Python cannot read hw08_axis_angle.py" in tam570("handin", "hw08")[1]
    file.with_suffix(".ipynb").write_text(notebook(solution_text("hw08_axis_angle")))
    file.write_text(stub)  # an empty module, which would be graded in the place of the notebook
    assert tam570("handin", "hw08")[0] == 0
    assert zipfile.ZipFile(packed).namelist() == ["hw08_axis_angle.ipynb", "plot.png"]
    file.write_text("def skew(v):\n    return v\n")
    assert "not written yet: rotation_matrix, rotate" in tam570("handin", "hw08")[1]


def test_handin_names_the_parts_that_a_teacher_grades_where_nothing_is_in_for_them(desk, tam570):
    assert cli.main(["start", "hw09"]) == 0
    remark, folder = "Your teacher grades by hand: part ", desk / "hw09_book"
    assert remark in tam570("handin", "hw09")[1]
    (folder / "sketch.png").write_bytes(b"png")
    assert remark not in tam570("handin", "hw09")[1]


def test_a_prediction_is_asked_for_once_and_kept(desk, monkeypatch):
    answers = iter(["", "it flips"])
    monkeypatch.setattr(predictions, "_is_attended", lambda: True)
    monkeypatch.setattr("builtins.input", lambda question: next(answers))
    assert "no prediction" in predictions.ask_for_predictions(desk, "hw10_free_rigid_body")[0]
    answered = predictions.ask_for_predictions(desk, "hw10_free_rigid_body")
    assert answered[0].endswith(": it flips") and (desk / "prediction_b.txt").is_file()
    assert predictions.ask_for_predictions(desk, "hw10_free_rigid_body") == answered
    assert predictions.ask_for_predictions(desk, "hw08_axis_angle") == []


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
def test_update_brings_what_was_not_touched_and_names_the_rest(
    hw08, tmp_path, monkeypatch, capsys, name, text, mine, recorded, message
):
    """After hw08 was started, a new kit has more text in one of its files."""
    file, home = hw08(None).parent / name, tmp_path / "assignments"
    shutil.copytree(course.folder(SLUG).parent, home)
    monkeypatch.setattr(course, "_home", lambda: home)
    released = home / SLUG / name
    released.write_text(released.read_text() + text)
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
    """`check --final` reads the accuracy from the README, which has one if the assignment simulates a motion."""
    simulates = any(name.startswith("simulate") for name in contract(slug)["results"])
    assert len(ACCURACY.findall((course.folder(slug) / "README.md").read_text())) == simulates
