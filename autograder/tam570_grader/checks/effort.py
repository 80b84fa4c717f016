"""What hidden code may spend, counted: calls of its functions and turns of its loops.

A submission chooses what is compared, and from which rows a reference motion is integrated once more. A clock would let
the speed of a machine choose the grade and its words; a count is the same everywhere. It is raised where it runs out,
in the code that counts, and nowhere else.

    with limited(1000):
        function()  # raises Exhausted at its 1001st step, if it has been compiled by `compile_counted`
"""

import ast
import importlib.machinery
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from importlib.machinery import ModuleSpec
from types import CodeType, ModuleType

from tam570.bytecode import cached_code
from tam570.values import Function, Numbers

INTEGRATE = "tam570.integrate"  # its compiled loops count nothing
EVALUATION = 20  # steps that one of the rates takes in Python, with its share of the integration
PROLOGUE = "from tam570_grader.checks.effort import count as _count"


class Exhausted(Exception):
    """So much is not spent on one submission."""


@dataclass(slots=True)
class Meter:
    """Steps that are left."""

    remaining: int


_meter: ContextVar[Meter | None] = ContextVar("meter", default=None)


@contextmanager
def limited(steps: int) -> Iterator[Meter]:
    """Raise Exhausted in this block beyond so many steps; they also count in a block around it."""
    outer = _meter.get()
    most = min(steps, outer.remaining) if outer else steps
    meter = Meter(most)
    token = _meter.set(meter)
    try:
        yield meter
    finally:
        _meter.reset(token)
        if outer:
            outer.remaining -= most - meter.remaining


def count(steps: int = 1) -> None:
    """Spend steps of the innermost block."""
    if meter := _meter.get():
        meter.remaining -= steps
        if meter.remaining < 0:
            raise Exhausted


@contextmanager
def uncounted(prefix: str) -> Iterator[None]:
    """Count nothing in modules whose names begin so: `tam570.integrate` traces what they integrate, and is faster."""
    modules = [vars(module) for name, module in [*sys.modules.items()] if name.startswith(prefix)]
    counting = [names for names in modules if "_count" in names]
    for names in counting:
        names["_count"] = bool  # false, without an argument; it can be traced
    try:
        yield
    finally:
        for names in counting:
            names["_count"] = count


def compile_counted(text: str | bytes, name: str, *, in_python: bool = False) -> CodeType:
    """Compile a module whose functions and loops count their steps.

    in_python : let `tam570.integrate.solve` run in Python, where it calls what counts
    """
    tree = _Counted(in_python).visit(ast.parse(text))
    index = next((i for i, node in enumerate(tree.body) if not _is_head(node)), len(tree.body))
    tree.body[index:index] = ast.parse(PROLOGUE).body
    return compile(ast.fix_missing_locations(tree), name, "exec", dont_inherit=True)


def _is_head(node: ast.stmt) -> bool:
    """Return whether it must be before all else: the docstring, and imports from the future."""
    return (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)) or (
        isinstance(node, ast.ImportFrom) and node.module == "__future__"
    )


Block = ast.FunctionDef | ast.While | ast.For


class _Counted(ast.NodeTransformer):
    def __init__(self, in_python: bool) -> None:
        self.in_python = in_python

    def _with_count(self, node: Block) -> Block:
        self.generic_visit(node)
        index = 1 if isinstance(node, ast.FunctionDef) and ast.get_docstring(node) else 0
        node.body.insert(index, ast.parse("_count()").body[0])
        return node

    visit_FunctionDef = visit_While = visit_For = _with_count

    def visit_Lambda(self, node: ast.Lambda) -> ast.expr:  # noqa: N802
        self.generic_visit(node)
        node.body = ast.BoolOp(ast.Or(), [ast.parse("_count()", mode="eval").body, node.body])
        return node

    def visit_ImportFrom(self, node: ast.ImportFrom) -> ast.stmt:  # noqa: N802
        if self.in_python and node.module == INTEGRATE:
            node.module = __name__
        return node


def solve(rhs: Function, *args: Numbers, **keywords: Numbers) -> Numbers:
    """Return `tam570.integrate.solve`, which calls `rhs` at every stage."""
    from tam570.integrate import solve

    def rates(t: float, y: Numbers, **parameters: Numbers) -> Numbers:
        count(EVALUATION)
        return rhs(float(t), y, **parameters)  # a symbol is no number: it is not traced

    return solve(rates, *args, **keywords)


class _Loader(importlib.machinery.SourceFileLoader):
    def get_code(self, fullname: str) -> CodeType:
        text = self.get_data(self.path)
        inputs = b"\0".join((self.path.encode(), self.get_data(__file__), text))
        return cached_code(self.path, "counted", inputs, lambda: compile_counted(text, self.path))


class Finder:
    """Finds the modules of packages of ours, whose names begin alike."""

    def __init__(self, prefix: str) -> None:
        self.prefix = prefix

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if not path or not name.startswith(self.prefix):
            return None
        return importlib.machinery.FileFinder(path[0], (_Loader, [".py"])).find_spec(name)
