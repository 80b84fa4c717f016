"""The visible tests pass on correct answers of any style, and fail on stubs."""

import shutil

import pytest
from parameters import SLUGS, first

from tam570.checking import session
from tam570.checking.trail import Trail
from tam570_grader.checks import assignments

EXACT = """
import runpy
import numpy as np
import sympy

def exact(value):
    if isinstance(value, tuple):
        return [exact(part) for part in value]
    numbers = isinstance(value, float | np.ndarray | np.generic)
    return np.vectorize(sympy.Float, otypes=[object])(value) if numbers else value

def strict(function):
    def called(*args, **kwargs):
        for value in (*args, *kwargs.values()):
            steps = isinstance(value, list) and all(isinstance(step, tuple) for step in value)
            plain = steps or isinstance(value, str | float | int | tuple) or hasattr(value, "plot")
            assert plain or value.dtype == float, value
        return exact(function(*args, **kwargs))
    return called

solution = runpy.run_path({solution!r})
globals().update({{name: strict(solution[name]) for name in solution["__all__"]}})
"""
RIGHT = sorted((assignments.find() / "autograder" / "checks").glob("*/alternatives/*.py"))


def test_the_visible_tests_pass_on_the_solution_and_fail_on_the_stub(desk, slug, course, capsys):
    assert session.check(course / "solutions" / f"{slug}.py", slug, Trail(), lost={}), capsys.readouterr()
    capsys.readouterr()
    assert not session.check(course / "assignments" / slug / f"{slug}.py", slug, Trail(), lost={})
    said = capsys.readouterr().out
    assert "nothing is written yet" in said and len(said.splitlines()) == 1


@pytest.mark.parametrize("path", first(1, RIGHT), ids=[f"{path.parents[1].name[:4]}-{path.stem}" for path in RIGHT])
def test_the_visible_tests_pass_on_right_answers_in_other_styles(desk, tam570, in_process, path):
    shutil.copy(path, desk / f"{path.parents[1].name}.py")
    code, said = tam570("check", desk / f"{path.parents[1].name}.py")
    assert code == 0, said


@pytest.mark.parametrize("slug", first(1, SLUGS))
def test_the_visible_tests_take_any_numbers_and_give_arrays(desk, tam570, in_process, slug, course):
    """Results may be SymPy numbers or arrays of them; arguments are arrays, tuples or plain, except hw09's list."""
    name = f"{slug}.py"
    (desk / name).write_text(EXACT.format(solution=str(course / "solutions" / name)))
    shutil.copy(course / "assignments" / slug / f"test_{name}", desk)
    code, said = tam570("check", desk / name)
    assert code == 0, said
