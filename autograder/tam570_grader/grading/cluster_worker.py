"""Code that runs in a cluster's worker: unpack the coordinator's checks; refuse to grade if results could differ."""

import functools
import hashlib
import importlib.metadata
import platform
import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from distributed import Worker, WorkerPlugin

from tam570_grader.checks import assignments
from tam570_grader.errors import UsageError
from tam570_grader.sandbox.launch import isolation
from tam570_grader.sandbox.pool import sandboxes

LIBRARIES = ("numpy", "scipy", "sympy", "matplotlib")  # scores may depend on their versions
_courses = dict[str, "CoursePlugin"]()  # the courses on this worker, by name


class CoursePlugin(WorkerPlugin):
    """The files of a course that grading needs; Dask sends them to every worker when it joins."""

    def __init__(self, files: Mapping[str, bytes], unconfined: bool) -> None:
        self.name = f"tam570-{hashlib.sha256(repr((sorted(files.items()), unconfined)).encode()).hexdigest()[:16]}"
        self.files, self.unconfined, self.coordinator = files, unconfined, _environment()
        self.folder, self.refuses = Path(), ""

    def setup(self, worker: Worker) -> None:
        self.refuses = self._refusal()
        self.folder = Path(worker.local_directory) / self.name
        self.folder.mkdir(mode=0o700, exist_ok=True)
        for name, content in self.files.items():
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        _courses[self.name] = self

    def teardown(self, worker: Worker) -> None:
        _courses.pop(self.name, None)
        shutil.rmtree(self.folder, ignore_errors=True)
        with sandboxes():
            pass

    def _refusal(self) -> str:
        """Return why this worker must not grade (other versions, no bubblewrap), with the remedy; "" if it may."""
        mine = _environment()
        other = [
            f"{what} {mine[what]}, not {coordinators}"
            for what, coordinators in self.coordinator.items()
            if mine[what] != coordinators
        ]
        if other:
            return f"it has {'; '.join(other)}: install there what the machine has that hands out"
        if isolation() != "bubblewrap" and not self.unconfined:
            return "it has no bubblewrap, or no namespaces for it: install it there, or let it be, with --unconfined"
        return ""


def course_for(root: Path, slugs: Sequence[str], unconfined: bool) -> CoursePlugin:
    """Return a plugin with the solutions and checks of these assignments, read from the course at `root`."""
    paths = [root / "solutions" / f"{slug}.py" for slug in slugs]
    for slug in slugs:
        paths += [path for path in assignments.checks_folder(root, slug).rglob("*") if path.is_file()]
    sources = [path for path in paths if "__pycache__" not in path.parts]
    return CoursePlugin({path.relative_to(root).as_posix(): path.read_bytes() for path in sorted(sources)}, unconfined)


def refusal(name: str) -> str:
    """Return why this worker refuses to grade this course, "" if it does not."""
    return _courses[name].refuses


def there(name: str, work: Callable[[Any], Any], task: Any) -> Any:
    """Return work(task), with this worker's copy of the course; raise UsageError if this worker must not grade."""
    course = _courses[name]
    if course.refuses:
        raise UsageError(f"the worker on {platform.node()} cannot grade: {course.refuses}")
    return work(replace(task, course=course.folder))


@functools.cache
def _environment() -> dict[str, str]:
    """Return what two machines must have in common to give the same scores: code, Python, architecture, libraries."""
    libraries = {name: importlib.metadata.version(name) for name in LIBRARIES}
    engine = assignments.engine_digest().hex()[:12]
    return {"grader": engine, "Python": platform.python_version(), "machine": platform.machine(), **libraries}
