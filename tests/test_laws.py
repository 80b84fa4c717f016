"""Laws that hold for every assignment; the tests find a new assignment by its files."""

import ast
import re
import tomllib
from functools import cache

import numpy as np
import pytest
from parameters import SLUGS, first

from tam570_grader.audit.diagnosis import diagnosis
from tam570_grader.audit.local import calls_of_checks
from tam570_grader.checks import assignments
from tam570_grader.checks.expect import check_context
from tam570_grader.checks.returns import Array, Drawing, Formula, FreeBodyDiagram, Group
from tam570_grader.diagnosis.mistakes import candidates, mistakes, named_mistake
from tam570_grader.release.stubs import stub
from tam570_grader.sandbox.zygote import ResourceLimits

COURSE = assignments.find()
CHECKS = [(slug, check) for slug in SLUGS for check in assignments.assignment(COURSE, slug).checks]
FOLDERS = {slug: assignments.checks_folder(COURSE, slug) for slug in SLUGS}
ALTERNATIVES = [(slug, path) for slug, folder in FOLDERS.items() for path in sorted(folder.glob("alternatives/*.py"))]
MISTAKES = [(slug, mistake) for slug, folder in FOLDERS.items() for mistake in mistakes(folder)]
WRAPPERS = {
    "complex numbers": "lambda x: np.asarray(x) + 0j",
    "numbers as text": "lambda x: np.asarray(x).astype(str)",
    "one axis too many": "lambda x: np.asarray(x)[None]",
    "NaN in one place": "lambda x: np.where(np.arange(np.size(x)).reshape(np.shape(x)) == 0, np.nan, x)",
}


def first_of_each(cases, key):
    """Return arguments of `parametrize`: the cases with ids; all but the first case of each key are marked slow."""
    keys = [key(*case) for case in cases]
    slow = [key in keys[:k] for k, key in enumerate(keys)]
    return {
        "argvalues": [pytest.param(*case, marks=[pytest.mark.slow] * k) for case, k in zip(cases, slow, strict=True)],
        "ids": [f"{slug[:4]}-{getattr(it, 'name', it).removesuffix('.py')}" for slug, it in cases],
    }


def outcomes(result, outcome):
    return {check.name for check in result.checks if check.outcome == outcome}


def failures(result):
    return [(check.name, check.outcome, check.message) for check in result.checks if check.outcome != "passed"]


def test_the_stub_keeps_every_signature_and_no_body(slug, solution_text):
    solution, released = (functions(text) for text in (solution_text(slug), stub(solution_text(slug))))
    for name in assignments.solution(slug).__all__:
        assert ast.dump(solution[name].args) == ast.dump(released[name].args)
        assert ast.unparse(released[name].body[1]) == "raise NotImplementedError"


def test_no_released_file_holds_a_solution_or_a_hidden_check(slug, course, solution_text):
    checks = assignments.checks_folder(course, slug).glob("*.py")
    secret = solution_text(slug) + "\n".join(path.read_text() for path in checks)
    lines = {line.strip() for line in {*secret.splitlines()}.difference(stub(solution_text(slug)).splitlines())}
    lines = {line for line in lines if len(line) > 30 and line[0] != '"'}  # the example of an input repeats its label
    for path in (course / "assignments" / slug).iterdir():
        text = path.read_text() if path.is_file() else ""
        assert not (leaked := [line for line in lines if line in text]), f"{path.name} shows {leaked}"


def test_readme_hints_and_checks_name_every_function_and_ten_points(slug, course):
    assignment, folder = assignments.assignment(course, slug), course / "assignments" / slug
    rows = re.findall(r"^\| `(\w+)\(.*?\| *([\d.]+) *\|", (folder / "README.md").read_text(), re.MULTILINE)
    hints = tomllib.loads((folder / "hints.toml").read_text())
    assert set(dict(rows)) == set(hints) == set(assignment.returns) == set(assignments.solution(slug).__all__)
    assert sum(float(points) for _, points in rows) == pytest.approx(10.0) and assignment.max_score == 10.0
    assert all(steps and all(step.strip() for step in steps) for steps in hints.values())
    assert all(check.line and check.points > 0 for check in assignment.checks)


def test_notation_explains_every_parameter_in_its_meaning(slug, course, solution_text):
    written, explained = functions(solution_text(slug)), set()
    for row in re.findall(r"^\|[^|]*\|([^|]*`[^|]*)\|[^|]*\|([^|]*)\|$", (course / "NOTATION.md").read_text(), re.M):
        if slug[:4] in row[1] or not re.search(r"hw\d\d", row[1]):
            explained |= set(re.findall(r"`(\w+)`", row[0]))
    arguments = [written[name].args for name in assignments.solution(slug).__all__]
    assert {item.arg for of in arguments for item in (*of.args, *of.kwonlyargs)} <= explained


@pytest.mark.parametrize("seed", first(1, range(10)))
def test_the_solution_has_full_marks(slug, seed, grade, solution_text):
    result = grade(slug, solution_text(slug), seed)
    assert result.score == result.max_score, failures(result)


@pytest.mark.parametrize("seed", first(1, range(10)))
@pytest.mark.parametrize(("slug", "path"), **first_of_each(ALTERNATIVES, lambda slug, _: slug))
def test_right_answers_in_other_styles_have_full_marks(slug, path, seed, grade):
    result = grade(slug, path.read_text(), seed)
    assert result.score == result.max_score, failures(result)


@pytest.mark.parametrize(("slug", "mistake"), **first_of_each(MISTAKES, lambda slug, _: slug))
@pytest.mark.parametrize("seed", first(1, range(1, 4)))
def test_a_wrong_submission_loses_points_at_its_check_whatever_the_inputs(slug, mistake, seed, grade, solution_text):
    naming = mistake.compared or seed > 1  # a search for the mistake that finds none takes up to 30 s
    result = grade(slug, f"{solution_text(slug)}\n\n{mistake.text}", seed, naming=naming)
    failed = [check for check in result.checks if check.outcome == "failed"]
    assert not outcomes(result, "grader_error"), failures(result)
    assert not any(check.failure.fault for check in failed), "the search for a name raised"
    assert failed and failed[0].name == mistake.first_fails and result.score < 10, failures(result)
    cause = diagnosis(result, mistake, {item.message for other, item in MISTAKES if other == slug})
    assert (cause.is_named or not mistake.compared) and not cause.misled, failures(result)


@pytest.mark.parametrize(("slug", "check"), **first_of_each(CHECKS, lambda slug, check: (slug, check.name)))
def test_every_check_has_a_mistake_that_it_catches(slug, check, grade, solution_text):
    """Some mistake fails this check first, or fails it not only because of a mistake in another function."""

    def is_caught(mistake):
        result = grade(slug, f"{solution_text(slug)}\n\n{mistake.text}", naming=False)
        failed = [item for item in result.checks if item.name == check.name and item.outcome == "failed"]
        return any(not item.failure.follows_from for item in failed)

    of_assignment = [mistake for other, mistake in MISTAKES if other == slug]
    assert any(check.name == item.first_fails for item in of_assignment) or any(map(is_caught, of_assignment))


@pytest.mark.parametrize(("slug", "check"), **first_of_each(CHECKS, lambda slug, _: slug))
def test_the_inputs_of_a_check_tell_its_mistakes_from_the_truth(slug, check, student_of, solution_text):
    assignment = assignments.assignment(COURSE, slug)
    student = student_of(slug, solution_text(slug))
    with check_context():
        check.run(student, np.random.default_rng(5))
    names = {call.name for call in student.calls}
    compared = [call for call in student.calls if not isinstance(assignment.returns[call.name], FreeBodyDiagram)]
    suspects = candidates(solution_text(slug), FOLDERS[slug], {call.name for call in compared})
    assert named_mistake(solution_text(slug), suspects, compared) is None
    assert not names or names & set(re.findall(r"\w+", check.title)), "its title names none that it calls"


EMPTY = {
    "an empty file": "",
    "None": "def {f}(*args, **kwargs): return None",
    "NaN": "def {f}(*args, **kwargs): return {nan}",
    "zeros": "def {f}(*args, **kwargs): return {zeros}",
    "nearly zeros": "def {f}(*args, **kwargs): return {tiny}",
    "an empty list": "def {f}(*args, **kwargs): return []",
    "a string": "def {f}(*args, **kwargs): return 'x'",
    "the first input": "def {f}(*args, **kwargs): return args[0] if args else None",
    "the last input": "def {f}(*args, **kwargs): return args[-1] if args else None",
    "rest": "import numpy\ndef {f}(*args, **kwargs): return numpy.tile(numpy.hstack(args[1:]), (len(args[0]), 1))",
    "ValueError": "def {f}(*args, **kwargs): raise ValueError",
}
NOTHING = [
    pytest.param(slug, what, marks=[] if slug.startswith("hw08") or what == "zeros" else [pytest.mark.slow])
    for slug in SLUGS
    for what in EMPTY
]


@pytest.mark.parametrize(("slug", "what"), NOTHING)
def test_what_says_nothing_scores_nothing(slug, what, grade, course):
    results = assignments.assignment(course, slug).returns
    numbers = {"zeros": "0.", "tiny": "5e-324", "nan": "float('nan')"}
    text = "\n".join(
        EMPTY[what].format(f=name, **{key: filled(returns, number) for key, number in numbers.items()})
        for name, returns in results.items()
    )
    result = grade(slug, text, naming=what == "nearly zeros")
    assert result.score == 0, failures(result)


def test_the_untouched_stub_scores_nothing(slug, grade, course):
    result = grade(slug, (course / "assignments" / slug / f"{slug}.py").read_text())
    assert result.score == 0
    assert outcomes(result, "not_run") == {check.name for check in assignments.assignment(course, slug).checks}


@pytest.mark.parametrize("slug", first(1, SLUGS))
def test_an_endless_loop_scores_nothing(slug, grade, course):
    names = assignments.assignment(course, slug).returns
    text = "\n".join(f"def {name}(*args, **kwargs):\n    while True: pass" for name in names)
    result = grade(slug, text, limits=ResourceLimits(cpu=1, call=0.5), naming=False)
    assert (result.status, result.score) == ("timeout", 0)


@cache
def called_functions(slug):
    """Return {check: the functions that it calls}."""
    return calls_of_checks(COURSE, slug)[0]


@pytest.mark.parametrize("slug", first(2, SLUGS))
@pytest.mark.parametrize("what", first(1, WRAPPERS))
def test_right_numbers_in_a_wrong_form_score_nothing(slug, what, grade, course, solution_text):
    results = assignments.assignment(course, slug).returns
    numeric = {name for name, returns in results.items() if isinstance(returns, Array | Group)}
    result = grade(slug, solution_text(slug) + wrapped(results, WRAPPERS[what]), naming=False)
    earning = {check.name for check in result.checks if check.points}
    assert not {name for name in earning if called_functions(slug)[name] & numeric}, failures(result)


@pytest.mark.parametrize("slug", first(1, SLUGS))
@pytest.mark.parametrize("form", ["lambda x: np.asarray(x).tolist()", "lambda x: np.asarray(x, dtype=object)"])
def test_right_numbers_in_any_form_that_asarray_takes_have_full_marks(slug, form, grade, course, solution_text):
    result = grade(slug, solution_text(slug) + wrapped(assignments.assignment(course, slug).returns, form))
    assert result.score == result.max_score, failures(result)


def wrapped(results, wrapper):
    """Return code that changes the numeric results of functions that the grader calls, not of calls between them."""
    numeric = [name for name, returns in results.items() if isinstance(returns, Array | Group)]
    return f"""
import numpy as np
_callers = []
def _wrap(function, change):
    def wrapper(*args, **kwargs):
        _callers.append(function)
        try:
            result = function(*args, **kwargs)
        finally:
            _callers.pop()
        if _callers:
            return result
        return tuple(map(change, result)) if isinstance(result, tuple) else change(result)
    return wrapper
for _name in {list(results)}:
    globals()[_name] = _wrap(globals()[_name], ({wrapper}) if _name in {numeric} else lambda x: x)
"""


def filled(returns, number):
    """Return code for a result of the form `returns` that has the same number everywhere."""
    if isinstance(returns, Group):
        return "(" + ", ".join(filled(member, number) for member in returns.members) + ",)"
    if isinstance(returns, Drawing):
        return "None"
    if isinstance(returns, FreeBodyDiagram):
        return f"[(({number},) * {returns.dimension}, None)]"
    if isinstance(returns, Formula):
        return f"__import__('sympy').sympify({number})"
    sizes = ["len(args[0])" if size == "n" else "2" if size is None else str(size) for size in returns.shape]
    return f"__import__('numpy').full(({', '.join(sizes)}{',' if sizes else ''}), {number})"


def functions(text):
    return {node.name: node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)}
