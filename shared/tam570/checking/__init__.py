"""Run the visible tests of assignments on a student's files, each time in a new process that is killed if it hangs.

The process for the next run of a watched file starts in advance and imports the libraries before the file is saved.
It runs the tests once and ends, so that nothing remains of an older version of the file.
"""

import contextlib
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from tam570.checking.trail import last_step
from tam570.values import Json

PAUSE = 0.05  # s between checks of the files: two calls of stat each
ALL_PASS, SOME_FAIL, OUR_FAULT = 10, 11, 12  # exit codes; with any other, the student's code ended the process
ENDED = "Your code ended the process that tests it{where}: it exits, crashes or uses too much memory."
HUNG = "Your code ran out of time{where}, and cannot be interrupted. Is there an endless loop?"
FAILED = "The tests could not be run; the lines above say why. Please tell your teacher."
Work = Sequence[tuple[Path, str]]  # files and their assignments


def check(work: Work, functions: Sequence[str] = ()) -> int:
    """Check these files, or only these functions; return the exit code: 0 if all tests pass, 1 if some fail."""
    runner = Runner([])
    try:
        runner.run(work, changed=False, functions=functions)
        while successor := runner.successor([]):
            runner = successor
        return runner.result()
    finally:
        runner.end()


def watch(work: Work) -> int:
    """Check these files now, and each again when it is saved, until Ctrl-C; return the exit code."""
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
                    return 1  # the process could not start and has printed why
                if successor := runner.successor(work):
                    runner = successor
                    continue
                runner.result()
                runner = Runner(work)
            saved = [(file, slug) for file, slug in work if _stamp(file, slug) not in (None, seen[file])]
            if saved:
                seen |= {file: _stamp(file, slug) for file, slug in saved}
                if not runner.idle:
                    runner.end()
                    runner = Runner(work)
                print(f"\n{time.strftime('%H:%M:%S')} {', '.join(slug for _, slug in saved)}", flush=True)
                runner.run(saved, changed=True)
    except KeyboardInterrupt:
        print("\nno longer watching")
        return 0
    finally:
        runner.end()


class Runner:
    """A process that waits for an order, runs the tests once, and ends; it imports libraries of `ahead` in advance."""

    def __init__(self, ahead: Work) -> None:
        prepared = [[str(file.resolve()), slug] for file, slug in ahead]
        self.idle = True
        self._folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self._trail, self._hung, self._empty = (Path(self._folder.name, name) for name in ("step", "hung", "empty"))
        self._empty.mkdir()
        self._order: Json = {}
        self._process = subprocess.Popen(
            # -P: import no module from the current folder
            [sys.executable, "-P", "-m", "tam570.checking", json.dumps(prepared)],
            stdin=subprocess.PIPE,
            text=True,
            env=_environment(),
            start_new_session=os.name == "posix",
            creationflags=getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0),  # Ctrl-C ends only this process
        )

    def run(self, work: Work, *, changed: bool, functions: Sequence[str] = ()) -> None:
        """Order the process to check these files; with `changed`, only tests whose outcome may have changed."""
        files = [[str(file.resolve()), slug, changed] for file, slug in work]
        self._follow({"work": files, "functions": list(functions), "lost": {}})

    def _follow(self, order: Json) -> None:
        self.idle, self._order = False, order
        assert self._process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            order = {**order, "trail": str(self._trail), "hung": str(self._hung), "empty": str(self._empty)}
            print(json.dumps(order), file=self._process.stdin, flush=True)

    def successor(self, ahead: Work) -> "Runner | None":
        """Wait for the end; if a student's function caused it, return a runner that continues without it, else None."""
        if self._process.wait() in (ALL_PASS, SOME_FAIL, OUR_FAULT):
            return None
        step, lost = last_step(self._trail), self._order["lost"]
        slug, function = step["slug"], step["function"]
        if not function or function in lost.get(slug, {}):
            return None
        done = [name for _, name, _ in self._order["work"]].index(slug)
        lost = {**lost, slug: {**lost.get(slug, {}), function: self._is_out_of_time()}}
        runner = Runner(ahead)
        runner._follow({**self._order, "work": self._order["work"][done:], "lost": lost})
        self.end()
        return runner

    def _is_out_of_time(self) -> bool:
        return self._hung.exists() and self._hung.stat().st_size > 0

    def ended(self) -> bool:
        return self._process.poll() is not None

    def result(self) -> int:
        """Wait for the end and return 0 if all tests pass, else 1; print a message if the student's code caused it."""
        code = self._process.wait()
        if code not in (ALL_PASS, SOME_FAIL):
            test = last_step(self._trail)["test"]
            ended = (HUNG if self._is_out_of_time() else ENDED).format(
                where=f" in {test}" if test else " while it was imported"
            )
            print(FAILED if code == OUR_FAULT else ended, file=sys.stderr, flush=True)
        return 0 if code == ALL_PASS else 1

    def end(self) -> None:
        self._process.kill()
        self._process.communicate()
        self._folder.cleanup()


def _environment() -> dict[str, str]:
    """Return the environment: no windows, one thread, and a folder for Matplotlib if the home folder is read-only."""
    settings = {"MPLBACKEND": "agg", "OPENBLAS_NUM_THREADS": "1", **os.environ}
    settings["PYTHONIOENCODING"] = f"{sys.stdout.encoding}:replace"
    if not os.access(os.path.expanduser("~"), os.W_OK):
        settings.setdefault("MPLCONFIGDIR", os.path.join(tempfile.gettempdir(), "tam570-matplotlib"))
    return settings


def _stamp(file: Path, slug: str) -> tuple[float, ...] | None:
    """Return times and sizes that change when the file or its tests are saved; None while an editor replaces it."""
    try:
        stats = [file.stat()]
        tests = file.parent / f"test_{slug}.py"
        stats += [tests.stat()] if tests.exists() else []
    except OSError:
        return None
    return tuple(number for stat in stats for number in (stat.st_mtime_ns, stat.st_size))
