"""An assignment is six places: a fifteenth, a mass on a damped spring, is added to a copy of the course and graded."""

import json
import os
import shutil
import subprocess
import sys

import pytest

from tam570_grader import cli
from tam570_grader.checks import assignments

SLUG = "hw15_damped_spring"
SOLUTION = '''"""hw15: A mass on a damped spring."""

import numpy as np
from tam570.integrate import solve

__all__ = ["energy", "simulate"]


def energy(x, v, *, mass, stiffness):
    """Energy, J.

    x, v : m, m/s
    """
    return mass * v**2 / 2 + stiffness * x**2 / 2


def simulate(t, x, v, *, mass, stiffness, damping):
    """(n, 2) states x, v at the times t.

    t : (n,) s
    """
    return solve(_rates, t, [x, v], parameters={"mass": mass, "stiffness": stiffness, "damping": damping})


def _rates(t, state, *, mass, stiffness, damping):
    x, v = state
    return v, -(stiffness * x + damping * v) / mass
'''
RIGHT = '''"""What is right in hw15: the complex exponential."""

import numpy as np


def energy(x, v, mass, stiffness):
    return abs(complex(np.sqrt(stiffness) * x, np.sqrt(mass) * v)) ** 2 / 2


def motion(t, x, v, mass, stiffness, damping):
    decay = damping / (2 * mass)
    rate = np.sqrt(complex(stiffness / mass - decay**2))
    a, b = x, (v + decay * x) / rate
    s, fade = t - t[0], np.exp(-decay * (t - t[0]))
    place = (fade * (a * np.cos(rate * s) + b * np.sin(rate * s))).real
    turned = (fade * rate * (b * np.cos(rate * s) - a * np.sin(rate * s))).real
    return np.column_stack([place, turned - decay * place])
'''
CASES = '''"""Hidden inputs of hw15."""

from tam570_grader import Case, repeated_calls, uneven


def states(rng):
    spring = [{"mass": rng.uniform(1, 3), "stiffness": rng.uniform(2, 9)} for _ in range(5)]
    return [Case(*rng.uniform(-2, 2, 2), **parameters).labelled("a random spring") for parameters in spring]


def motions(rng):
    parameters = {"mass": rng.uniform(1, 3), "stiffness": rng.uniform(2, 9), "damping": rng.uniform(0.1, 0.4)}
    first = Case(uneven(rng, 9.0, 30), rng.uniform(1, 2), rng.uniform(1, 2), **parameters).labelled("a random start")
    return [first, *repeated_calls(rng, first)]
'''
CHECKS = '''"""Hidden checks of hw15."""

from tam570_grader import Assignment, Column, compare, check, compare_trajectory, number, rows

from . import cases, reference

FORMULA = 1e-9  # roundings make 1e-15
FOLLOWED = 1e-5  # solve_ivp at rtol 1e-9, atol 1e-9 is off by 1e-7
MOTION = (Column("the place", "m", [0]), Column("the velocity", "m/s", [1]))


@check("energy", points=4, part="a", line="of the mass and of the spring.")
def energy_is_kinetic_and_elastic(student, rng):
    compare(student.energy, reference.energy, cases.states(rng), tolerance=FORMULA, quantity="the energy", unit="J")


@check("simulate", points=6, part="b", line="place and velocity at uneven times.")
def simulation_follows_the_motion(student, rng):
    compare_trajectory(student.simulate, reference.motion, cases.motions(rng), MOTION, tolerance=FOLLOWED)


ASSIGNMENT = Assignment(returns={"energy": number, "simulate": rows(2)}, forbidden={}, needs=("numpy",))
'''
SLIP = """
def _rates(t, state, *, mass, stiffness, damping):
    x, v = state
    return v, -(stiffness * x - damping * v) / mass
"""
MISTAKES = '''"""Known mistakes of hw15."""

from tam570_grader.diagnosis.mistakes import mistake

from .checks import energy_is_kinetic_and_elastic, simulation_follows_the_motion


@mistake("You leave out the energy of the spring; add it.", first_fails=energy_is_kinetic_and_elastic)
def energy(reference, x, v, *, mass, stiffness):
    return mass * v**2 / 2


@mistake("You let the damping push; it acts against the velocity.", first_fails=simulation_follows_the_motion)
def _rates(reference, t, state, *, damping, **parameters):
    return reference(t, state, damping=-damping, **parameters)
'''
README = """# hw15: A mass on a damped spring

**(a)** What is its energy?

**(b)** How does it move?

| function | points | part |
|---|---|---|
| `energy(x, v, ...)` | 4 | a |
| `simulate(t, x, v, ...)` | 6 | b |

One call may take 10 s of processor time, the whole submission 60 s.
Motions are compared to 10⁻⁵ of their size; `solve_ivp` with `rtol=1e-9, atol=1e-9` is safe.
"""
VISIBLE = f'''"""Visible tests of hw15."""

import numpy as np
from {SLUG} import energy, simulate


def test_energy():
    assert energy(1.0, 0.0, mass=1.0, stiffness=2.0) == 1.0


def test_simulate():
    assert simulate(np.array([0.0, 1.0]), 1.0, 0.0, mass=1.0, stiffness=2.0, damping=0.1)[0][0] == 1.0
'''
SCENE = '''"""hw15: a mass on a spring that loses nothing."""

import numpy as np

from tam570.show.scene import INK, Panel, Scene, Shape, TimePlot, energy_plot, frame_times, moving, plot_samples
from tam570.show.student import make_each

EXAMPLE = {"mass": 1.0, "stiffness": 4.0}  # kg, N/m
STATE = {"x": "m", "v": "m/s"}
START = (1.0, 0.0)
SECONDS = 10.0


def film(student, spring, start, seconds):
    """A swing from rest."""
    times, notes = frame_times(seconds), []
    x, v = student("simulate", times, *start, **spring, damping=0.0, shape=(len(times), 2)).T
    mass = np.column_stack([x, 0 * x])
    shapes = [
        Shape("lines", moving(np.array([-2.0, 0.0]), mass), INK, "spring", width=2),
        Shape("lines", np.array([[-2.0, -0.4], [-2.0, 0.4]]), INK, width=3),
        Shape("dot", mass[:, None], 0, "mass", width=11),
    ]
    alt_text = "A mass on a spring swings along a line. Nothing damps it, so each swing is as far as the one before."
    plots = make_each(notes, lambda: _energy(student, times, x, v, spring))
    return Scene("Spring", alt_text, times, [Panel(shapes)], plots, notes=notes)


def _energy(student, times, x, v, spring):
    shown = plot_samples(times)
    total = student.each("energy", x[shown], v[shown], **spring, shape=())
    return energy_plot(times[shown], total, spring["stiffness"] * x[shown] ** 2 / 2)
'''
NOTATION = """| x, v | `x`, `v` | m, m/s | displacement of a mass on a damped spring, and its rate (hw15) |
| c | `damping` | kg/s | of a spring (hw15) |
"""
HINTS = 'energy = ["Whose energies?"]\nsimulate = ["What is the acceleration?"]\n'
FILES = {
    f"solutions/{SLUG}.py": SOLUTION,
    f"autograder/checks/{SLUG}/reference.py": RIGHT,
    f"autograder/checks/{SLUG}/cases.py": CASES,
    f"autograder/checks/{SLUG}/checks.py": CHECKS,
    f"autograder/checks/{SLUG}/mistakes.py": MISTAKES,
    f"autograder/checks/{SLUG}/alternatives/the_same.py": SOLUTION,
    f"assignments/{SLUG}/README.md": README,
    f"assignments/{SLUG}/test_{SLUG}.py": VISIBLE,
    f"assignments/{SLUG}/hints.toml": HINTS,
    "shared/tam570/show/scenes/hw15.py": SCENE,
    "NOTATION.md": (assignments.find() / "NOTATION.md").read_text() + NOTATION,
}


@pytest.fixture(scope="module")
def fifteen(tmp_path_factory, course):
    """A copy of the course with the new assignment's files, and a class of two."""
    copy = tmp_path_factory.mktemp("fifteen")
    for part in ("assignments", "solutions", "autograder", "shared", "tests"):
        shutil.copytree(course / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(course / "pyproject.toml", copy)
    for path, text in FILES.items():
        (copy / path).parent.mkdir(parents=True, exist_ok=True)
        (copy / path).write_text(text)
    for student, text in {"ada": SOLUTION, "ben": f"{SOLUTION}\n\n{SLIP}"}.items():
        (work := copy / "submitted" / student / SLUG).mkdir(parents=True)
        (work / f"{SLUG}.py").write_text(text)
    return copy


def test_it_is_found_and_its_stub_is_made(fifteen):
    assert SLUG in assignments.slugs(fifteen)
    assert cli.main(["--root", str(fifteen), "stubs"]) == 0
    stub = (fifteen / "assignments" / SLUG / f"{SLUG}.py").read_text()
    assert stub.count("raise NotImplementedError") == 2 and "_rates" not in stub


def test_it_is_graded_and_its_mistake_is_named(fifteen, capsys):
    capsys.readouterr()
    command = ["--root", str(fifteen), "grade", str(fifteen / "submitted"), "--json", "--jobs", "1", "--seed", "2"]
    assert cli.main(command) == 0
    ada, ben = sorted(map(json.loads, capsys.readouterr().out.splitlines()), key=lambda line: line["student"])
    assert (ada["score"], ben["score"]) == (10.0, 4.0)
    assert ben["checks"][1]["suspect"] == "You let the damping push; it acts against the velocity."


def test_it_is_released_for_nbgrader(fifteen, tmp_path):
    assert cli.main(["--root", str(fifteen), "stubs"]) == 0
    assert cli.main(["--root", str(fifteen), "course", str(tmp_path / "course"), SLUG]) == 0
    assert list((tmp_path / "course" / "source" / SLUG).glob("*.ipynb"))


def test_it_is_audited(fifteen):
    assert cli.main(["--root", str(fifteen), "audit", SLUG, "--diagnosis", "--jobs", "1"]) == 0


@pytest.fixture
def passes(fifteen):
    """`passes(*files)` -> what CONTRIBUTING has one run on the copy; these files hold one module for each place."""
    known = {**os.environ, "PYTHONPATH": f"{fifteen / 'autograder'}{os.pathsep}{fifteen / 'shared'}"}

    def passes(*files):
        command = [sys.executable, "-m", "pytest", "-q", *files, "-k", "hw15", "-m", ""]
        return subprocess.run(command, cwd=fifteen, env=known, capture_output=True, text=True)

    return passes


SEEN_BY = {
    "tests/shared/show/test_show.py": "shared/tam570/show/scenes/hw15.py",
    "tests/test_notation.py": "NOTATION.md",
}


@pytest.mark.slow
def test_the_command_of_contributing_passes_and_sees_every_place(fifteen, passes, course):
    assert "`pytest tests -m '' -k hwNN`" in (course / "CONTRIBUTING.md").read_text()
    assert cli.main(["--root", str(fifteen), "stubs"]) == 0
    done = passes("tests/test_laws.py", *SEEN_BY)
    assert done.returncode == 0, done.stdout
    (fifteen / "shared/tam570/show/scenes/hw15.py").unlink()
    shutil.copy(course / "NOTATION.md", fifteen)
    for file, place in SEEN_BY.items():
        assert passes(file).returncode == 1, place
