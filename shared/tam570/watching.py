"""Tests what is saved, as soon as it is saved.

The interpreter that will run the tests is started ahead and has imported pytest and the libraries by the time a file
is saved; each runs once, so nothing of an older version of the file is left in it, and one that hangs is ended by
the next save.
"""

import ast
import contextlib
import importlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from pathlib import Path

__all__ = ["watch"]

PAUSE = 0.05  # s between two looks at the files: two calls of stat each
LIBRARIES = ("matplotlib", "numpy", "pytest", "scipy", "sympy", "tam570")  # what may be imported ahead
Work = Sequence[tuple[Path, str]]  # files and their assignments


def watch(work: Work) -> int:
    """Check these files now, and each again when it is saved, until Ctrl-C; the exit code."""
    names = ", ".join(str(file) for file, _ in work)
    print(f"watching {names}; Ctrl-C ends it", flush=True)
    runner = Runner(work)
    try:
        runner.run(work, changed=False)
        seen = {file: _stamp(file, slug) for file, slug in work}
        while True:
            time.sleep(PAUSE)
            if runner.ended():
                if runner.idle:
                    return 1  # it could not start, and has said why
                runner = Runner(work)
            saved = [(file, slug) for file, slug in work if _stamp(file, slug) not in (None, seen[file])]
            if saved:
                seen |= {file: _stamp(file, slug) for file, slug in saved}
                runner = runner if runner.idle else runner.replaced(work)
                print(f"\n{time.strftime('%H:%M:%S')} {', '.join(slug for _, slug in saved)}", flush=True)
                runner.run(saved, changed=True)
    except KeyboardInterrupt:
        print("\nno longer watching")
        return 0
    finally:
        runner.end()


class Runner:
    """An interpreter that waits for an order, runs the tests once, and ends."""

    def __init__(self, work: Work) -> None:
        files = [str(file) for file, _ in work]
        slugs = [slug for _, slug in work]
        group = getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0)  # Ctrl-C is for the one that watches
        self.idle = True
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tam570.watching", json.dumps([files, slugs])],
            stdin=subprocess.PIPE,
            text=True,
            start_new_session=os.name == "posix",
            creationflags=group,
        )

    def run(self, work: Work, *, changed: bool) -> None:
        """Give it its order."""
        self.idle = False
        order = [[str(file), slug, changed] for file, slug in work]
        assert self._process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            print(json.dumps(order), file=self._process.stdin, flush=True)

    def ended(self) -> bool:
        return self._process.poll() is not None

    def replaced(self, work: Work) -> "Runner":
        """End it in the middle of its work; a new one."""
        self.end()
        return Runner(work)

    def end(self) -> None:
        self._process.kill()
        self._process.communicate()


def _stamp(file: Path, slug: str) -> tuple[float, ...] | None:
    """What changes when the file or its tests are saved; None while an editor is replacing the file."""
    try:
        found = [file.stat()]
        tests = file.parent / f"test_{slug}.py"
        found += [tests.stat()] if tests.exists() else []
    except OSError:
        return None
    return tuple(number for stat in found for number in (stat.st_mtime_ns, stat.st_size))


def _wait(files: Iterable[str], slugs: Iterable[str]) -> int:
    """The runner: import ahead, read the order, follow it."""
    from tam570.checking import check, tests_of, warm_up

    warm_up()
    for file, slug in zip(map(Path, files), slugs, strict=True):
        for path in (file, tests_of(file, slug)):
            _import_ahead(path)
    order = sys.stdin.readline()
    return max(
        (check(Path(file), slug, changed=changed) for file, slug, changed in json.loads(order or "[]")), default=0
    )


def _import_ahead(path: Path) -> None:
    """Import what the file imports, as far as it is a library; what is wrong with the file shows when it runs."""
    with contextlib.suppress(OSError, SyntaxError, ValueError):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module] if isinstance(node, ast.ImportFrom) and node.module else []
            for name in names:
                if name.partition(".")[0] in LIBRARIES:
                    with contextlib.suppress(ImportError):
                        importlib.import_module(name)


if __name__ == "__main__":
    sys.exit(_wait(*json.loads(sys.argv[1])))
