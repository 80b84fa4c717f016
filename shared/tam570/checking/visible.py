"""Collect visible tests and run them one by one in this process, without pytest's session, configuration and plugins.

A module of tests is ordinary pytest. Its asserts are compiled so that a failure says what was returned and what is
right. pytest's `approx`, `raises` and `parametrize` work as usual; a test with a fixture cannot run.
"""

import ast
import functools
import inspect
import itertools
import linecache
import operator
import os
import traceback
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from io import StringIO
from pathlib import Path
from types import FunctionType, ModuleType

from tam570.checking.functions import Fault, Functions
from tam570.loading import said
from tam570.progress import FAILED, PASSED
from tam570.values import Json, Numbers, Parameters

COMPARISONS: dict[str, tuple[Callable[[Numbers, Numbers], Numbers], str]] = {  # by the operators of ast
    "Eq": (operator.eq, "is right"),
    "Lt": (operator.lt, "is the limit, which it must be below"),
    "LtE": (operator.le, "is the most that is right"),
    "Gt": (operator.gt, "is the limit, which it must be above"),
    "GtE": (operator.ge, "is the least that is right"),
}
MOST_NUMBERS = 6  # of the largest array that is printed in full
COMPARE, HOLDS, ALLCLOSE = "_tam570_compare", "_tam570_holds", "_tam570_allclose"
RIGHT, AGREE = "Your code gives {0}{2}; {1} is right.", "Your code gives {0} and {1}{2}; they must agree."


@dataclass(frozen=True)
class Test:
    """A test function with its parameters."""

    name: str
    run: Callable[[], object]


@dataclass(frozen=True)
class TestFailure:
    """Why a test failed."""

    message: str
    function: str | None = None  # that is certainly at fault
    where: str = ""  # the line of the test
    printed: str = ""
    unwritten: bool = False


@dataclass
class Outcomes:
    """The outcome of each test, its failure, and a callable that repeats it, by the test's name with parameters."""

    functions: Functions
    terminal: int | None  # file descriptor that shows the running test
    passed: dict[str, str] = field(default_factory=dict)  # PASSED or FAILED
    failures: dict[str, TestFailure] = field(default_factory=dict)
    repeat: dict[str, Callable[[], object]] = field(default_factory=dict)

    def run(self, tests: Sequence[Test]) -> None:
        """Run these tests and record their outcomes."""
        for test in tests:
            self.functions.trail.enter(test=test.name, function="")
            if self.terminal is not None:
                os.write(self.terminal, f"\r\x1b[K{test.name[:76]}".encode())
            self.repeat[test.name] = test.run
            failure = self._failure(test)
            self.passed[test.name] = FAILED if failure else PASSED
            if failure:
                self.failures[test.name] = failure

    def _failure(self, test: Test) -> TestFailure | None:
        import numpy as np

        self.functions.calls.clear()
        with redirect_stdout(StringIO()) as printed, redirect_stderr(StringIO()):
            try:
                with np.errstate(all="ignore"), warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    test.run()
                return None
            except Fault as fault:
                return TestFailure(str(fault), fault.name, _line(fault), printed.getvalue(), fault.unwritten)
            except (KeyboardInterrupt, GeneratorExit):
                raise
            except BaseException as error:
                return TestFailure(self._message(error), None, _line(error), printed.getvalue())

    def _message(self, error: BaseException) -> str:
        """Return the message of a failed assert, or a description of the exception."""
        text = str(error).strip()
        if text.startswith("DID NOT RAISE"):
            return "It raises no ValueError here, and it should."
        if isinstance(error, AssertionError):
            return text or "This is false."
        where = said(error, str(self.functions.file))
        return f"{self.functions.calls[-1]} raises an exception.\n{where}" if where.startswith("Line") else where


def collect_tests(path: Path, text: str, names: Parameters | None = None) -> list[Test]:
    """Return the tests in a module, in order, with their parameters; pass on exceptions of its import.

    names : more globals of the module
    """
    module = ModuleType(path.stem)
    module.__file__ = str(path)
    linecache.cache[str(path)] = (len(text), None, text.splitlines(keepends=True), str(path))
    tree = ast.fix_missing_locations(_ReportingAsserts().visit(ast.parse(text)))
    vars(module).update({COMPARE: _compare, HOLDS: _holds, ALLCLOSE: _allclose, **(names or {})})
    exec(compile(tree, str(path), "exec", dont_inherit=True), vars(module))
    members = [member for name, member in vars(module).items() if name.startswith("test_")]
    return [test for member in members if inspect.isfunction(member) for test in _with_parameters(member)]


def _with_parameters(function: FunctionType) -> Iterator[Test]:
    """Yield a test for each combination of its parameters."""
    name, marks = function.__name__, getattr(function, "pytestmark", ())
    cases = [list(_cases(*mark.args[:2])) for mark in marks if mark.name == "parametrize"]
    for combination in itertools.product(*cases):
        values = {key: value for case, _ in combination for key, value in case.items()}
        suffix = "-".join(label for _, label in combination)
        missing = [parameter for parameter in inspect.signature(function).parameters if parameter not in values]
        run = functools.partial(_needs_pytest, missing[0]) if missing else functools.partial(function, **values)
        yield Test(f"{name}[{suffix}]" if suffix else name, run)


def _cases(names: str | Sequence[str], values: Sequence[Numbers]) -> Iterator[tuple[Json, str]]:
    """Yield the values of parameters by name, and their label in the test's name."""
    keys = [name.strip() for name in names.split(",")] if isinstance(names, str) else list(names)
    for index, value in enumerate(values):
        members = value.values if hasattr(value, "marks") else value if len(keys) > 1 else [value]  # of pytest.param
        case = dict(zip(keys, members, strict=True))
        labels = [
            str(member) if isinstance(member, str | int | float) else f"{key}{index}" for key, member in case.items()
        ]
        yield case, "-".join(labels)


def _needs_pytest(fixture: str) -> None:
    raise AssertionError(f"This test asks for the fixture {fixture!r}, which only pytest has. Run it with pytest.")


class _ReportingAsserts(ast.NodeTransformer):
    """Transformer of a module of tests, after which asserts and assert_allclose report what they compare."""

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:  # noqa: N802
        self._names: set[str] = set()  # of variables with results of the student's functions
        for part in ast.walk(node):
            if isinstance(part, ast.Assign) and self._is_students(part.value):
                self._names |= {name.id for target in part.targets for name in _names_in(target)}
        return self.generic_visit(node)

    def _is_students(self, node: ast.expr) -> bool:
        return any(name.id.startswith("hw") or name.id in self._names for name in _names_in(node))

    def visit_Assert(self, node: ast.Assert) -> ast.AST | list[ast.AST]:  # noqa: N802
        if isinstance(node.test, ast.BoolOp) and isinstance(node.test.op, ast.And) and node.msg is None:
            return [self._reporting(node, part) for part in node.test.values]
        return self._reporting(node, node.test) if node.msg is None else node

    def _reporting(self, node: ast.Assert, test: ast.expr) -> ast.AST:
        if isinstance(test, ast.Compare) and len(test.ops) == 1 and type(test.ops[0]).__name__ in COMPARISONS:
            name, expected = ast.Constant(type(test.ops[0]).__name__), test.comparators[0]
            call = _call(COMPARE, test.left, name, expected, ast.Constant(self._is_students(expected)))
        else:
            call = _call(HOLDS, test)
        return ast.copy_location(ast.Expr(ast.copy_location(call, node)), node)

    def visit_Call(self, node: ast.Call) -> ast.AST:  # noqa: N802
        self.generic_visit(node)
        if isinstance(node.func, ast.Attribute) and node.func.attr == "assert_allclose":
            node.func = ast.copy_location(ast.Name(ALLCLOSE, ast.Load()), node.func)
            both = ast.Constant(any(map(self._is_students, node.args[1:2])))
            node.keywords.append(ast.keyword("both", ast.copy_location(both, node)))
        return node


def _names_in(node: ast.AST) -> Iterator[ast.Name]:
    return (part for part in ast.walk(node) if isinstance(part, ast.Name))


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(arguments), [])


def _compare(actual: Numbers, name: str, expected: Numbers, both: bool) -> None:
    compare, words = COMPARISONS[name]
    if not compare(actual, expected):
        expected = getattr(expected, "expected", expected)  # of pytest's approx
        if words == "is right":
            raise AssertionError(difference(actual, expected, both))
        raise AssertionError(f"Your code gives {_numbers(actual)}; {_numbers(expected)} {words}.")


def _holds(value: Numbers) -> None:
    if not value:
        raise AssertionError("This is false.")


def _allclose(
    actual: Numbers, desired: Numbers, rtol: float = 1e-7, atol: float = 0.0, both: bool = False, **_: Numbers
) -> None:
    import numpy as np

    actual, desired = np.asarray(actual, float), np.asarray(desired, float)
    fits = actual.shape == desired.shape or desired.ndim == 0
    if not fits or not (np.abs(actual - desired) <= atol + rtol * np.abs(desired)).all():
        raise AssertionError(difference(actual, desired, both))


def difference(actual: Numbers, expected: Numbers, both: bool = False) -> str:
    """Return a sentence on the actual and the right value, or `both` from the student; of a long array, the worst."""
    import numpy as np

    sentence = AGREE if both else RIGHT
    try:
        actual, expected = _real(actual), _real(expected)
    except (TypeError, ValueError):
        return sentence.format(repr(actual), repr(expected), "")
    if actual.shape != expected.shape and expected.ndim:
        return sentence.format(f"an array of shape {actual.shape}", expected.shape, "")
    if actual.size <= MOST_NUMBERS:
        return sentence.format(*_apart(actual, np.broadcast_to(expected, actual.shape)), "")
    off = np.abs(actual - expected)
    worst = np.unravel_index(int(np.argmax(np.where(np.isnan(off), np.inf, off))), off.shape)
    first, other = _apart(actual[worst], np.broadcast_to(expected, actual.shape)[worst])
    return sentence.format(first, other, f" in {_place(worst)}")


def _apart(actual: Numbers, expected: Numbers) -> list[str]:
    """Format both with as many digits as it takes to tell them apart."""
    pairs = [[_numbers(value, digits) for value in (actual, expected)] for digits in (6, 9, 12, 17)]
    return next((pair for pair in pairs if pair[0] != pair[1]), pairs[-1])


def _numbers(value: Numbers, digits: int = 6) -> str:
    import numpy as np

    try:
        actual = _real(value)
    except (TypeError, ValueError):
        return repr(value)
    text = np.array2string(actual, separator=", ", formatter={"float_kind": lambda x: f"{x:.{digits}g}"})
    return " ".join(text.split())


def _real(value: Numbers) -> Numbers:
    """Convert to an array of real numbers; raise TypeError if an imaginary part is not negligible."""
    import numpy as np

    array = np.real_if_close(value)
    if np.iscomplexobj(array):
        raise TypeError
    return np.asarray(array, float)


def _place(index: Sequence[Numbers]) -> str:
    words = ("row", "column", "layer")
    if len(index) == 1:
        return f"component {int(index[0]) + 1}"
    return ", ".join(f"{word} {int(k) + 1}" for word, k in zip(words, index, strict=False))


def _line(error: BaseException) -> str:
    """Return the last statement of a test that led to an error, on one line."""
    trace = traceback.extract_tb(error.__traceback__)
    frames = [frame for frame in trace if Path(frame.filename).name.startswith("test_")]
    if not frames or (frames[-1].line or "").startswith("_example("):
        return ""
    first, last = frames[-1].lineno or 0, frames[-1].end_lineno or 0
    return " ".join(linecache.getline(frames[-1].filename, number).strip() for number in range(first, last + 1))
