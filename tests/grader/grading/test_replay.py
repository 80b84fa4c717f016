"""`tam570-grader replay` prints the call that failed, and repeats it."""

import re

import pytest
from classes import HW08, hand_in, notebook, results
from parameters import first

from tam570_grader import cli
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import mistakes

HW04, HW12 = "hw04_hanging_spring", "hw12_bead_on_wire"
MISTAKES = {mistake.name: mistake for mistake in mistakes(assignments.checks_folder(assignments.find(), HW08))}
SUBTRACTED = MISTAKES["square_subtracted"]
FAILURES = {  # name: (slug, code that is appended to the solution, words after `now`)
    "raises": (HW08, "def skew(v):\n    raise KeyError(v)", "skew raised KeyError"),
    "none": (HW08, "def skew(v):\n    return None", "skew returned None, not real numbers"),
    "nan": (HW08, "def skew(v):\n    return np.full((3, 3), np.nan)", "skew returned NaN"),
    "accepts": (HW08, "def rotation_matrix(axis, angle):\n    return np.eye(3)", "np.array([[1.0, 0.0, 0.0]"),
    "formula": (HW12, "def lagrange_equation(right=lagrange_equation):\n    return -right()", "np.array(["),
    "symbol": (HW12, "def lagrange_equation():\n    return sympy.Symbol('q')", "SymPy expression"),
    "drawing": (HW04, "def plot_projection(ax, *_, **__):\n    ax.plot(range(20), range(20))", "19.0]"),
    "undrawn": (HW04, "def plot_projection(ax, *_, **__):\n    ax.no()", "raised AttributeError"),
}
SPOKEN = {
    "def rotation_matrix(axis, angle:": "was never closed",
    "def rotation_matrix(axis, angle):\n    raise NotImplementedError": "rotation_matrix is not written yet.",
    "x = 1": "Your file has no function rotation_matrix.",
    "1 / 0": "ZeroDivisionError",
    "def rotation_matrix(axis, angle):\n    while True: pass": "rotation_matrix did not return",  # takes 10 s
}


@pytest.fixture(scope="module")
def graded(tmp_path_factory, course):
    """Return the folder of a graded class: a failure of each form, half in notebooks; ada's matrix has a wrong sign."""
    folder = tmp_path_factory.mktemp("failures")
    for number, (name, (slug, wrong, _)) in enumerate(FAILURES.items()):
        text = f"{(course / 'solutions' / f'{slug}.py').read_text()}\nimport sympy\n\n{wrong}\n"
        text, suffix = (notebook(text), "ipynb") if number % 2 else (text, "py")
        hand_in(folder / "submitted", {name: text}, slug, "{0}/{0}." + suffix)
    solution = (course / "solutions" / f"{HW08}.py").read_text()
    hand_in(folder / "submitted", {"ada": f"{solution}\n\n{SUBTRACTED.text}"})
    (folder / "right.py").write_text(solution)
    arguments = ["--out", str(folder / "out"), "--seed", "3", "--call", "1", "--jobs", "1"]
    assert cli.main(["--root", str(course), "grade", str(folder / "submitted"), *arguments]) == 0
    return folder


@pytest.fixture
def replayed(graded, course, capsys):
    """`replayed(student, check, file)` -> the output of `replay`."""

    def replayed(student, check, file):
        capsys.readouterr()
        assert cli.main(["--root", str(course), "replay", str(graded / "out"), student, check, str(file)]) == 0
        return capsys.readouterr().out

    return replayed


def numbers(said, what):
    line = re.search(rf"^{what}: +(.+)$", said, re.MULTILINE)[1]
    return [float(number) for number in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", line)]


def test_the_call_is_printed_whole_and_made_again(graded, replayed):
    check = SUBTRACTED.first_fails
    said = replayed("ada", check, graded / "submitted" / "ada" / HW08 / f"{HW08}.py")
    assert numbers(said, "now") == numbers(said, "actual") != numbers(said, "expected")
    assert "(np.array([" in said, "what was an array is one where the call is pasted"
    said = replayed("ada", check, graded / "right.py")
    assert numbers(said, "now") == pytest.approx(numbers(said, "expected"), abs=1e-12)


@pytest.mark.parametrize("name", FAILURES)
def test_every_form_of_failure_is_made_again(graded, replayed, name):
    slug, wrong, words = FAILURES[name]
    checks = next(record["checks"] for record in results(graded / "out") if record["student"] == name)
    function = re.match(r"def (\w+)", wrong)[1]
    failed = [check["name"] for check in checks if check.get("failure", {}).get("function") == function]
    said = replayed(name, failed[-1], next((graded / "submitted" / name / slug).iterdir()))
    assert f"\n{function}(" in said and words in said.rpartition("now:")[2]


@pytest.mark.parametrize("text", first(len(SPOKEN) - 1, SPOKEN))
def test_what_cannot_be_run_says_why(replayed, tmp_path, text):
    (tmp_path / "new.py").write_text(text)
    said = replayed("ada", SUBTRACTED.first_fails, tmp_path / "new.py")
    assert SPOKEN[text] in said.rpartition("now:")[2]
