"""Write a course for nbgrader: sources of the assignments, nbgrader's configuration, and a README."""

import shutil
import tempfile
from collections.abc import Sequence
from pathlib import Path
from string import Template

from tam570_grader.checks import assignments
from tam570_grader.course import course_config
from tam570_grader.errors import UsageError, counted, say, writing
from tam570_grader.release.notebook import write_notebook
from tam570_grader.results.tables import written

TEMPLATES = Path(__file__).parent / "templates"


def run(course: Path, folder: Path, slugs: Sequence[str]) -> int:
    """Write the course into a folder, but keep files that differ; return the exit code."""
    # a course generated from course.toml: name the folder of course.toml, so that later changes in it count
    checkout = course.parents[1] if course.parent.name == course_config.ADAPTED_COURSES else course
    modules = "".join(f'    "{slug}": ["{slug}.py"],\n' for slug in assignments.slugs(course))  # that students edit
    fields = {"checkout": repr(str(checkout)), "modules": modules, "first": slugs[0]}
    with writing(folder):
        for slug in slugs:
            _write_assignment(course, slug, folder / "source" / slug)
        for name, template in (("nbgrader_config.py", "nbgrader_config.txt"), ("README.md", "course.txt")):
            text = Template((TEMPLATES / template).read_text(encoding="utf-8")).substitute(fields)
            _write(folder / name, text.encode())
    say(f"{folder}: {counted(len(slugs), 'assignment')}; README.md there says how to go on", error=True)
    return 0


def _write(path: Path, content: bytes) -> None:
    """Write a file if there is none; keep one that differs (the instructor may have edited it) and print its path."""
    if not path.exists():
        written(path, content)  # atomic: a partial file would be kept as the instructor's
    elif path.read_bytes() != content:
        say(f"{path} left as you have it; to have it made anew, move it away", error=True)


def _write_assignment(course: Path, slug: str, folder: Path) -> None:
    """Write notebook, stub, visible tests, README and figure of an assignment."""
    released = course / "assignments" / slug
    names = f"{slug}.py", f"test_{slug}.py", "README.md"
    for name in names:
        if not (released / name).is_file():
            raise UsageError(f"{released / name} is missing: the assignment cannot be released yet")
    with tempfile.TemporaryDirectory() as draft:
        for name in (*names, *(path.name for path in released.glob("figure.svg"))):
            shutil.copyfile(released / name, Path(draft) / name)
        write_notebook(course, slug, Path(draft))
        folder.mkdir(parents=True, exist_ok=True)
        for new in sorted(Path(draft).iterdir()):
            _write(folder / new.name, new.read_bytes())
