"""The laws of the house: short functions, small modules, and few words in a module of checks."""

import ast
import io
import re
import tokenize
from pathlib import Path

import pytest

COURSE = Path(__file__).resolve().parent.parent
ROOMS = ("autograder", "shared", "solutions", "tests", "benchmarks", "docs")
MODULES = sorted(path for room in ROOMS for path in (COURSE / room).rglob("*.py"))
CHECKS = sorted((COURSE / "autograder" / "checks").glob("*/checks.py"))

GRADER = COURSE / "autograder" / "tam570_grader"
# the grader's rooms, from the ground up
ORDER = [
    "errors",
    "options",
    "sandbox.inside",
    "writing",
    "results",
    "pages",
    "sandbox",
    "grading",
    "delivery",
    "audit",
]

LONGEST_FUNCTION = 40  # lines, with its docstring
LONGEST_MODULE = 300  # lines of code
MOST_NAMES = 30  # functions and classes of a module of checks

BLANK = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER}
FUNCTIONS = ast.FunctionDef | ast.AsyncFunctionDef
DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)


def shown(path):
    return str(path.relative_to(COURSE))


def lines_of(node):
    return set(range(node.lineno, node.end_lineno + 1))


def long_functions(text):
    """name: lines, of the functions that are too long."""
    functions = [node for node in ast.walk(ast.parse(text)) if isinstance(node, FUNCTIONS)]
    return {node.name: len(lines_of(node)) for node in functions if len(lines_of(node)) > LONGEST_FUNCTION}


def lines_of_code(text):
    """How many lines hold code: neither blank, nor a comment, nor of a docstring."""
    tokens = [one for one in tokenize.generate_tokens(io.StringIO(text).readline) if one.type not in BLANK]
    code = {line for one in tokens for line in range(one.start[0], one.end[0] + 1)}
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, DOCUMENTED) and ast.get_docstring(node) is not None:
            code -= lines_of(node.body[0])
    return len(code)


def test_functions_are_short():
    found = {shown(path): long_functions(path.read_text()) for path in MODULES}
    assert not {path: long for path, long in found.items() if long}


def test_modules_are_small():
    long = [path for path in MODULES if len(path.read_text().splitlines()) > LONGEST_MODULE]
    found = {shown(path): lines_of_code(path.read_text()) for path in long}
    assert not {path: lines for path, lines in found.items() if lines > LONGEST_MODULE}


@pytest.mark.parametrize("path", CHECKS, ids=lambda one: one.parent.name)
def test_a_module_of_checks_has_few_names(path):
    names = [node for node in ast.parse(path.read_text()).body if isinstance(node, FUNCTIONS | ast.ClassDef)]
    assert len(names) <= MOST_NAMES


def test_the_design_shows_checks_that_there_are():
    shown = re.findall(r"^```python\n(.*?)^```$", (COURSE / "docs" / "design.md").read_text(), re.MULTILINE | re.DOTALL)
    there = "".join(path.read_text() for path in CHECKS)
    assert shown and not [one for one in shown if one not in there]


def room_of(module):
    """The room that a module of the grader, written with dots, is in."""
    names = module.split(".")
    return ".".join(names[1:3] if names[1:3] == ["sandbox", "inside"] else names[1:2])


def adds_a_command(tree):
    """Whether a module speaks to people, in a command of its own: such a one may ask any room."""
    signatures = [one.args.args for one in tree.body if isinstance(one, ast.FunctionDef)]
    return any(one.annotation and ast.unparse(one.annotation) == "Commands" for args in signatures for one in args)


def climbs(path):
    """The imports by which a module of the grader takes something from a room above its own."""
    tree = ast.parse(path.read_text())
    own = room_of(".".join(path.relative_to(GRADER.parent).with_suffix("").parts))
    if own not in ORDER or adds_a_command(tree):
        return []
    imports = [one for one in ast.walk(tree) if isinstance(one, ast.ImportFrom) and not one.level]
    names = [f"{one.module}.{alias.name}" for one in imports for alias in one.names]
    above = ORDER[ORDER.index(own) + 1 :]
    return [name for name in names if name.startswith("tam570_grader.") and room_of(name) in above]


def test_a_room_knows_those_below_it_alone():
    found = {shown(path): climbs(path) for path in GRADER.rglob("*.py")}
    assert not {path: names for path, names in found.items() if names}


def test_every_room_has_a_place_in_the_order():
    rooms = {path.name for path in GRADER.iterdir() if (path / "__init__.py").exists()}
    assert rooms == {*ORDER} - {"errors", "options", "sandbox.inside"}
