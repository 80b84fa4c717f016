"""Gradescope: results in its format, and the archives that it runs."""

import io
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from string import Template

from tam570.values import Json
from tam570_grader.course.course_toml import COPY
from tam570_grader.errors import counted, say, writing
from tam570_grader.grading.seeds import new_seed
from tam570_grader.reports.feedback import overall
from tam570_grader.results.store import Record
from tam570_grader.results.tables import written

TEMPLATES = Path(__file__).parent / "templates"
EXECUTABLE, PRIVATE = 0o755 << 16, 0o600 << 16  # modes of files in a zip archive
ENGINE = ("pyproject.toml", "README.md", "LICENSE", "shared/tam570", "autograder/tam570_grader")


def results(record: Record, lines: Mapping[str, str]) -> Json:
    """Return `results.json` of one submission (gradescope-autograders.readthedocs.io, "Autograder Specifications").

    Each check is a test that is visible to the student; none reveals hidden inputs.
    """
    tests = []
    for check in record["checks"]:
        passed = check["outcome"] == "passed"
        tests.append(
            {
                "score": check["points"],
                "max_score": check["max_points"],
                "status": "passed" if passed else "failed",
                "name": f"({check['part']}) {lines.get(check['name'], check['name'])}",
                "output": "" if passed else f"{check['outcome'].replace('_', ' ')}: {check['message']}",
                "output_format": "text",
                "visibility": "visible",
            }
        )
    return {
        "score": record["score"],
        "execution_time": record["seconds"],
        "output": overall(record["status"], record.get("message", "")),
        "output_format": "text",
        "stdout_visibility": "hidden",
        "tests": tests,
    }


def run(course: Path, folder: Path, slugs: Sequence[str]) -> int:
    """Write an archive for each assignment into a folder; return the exit code."""
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
    for slug in slugs:
        _write_archive(course, slug, folder / f"{slug}.zip")
    sentence = "upload each to its assignment; they hold solutions and checks, so keep them to yourself"
    say(f"{folder}: {counted(len(slugs), 'archive')}; {sentence}", error=True)
    return 0


def _write_archive(course: Path, slug: str, path: Path) -> None:
    """Write an archive with setup.sh and run_autograder at the top, as Gradescope requires, the seed and the course."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in ("setup.sh", "run_autograder"):
            text = (TEMPLATES / name).read_text(encoding="utf-8")
            entry = zipfile.ZipInfo(name)
            entry.external_attr = EXECUTABLE
            archive.writestr(entry, Template(text).substitute(slug=slug))
        # the archive's seed gives the class the same inputs; in a file for root only, as command lines are visible
        entry = zipfile.ZipInfo("seed")
        entry.external_attr = PRIVATE
        archive.writestr(entry, f"{new_seed()}\n")
        for file in _files(course, slug):
            archive.write(file, Path("course") / file.relative_to(course))
    with writing(path):
        written(path, buffer.getvalue())


def _files(course: Path, slug: str) -> Iterator[Path]:
    """Yield the files of the grader and of this assignment."""
    places = [*ENGINE, COPY, f"assignments/{slug}", f"solutions/{slug}.py", f"autograder/checks/{slug}"]
    for path in map(course.joinpath, places):
        files = path.rglob("*") if path.is_dir() else [path]
        yield from sorted(file for file in files if file.is_file() and "__pycache__" not in file.parts)
