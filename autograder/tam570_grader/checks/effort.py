"""Compile hidden code so that it counts the calls of its functions and the iterations of its loops.

A submission chooses what is compared, and from which rows a reference motion is integrated again; `tam570.meter`
limits the steps for that.
"""

import ast
import importlib.machinery
import re
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from types import CodeType, ModuleType

from tam570 import meter
from tam570.bytecode import cached_code

PACKAGES = "_checks_"  # prefix of the names of the packages of checks
PROLOGUE = "from {} import count as _count"
HEAD = re.compile(r"(?m)^ *(?:def|for|while)\b")
FORMATTED = re.compile(r"(?m)^( *)(?:def|for|while)\b(?:.*\(\n(?: .*\n)*?\1\))?.*:(?:  #.*)?\n+(?=( +))")


def count() -> None:
    """Count a step as `tam570.meter.count` does; the integrator cannot trace functions that call this one."""
    meter.count()


def compile_counted(text: str | bytes, name: str, *, may_trace: bool = True) -> CodeType:
    """Compile a module whose functions and loops count their steps.

    may_trace : False if rates take only a few steps: `tam570.integrate.solve` then calls them without tracing
    """
    tree = _Counted().visit(ast.parse(text))
    index = next((i for i, node in enumerate(tree.body) if not _is_head(node)), len(tree.body))
    tree.body[index:index] = ast.parse(PROLOGUE.format("tam570.meter" if may_trace else __name__)).body
    return compile(ast.fix_missing_locations(tree), name, "exec", dont_inherit=True)


def compile_lightly(text: str, name: str) -> CodeType:
    """Compile functions without tracing; insert counts into formatted text by regex: a fifth of the time."""
    counted, places = FORMATTED.subn(r"\g<0>\2_count()\n", text)
    if "lambda" in text or places != len(HEAD.findall(text)):
        return compile_counted(text, name, may_trace=False)
    return compile(f"{PROLOGUE.format(__name__)}\n{counted}", name, "exec", dont_inherit=True)


def _is_head(node: ast.stmt) -> bool:
    """Return whether a statement must come first: the docstring, or an import from the future."""
    return (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)) or (
        isinstance(node, ast.ImportFrom) and node.module == "__future__"
    )


Block = ast.FunctionDef | ast.While | ast.For


class _Counted(ast.NodeTransformer):
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


class _Loader(importlib.machinery.SourceFileLoader):
    def get_code(self, fullname: str) -> CodeType:
        text = self.get_data(self.path)
        inputs = b"\0".join((self.path.encode(), self.get_data(__file__), text))
        return cached_code(self.path, "counted", inputs, lambda: compile_counted(text, self.path))


class Finder:
    """Meta path finder for the modules of packages of checks; it compiles them with counts."""

    @staticmethod
    def find_spec(name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        if not path or not name.startswith(PACKAGES):
            return None
        return importlib.machinery.FileFinder(path[0], (_Loader, [".py"])).find_spec(name)
