"""The process in which a student's code runs: it imports libraries in advance, carries out one order, and ends."""

import ast
import contextlib
import importlib
import json
import os
import sys
import traceback
from pathlib import Path

from tam570.checking import ALL_PASS, OUR_FAULT, SOME_FAIL

LIBRARIES = ("matplotlib", "numpy", "scipy", "sympy", "tam570")  # that may be imported in advance


def main(argument: str) -> int:
    """Carry out the order on standard input and return the exit code."""
    from tam570.checking import deadline, session
    from tam570.checking.trail import Trail

    ahead = json.loads(argument)
    if ahead:  # every module of tests imports these
        import numpy  # noqa: F401
        import pytest  # noqa: F401
    for file, slug in ahead:
        for path in (Path(file), *(module.path for module in session.tests_of(Path(file), slug))):
            _import_ahead(path)
    if not (line := sys.stdin.readline()):
        return SOME_FAIL  # the parent process has ended
    order = json.loads(line)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)  # input() fails, as in the grader
    os.chdir(order["empty"])  # without files, as in the grader
    deadline.start(order["hung"])
    trail = Trail(order["trail"])
    passed = [
        session.check(
            Path(file), slug, trail, changed=changed, functions=order["functions"], lost=order["lost"].get(slug, {})
        )
        for file, slug, changed in order["work"]
    ]
    return ALL_PASS if passed and all(passed) else SOME_FAIL


def _import_ahead(path: Path) -> None:
    """Import the libraries that a file imports; ignore its errors, which are reported when it runs."""
    with contextlib.suppress(OSError, SyntaxError, ValueError):
        nodes = [*ast.walk(ast.parse(path.read_text(encoding="utf-8")))]
        names = [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
        names += [node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)]
        for name in names:
            if name.partition(".")[0] in LIBRARIES:
                with contextlib.suppress(ImportError):
                    importlib.import_module(name)


if __name__ == "__main__":
    sys.stdout.reconfigure(line_buffering=True)  # type: ignore[union-attr]  # in a pipe, too: tests may take long
    try:
        code = main(sys.argv[1])
    except Exception:
        traceback.print_exc()
        code = OUR_FAULT
    sys.stdout.flush()
    os._exit(code)  # even if a student's code has left threads or exit handlers
