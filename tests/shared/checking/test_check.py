"""`check` predicts the grader: it finds the errors that would cost points, and explains them to the student."""

import os
import subprocess
import sys

import pytest
from parameters import first

from tam570.checking.examples import OR_ANOTHER, Examples, closed, fingerprint, load_examples
from tam570.checking.visible import difference
from tam570.course import folder
from tam570_grader.sandbox.zygote import ResourceLimits

TOP = {  # code above the solution: words that `check` prints
    "import scipy.spatial.transform": "scipy.spatial.transform",
    "import pandas as pd": "pandas",
    "1 / 0": "ZeroDivisionError",
    "x = 1\ndef skew(v:\n": "Line 2: SyntaxError",
    "from tam570.rotations import exp": "tam570.rotations",
    "import scipy.spatial; scipy.spatial.transform.Rotation.identity()": "scipy.spatial.transform",
    "import my_helpers": "my_helpers",
    "x = input('angle? ')": "EOFError",
    "x = open('data.csv').read()": "FileNotFoundError",
    "import sys; sys.exit(0)": "SystemExit",
    "while True: pass": "longer than 2 s",
    "import time; time.sleep(60)": "longer than 2 s",
}
CALLS = {
    "import os; os._exit(0)": "rotate ended the process that tests it",
    "return [1.0, 2.0]": "rotate returned an array of shape (2,), not",
    "r[:] = r + np.cross(axis, r); return r": "rotate changes the arrays",
    "return rotation_matrix(axis, angle) @ r": "rotation_matrix is off limits in rotate",
    "return None": "rotate returned None, not real numbers. Is a `return` missing?",
    "while True: pass": "rotate did not return within 2 s",
    "return r * float('nan')": "NaN",
    "return 'a vector'": "rotate returned 'a vector', not real numbers",
    "return r + nothing": "NameError",
    "import pandas": "pandas",
    "import time; time.sleep(100)": "rotate did not return within 2 s",
    "return same(axis, angle) @ r\n\nsame = rotation_matrix": "rotation_matrix is off limits in rotate",
    "return kept[0](axis, angle) @ r\n\nkept = [rotation_matrix := (lambda f: lambda *of: f(*of))(rotation_matrix)]": (
        "rotation_matrix is off limits in rotate"
    ),
    "raise NotImplementedError": "not written yet: rotate",
    "return r\n\ndel rotate": "Your file has no function rotate.",
    "return open('data.csv').read()": "FileNotFoundError",
    "import itertools; sum(itertools.count())": "rotate did not return within 2 s, and cannot be interrupted.",
}
INTEGRATORS = {
    "from scipy.integrate import solve_ivp": "solve_ivp(lambda t, y: y, (0, 1), [1.0])",
    "from scipy import integrate": "integrate.solve_ivp(lambda t, y: y, (0, 1), [1.0])",
    "import scipy.integrate": "scipy.integrate.solve_ivp(lambda t, y: y, (0, 1), [1.0])",
    "from tam570 import integrate as ours": "ours.solve(lambda t, y: y, [0.0, 1.0], [1.0])",
}
HW08 = "hw08_axis_angle"
TESTS = 11 + len(load_examples(folder(HW08)).calls)
BRIEF = {"TAM570_CALL_LIMIT": "2"}  # s, only for calls that hang: on a busy machine, importing SciPy may take as long
NAMED = "import scipy.spatial\nTurn = scipy.spatial.transform.Rotation\n"


@pytest.fixture
def words(edited, tam570, in_process):
    """`words(slug, below)` -> what `check` prints of the solution with this text below it, in one line; it fails."""

    def words(slug, below):
        code, said = tam570("check", edited(slug, below))
        assert code == 1
        return " ".join(said.split())

    return words


@pytest.mark.parametrize("above", first(4, TOP))
def test_what_stops_the_import_where_work_is_graded_stops_it_here(hw08, desk, tam570, grade, above):
    file = hw08(above=above + "\n")
    (file.parent / "data.csv").write_text("1\n")
    (desk / "data.csv").write_text("1\n")
    code, said = tam570("check", **(BRIEF if "2 s" in TOP[above] else {}))
    assert code == 1 and " ".join(TOP[above].split()) in " ".join(said.split())
    assert "The grader would give this file 0 points." in said and "Traceback" not in said
    result = grade(HW08, file.read_text(), limits=ResourceLimits(call=2))
    assert result.status != "graded" and result.score == 0


@pytest.mark.parametrize("above", [NAMED, "try:\n    import pandas\nexcept ImportError:\n    pandas = None\n"])
def test_what_is_off_limits_or_missing_may_be_named(hw08, tam570, in_process, grade, above):
    """`check` and the grader accept a module that is forbidden or missing if no function of it is called."""
    text = hw08(above=above).read_text()
    assert tam570("check")[0] == 0 and grade(HW08, text).score == 10


def test_a_file_in_another_encoding_names_the_line(hw08, tam570, in_process, grade):
    latin = b"x = 1\n# caf\xe9\n" + (file := hw08()).read_bytes()
    utf16, declared = latin.decode("latin-1").encode("utf-16"), b"# coding: latin-1\n" + latin
    for text, line in (latin, "line 2: a "), (utf16, "line 1: a "), (declared, ""):
        file.write_bytes(text)
        code, said = tam570("check")
        assert code == 0 and line in said and ("not UTF-8" in said) == bool(line) and grade(HW08, text).score == 10


@pytest.mark.parametrize("body", first(4, CALLS))
def test_what_a_call_does_wrong_is_said_at_once_and_costs_its_points_alone(hw08, tam570, grade, body, request):
    if "2 s" not in CALLS[body] and "_exit" not in body:  # the others hang or exit, so they need their own process
        request.getfixturevalue("in_process")
    file = hw08(f"def rotate(r, axis, angle):\n    {body}")
    code, said = tam570("check", **(BRIEF if "2 s" in CALLS[body] else {}))
    assert code == 1 and CALLS[body] in " ".join(said.split()) and "next: rotate" in said
    assert f"of {TESTS} tests pass; 6 of 10 points" in said, "the other tests are run, hang or not"
    result = grade(HW08, file.read_text(), limits=ResourceLimits(call=2))
    assert result.status == "graded" and 0 < result.score < 10


def test_a_number_of_results_is_compared_and_not_unpacked(words):
    said = words("hw07_double_pendulum", "def on_the_fly(*a, **k):\n    return np.zeros(3)")
    assert "on_the_fly returned 3 results, not a tuple of 2 results" in said


@pytest.mark.parametrize("above", first(1, INTEGRATORS))
def test_what_is_off_limits_in_one_function_may_be_used_in_the_others(words, above):
    calling = f"def trajectory(*args, **how):\n    {INTEGRATORS[above]}\n    return kept(*args, **how)"
    said = words("hw02_ballistics", f"{above}\nkept = trajectory\n\n{calling}")
    assert "off limits in trajectory" in said
    assert "test_drag" not in said and "drag is against the velocity" not in said


def test_prints_do_not_bury_the_failure(hw08, tam570):
    hw08("print('hello')\n\ndef rotate(r, axis, angle):\n    for i in range(5000): print('value', i)\n    return None")
    said = tam570("check")[1]
    assert "hello" in said and "value 4999" in said and "value 4990" not in said
    assert len(said.splitlines()) < 30 and max(map(len, said.splitlines())) <= 80


def test_a_terminal_without_greek_letters_is_enough(edited):
    file = edited("hw06_braking", "def axle_load(*a, **k):\n    return 'Ω²'")
    command = [sys.executable, "-m", "tam570", "check", file.name, "--final"]
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    run = subprocess.run(command, capture_output=True, text=True, env=environment)
    assert run.returncode == 1 and not run.stderr
    assert "Traceback" not in run.stdout and "axle_load returned '" in run.stdout and "10??" in run.stdout


@pytest.mark.parametrize("tests", ["", "x = 1\ndef test(:\n", "import nothing_at_all\n\ndef test_mine(): pass\n"])
def test_nothing_beside_the_work_has_a_say(hw08, tam570, tests):
    """`check` ignores an empty or broken module of tests, conftest.py, options of pytest, and a file random.py."""
    file = hw08("def rotate(r, axis, angle):\n    return 2 * np.asarray(r)\n")
    (file.parent / f"test_{file.name}").write_text(tests)
    (file.parent / "conftest.py").write_text("raise SystemExit")
    (file.parent / "random.py").write_text("raise SystemExit")
    code, said = tam570("check", PYTEST_ADDOPTS="-k nothing", cwd=file.parent)
    assert code == 1 and f"of {TESTS} tests pass" in said and "next: rotate" in said


def test_a_test_of_ones_own_is_run_beside_the_released_ones(hw08, tam570, in_process):
    file = hw08()
    mine = "import hw08_axis_angle as hw\n\ndef test_mine():\n    assert hw.skew([1.0, 0.0, 0.0])[2][1] == 3\n"
    (file.parent / f"test_{file.name}").write_text(mine)
    code, said = tam570("check")
    assert code == 1 and "Your code gives 1; 3 is right." in said and f"of {TESTS + 1} tests pass" in said


@pytest.mark.parametrize(("actual", "numbers"), [(1 + 1e-12, ["1.000000000001", "1"]), (4.5 + 0j, ["4.5", "1"])])
def test_two_numbers_that_differ_are_written_differently_and_real_ones_as_real(actual, numbers):
    gives, is_right = difference(actual, 1.0).removesuffix(" is right.").split("; ")
    assert [gives.rpartition(" ")[2][:14], is_right] == numbers


def test_a_function_that_agrees_with_no_wrong_one_is_right_all_the_same(hw08, tam570, in_process):
    hw08("def rotation_matrix(axis, angle):\n    return np.eye(3)\n")
    code, said = tam570("check")
    failure = said.partition("- rotate agrees with the matrix")[2].partition("\n- ")[0]
    assert code == 1 and " 5 of 10 points" in said and failure and "is right" not in failure


def test_a_mistake_has_numbers_where_the_student_has_and_not_the_right_ones():
    def mistake(result, *wrong, expected=2.0):
        calls = [{"function": "f", "compare": [{"member": None, "columns": None, "expected": expected}]}] * 2
        mistakes = [{"function": "f", "message": closed(f"You {n}."), "results": each} for n, each in enumerate(wrong)]
        return Examples(calls, mistakes, {0: expected, 1: result}).mistake("f")

    assert mistake(3.0, {"1": [fingerprint(3.0)]}).endswith(OR_ANOTHER)  # one number
    assert not mistake(3.0, *[{"1": [fingerprint(3.0)]}] * 2)
    assert not mistake([0.0, 3.0], {"1": [fingerprint([0.0, 3.0])]}, expected=[0.0, 2.0])
    assert not mistake(3.0, {"0": None, "1": [fingerprint(3.0)]}) and not mistake(2.0, {"1": [fingerprint(2 + 1e-9)]})


def test_one_function_is_tested_alone(hw08, tam570, in_process):
    hw08("def rotate(r, axis, angle):\n    return 2 * np.asarray(r)\n")
    assert tam570("check", "hw08", "skew")[0] == 0
    code, said = tam570("check", "hw08", "rotate")
    assert code == 1 and "hw08: 0 of " in said
    code, said = tam570("check", "hw08", "rotat")
    assert code == 2 and "skew, rotation_matrix, rotate" in " ".join(said.split())


def test_a_home_that_is_read_only_brings_no_warnings(edited, tam570):
    code, said = tam570("check", edited("hw02_ballistics"), HOME="/proc", TAM570_HOME="/proc/nothing")
    assert code == 0 and "atplotlib" not in said


HW10, HW13 = "hw10_free_rigid_body", "hw13_rolling_cylinder"
KNOWN = [  # (slug, function, expression that it returns instead, words that `check` prints)
    (HW08, "rotation_matrix", "kept(axis, angle).T", "Your result of rotation_matrix is transposed."),
    (HW08, "rotation_matrix", "kept(axis, np.radians(angle))", "In rotation_matrix, angle is read as degrees."),
    (HW13, "energy", "kept(*args, **how) / how['mass']", "should be multiplied by mass."),
    (HW13, "contact_inertia", "kept(phi, **{**how, 'offset': -how['offset']})", "sign, or offset has it"),
    ("hw01_simple_pendulum", "power_balance", "kept(*args, **how)[::-1]", "results of power_balance are exchanged."),
    ("hw07_double_pendulum", "gravity_terms", "-kept(*args, **how)", "gravity_terms has the opposite sign."),
    (HW08, "rotation_matrix", "2 * kept(axis, angle)", "rotation_matrix is twice as large as the right one."),
]
CARELESS = """
def simulate(t, theta0, omega0, *, length, gravity):
    def rates(t, y):
        return y[1], -gravity / length * np.sin(y[0])

    return {call}
"""
LOOSE = {
    "from scipy.integrate import solve_ivp": "solve_ivp(rates, t[[0, -1]], [theta0, omega0], t_eval=t).y.T",
    "import scipy.integrate as si": "si.solve_ivp(rates, t[[0, -1]], [theta0, omega0], t_eval=t, rtol=1e-4).y.T",
    "from scipy import integrate": "integrate.odeint(rates, [theta0, omega0], t, tfirst=True, rtol=1e-4, atol=1e-4)",
}


def test_what_follows_from_a_mistake_in_another_function_is_no_mistake(desk, tam570, in_process, solution_text):
    slug = "hw03_angular_momentum_rate"
    arm_and_force = "np.cross(r_p - r_c, mass * a_p)"
    text = solution_text(slug).replace(arm_and_force, "moment(r_p, a_p, r_c, mass=mass)")
    text = text.replace("return moment(", f"return -{arm_and_force} #", 1)
    (desk / f"{slug}.py").write_text(text)
    said = " ".join(tam570("check", f"{slug}.py")[1].split())
    assert "moment has the opposite sign" in said and "rate uses or repeats the mistake in moment" in said
    assert "In rate, " not in said


@pytest.mark.parametrize(("slug", "name", "body", "remedy"), first(5, KNOWN))
def test_a_known_mistake_is_named(words, slug, name, body, remedy):
    arguments = {"rotation_matrix": "axis, angle", "contact_inertia": "phi, **how"}.get(name, "*args, **how")
    said = words(slug, f"kept = {name}\n\n\ndef {name}({arguments}):\n    return {body}")
    assert "Your numbers match this mistake: " in said and remedy in said


HALVES = {
    "hw04_hanging_spring": ("velocity * np.sqrt(mass / stiffness)", "velocity"),
    HW08: ("* skew(n) @ r", "/ 2 * skew(n) @ r"),
}


@pytest.mark.parametrize("slug", HALVES)
def test_a_factor_two_that_other_numbers_refute_has_no_name(desk, tam570, in_process, solution_text, slug):
    (desk / f"{slug}.py").write_text(solution_text(slug).replace(*HALVES[slug]))
    code, said = tam570("check", f"{slug}.py")
    assert code == 1 and "twice" not in said and "half" not in said


@pytest.mark.parametrize("above", first(1, LOOSE))
def test_loose_tolerances_are_named(words, above):
    said = words("hw01_simple_pendulum", f"{above}\n{CARELESS.format(call=LOOSE[above])}")
    assert "It would pass with the tolerances rtol=1e-9, atol=1e-9 in simulate." in said


def test_what_leaves_nothing_but_zeros_is_no_mistake(edited, desk, tam570, in_process):
    """Reversing omega changes only the wrong result, into a correct zero; that does not show that omega is wrong."""
    wrong = "kept = euler_equations\n\n\ndef euler_equations(omega, *, inertia):\n"
    wrong += "    return kept(omega, inertia=inertia) + (np.count_nonzero(omega) == 1 and omega[0] > 0)"
    file = edited(HW10, wrong)
    test = "assert not hw.euler_equations(np.array([2.0, 0.0, 0.0]), inertia=np.array([1.0, 2.0, 3.0])).any()"
    mine = f"import numpy as np\nimport {HW10} as hw\n\n\ndef test_mine():\n    {test}\n"
    (desk / f"test_{HW10}.py").write_text(mine)
    code, said = tam570("check", file, "euler_equations")
    assert code == 1 and "match this mistake" not in said
