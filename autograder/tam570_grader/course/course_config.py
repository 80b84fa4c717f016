"""A course of one's own, by `course.toml`: assignments, points, parts, limits, own checks, dates.

A folder in `.course`, beside it, is made of it and the checkout. All commands take that in the place of the checkout:
what an assignment is stands in one place still, and nothing else needs to know of `course.toml`. Whenever one of the
two changes, another folder is made. The old ones stay, for a command that still runs may use them.
"""

import hashlib
import os
import re
import shlex
import shutil
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import ADAPTED, OWN, LoadedAssignment
from tam570_grader.checks.rubric import with_rubric
from tam570_grader.course import late_policy
from tam570_grader.course.contract import contract, with_points
from tam570_grader.course.course_toml import COLUMNS, COPY, FILE, by_slug, must, no_other, toml
from tam570_grader.errors import UsageError, warn, writing
from tam570_grader.results.tables import written

__all__ = ["FILE", "PLACE", "course", "course_of", "limits", "root_of", "trust"]

PLACE = ".course"
VARIABLE = "TAM570_COURSE"  # of the environment: names a course, as --root does
REMEDY = "no autograder/checks and solutions; name a checkout of the course"
SHARED = ("shared", "autograder/tam570_grader", "pyproject.toml", "README.md", "LICENSE", "NOTATION.md")
TIMES = "One call may take {call} s of processor time, the whole submission {cpu} s."
STANDARD = {"call": 10, "cpu": 60, "memory": 1024}  # as the options of `grade`: s, s, MiB
SUM = re.compile(r"^The autograder gives (?:all )?ten points", re.MULTILINE)


@dataclass(frozen=True)
class Part:
    """What a course changes of one assignment."""

    points: Mapping[str, float]  # by check
    leave_out: Sequence[str] = ()  # letters of parts
    allow: Sequence[str] = ()  # what is otherwise off limits
    checks: str = ""  # a file with checks of one's own, beside course.toml


def course_of(root: str | Path | None, graded: Iterable[Path] = ()) -> Path:
    """Find the course that a command is about, and print which one it is.

    root : the option --root
    graded : what the command reads of students; the course may not come from there
    """
    place, why = _located(root, [path.resolve() for path in graded])
    base = _base_of(place)
    warn(f"course: {place / FILE if (place / FILE).is_file() else place} ({why})", "")
    return _made(place, base)


def course(given: str | Path | None = None) -> Path:
    """Find a course without a command line: at `given`, else as `course_of` does."""
    place, _ = _located(given, [])
    return _made(place, _base_of(place))


def trust(place: Path) -> None:
    """Remember a course: commands that are run in it, or below, use it from now on."""
    place = place.resolve()
    if not _holds_course(place):
        raise UsageError(f"{place} holds no course: neither {FILE} nor autograder/checks and solutions are in it")
    path = _trusted_file()
    with writing(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        written(path, "".join(f"{one}\n" for one in sorted({*_trusted(), str(place)})))


def _trusted_file() -> Path:
    return Path(os.environ.get("TAM570_HOME") or os.path.expanduser("~/.tam570")) / "trusted"


def _trusted() -> set[str]:
    """The folders that `trust` remembers, and the editable install, which the grader itself comes from."""
    path = _trusted_file()
    said = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
    return {*said, *map(str, assignments.INSTALLED)}


def _located(given: str | Path | None, graded: Sequence[Path]) -> tuple[Path, str]:
    """Where the course is, and who says so: an option, the environment, trust, or the install."""
    for named, why in ((given, "--root"), (os.environ.get(VARIABLE), VARIABLE)):
        if named:
            place = Path(named).resolve()
            if not _holds_course(place):
                raise UsageError(f"{named} does not hold a course: {REMEDY}")
            if any(map(place.is_relative_to, graded)):
                raise UsageError(f"{place}, which {why} names, lies in what is graded: name a course outside of it")
            return place, why
    return _around(graded) or (assignments.find(), "installed")


def _around(graded: Sequence[Path]) -> tuple[Path, str] | None:
    """The nearest course above the working directory, if it is trusted; UsageError for one that is not.

    A course that lies in what is graded is a student's, and passed by.
    """
    trusted = _trusted()
    for place in filter(_holds_course, (Path.cwd(), *Path.cwd().parents)):
        if any(map(place.is_relative_to, graded)):
            if str(place) in trusted:
                raise UsageError(f"the course {place} lies in what is graded: name the folder of the submissions alone")
            warn(f"{place} holds a course of its own, and lies in what is graded: it is not used")
        elif str(place) in trusted:
            return place, "installed" if place in assignments.INSTALLED else "trusted"
        else:
            raise UsageError(
                f"the course {place} is not trusted, and its checks would run as you; if you wrote it, give once: "
                f"tam570-grader trust {shlex.quote(str(place))}; if it came with a submission, name yours with --root"
            )
    return None


def _holds_course(place: Path) -> bool:
    return (place / FILE).is_file() or assignments.is_checkout(place)


def _base_of(place: Path) -> Path:
    """The checkout that a course.toml changes: at its own place, above it and trusted, or the installed one."""
    if assignments.is_checkout(place):
        return place
    trusted = _trusted()
    above = (one for one in place.parents if str(one) in trusted and assignments.is_checkout(one))
    return next(above, None) or assignments.find()


def _made(place: Path, base: Path) -> Path:
    return root_of(place / FILE, base) if (place / FILE).is_file() else place


def root_of(path: Path, base: Path) -> Path:
    """The course that `path`, a course.toml, makes of the checkout `base`; another folder whenever either changes."""
    parts = _parts(path, toml(path), assignments.slugs(base))
    place = path.parent / PLACE / _stamp(path, base, parts)
    if not place.is_dir():
        with writing(place), tempfile.TemporaryDirectory(prefix=f"{PLACE}-", dir=path.parent) as draft:
            new = Path(draft) / place.name
            _make(path, base, parts, new)
            place.parent.mkdir(exist_ok=True)
            (place.parent / ".gitignore").write_text("*\n", encoding="utf-8")  # solutions and checks are in it
            _put(new, place)
    return place


def _put(new: Path, place: Path) -> None:
    """Give a folder its place, unless another command has made the same one meanwhile."""
    try:
        os.rename(new, place)
    except OSError:
        if not place.is_dir():
            raise


def limits(root: Path) -> dict[str, int]:
    """The limits of a submission, as the options of `grade` have them: of the course, else the standard ones."""
    path = root / COPY
    return {**STANDARD, **(toml(path).get("limits", {}) if path.is_file() else {})}


def _stamp(path: Path, base: Path, parts: Mapping[str, Part]) -> str:
    """Of course.toml, the checks that it names, how a course is made, and the times of all that is copied."""
    found = hashlib.sha256(path.read_bytes() + str(base).encode() + Path(__file__).read_bytes())
    for own in sorted({part.checks for part in parts.values() if part.checks}):
        found.update((path.parent / own).read_bytes())
    for folder in ("assignments", "solutions", "autograder/checks"):
        for file in sorted((base / folder).rglob("*")):
            if file.is_file() and "__pycache__" not in file.parts:
                found.update(f"{file} {file.stat().st_mtime_ns}".encode())
    return found.hexdigest()[:12]


def _make(path: Path, base: Path, parts: Mapping[str, Part], new: Path) -> None:
    for name in SHARED:
        (new / name).parent.mkdir(parents=True, exist_ok=True)
        os.symlink(base / name, new / name)
    shutil.copyfile(path, new / COPY)
    for slug, part in parts.items():
        _check(path, assignments.assignment(base, slug), part)
        for name in (f"assignments/{slug}", f"autograder/checks/{slug}"):
            shutil.copytree(base / name, new / name, ignore=shutil.ignore_patterns("__pycache__"))
        (new / "solutions").mkdir(exist_ok=True)
        shutil.copyfile(base / "solutions" / f"{slug}.py", new / "solutions" / f"{slug}.py")
        folder = assignments.checks_folder(new, slug)
        if part != Part({}) or limits(new) != STANDARD:
            said = "".join(f"{name.upper()} = {value!r}\n" for name, value in vars(part).items() if name != "checks")
            written(folder / f"{ADAPTED}.py", f'"""What {FILE} changes."""\n\n{said}')
            if part.checks:
                shutil.copyfile(path.parent / part.checks, folder / f"{OWN}.py")
            _tell(path, assignments.assignment(new, slug), part, new / "assignments" / slug)


def _parts(path: Path, given: Mapping[str, Any], known: Sequence[str]) -> dict[str, Part]:
    """What changes of each assignment that the course has."""
    tables = {key: value for key, value in given.items() if re.match(r"hw\d", key)}
    no_other(path, "", given.keys() - tables, ("assignments", "limits", "late"))
    must(path, isinstance(given.get("limits", {}), dict), "limits must be a table: write [limits] above its lines")
    no_other(path, "[limits] ", given.get("limits", {}), [*STANDARD])
    for name, value in given.get("limits", {}).items():
        whole = isinstance(value, int) and not isinstance(value, bool) and value > 0
        must(path, whole, f"[limits] {name} is {value!r}; write a whole number from 1 on")
    names = given.get("assignments", [])
    must(path, _are_texts(names), 'assignments is a list of names, as in ["hw01", "hw07"]')
    for name in (*names, *tables):
        must(path, assignments.slug_of(name, known) is not None, f"there is no assignment {name!r}")
    chosen = assignments.named(names, known)
    changed = by_slug(path, tables, known)
    for slug, (key, _) in changed.items():
        must(path, slug in chosen, f"[{key}] is not among the assignments: add it there, or leave it out")
    parts = {slug: _part(path, *changed[slug]) if slug in changed else Part({}) for slug in chosen}
    late_policy.policies(path, given, chosen)
    return parts


def _part(path: Path, key: str, table: Any) -> Part:
    must(path, isinstance(table, dict), f"{key} must be a table: write [{key}] above its lines")
    no_other(path, f"[{key}] ", table, [*(one.name for one in fields(Part)), *late_policy.KEYS, *COLUMNS])
    for name in ("leave_out", "allow"):
        must(path, _are_texts(table.get(name, [])), f"[{key}] {name} must be a list of texts")
    for name in COLUMNS:
        column = table.get(name, "")
        good = isinstance(column, str | int) and not isinstance(column, bool)
        must(path, good, f"[{key}] {name} is {column!r}; write the heading of a column, or its id")
    points, own = table.get("points", {}), table.get("checks", "")
    must(path, isinstance(points, dict), f"[{key}] points is a table of checks: write [{key}.points]")
    for check, value in points.items():
        good = isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < 1e6
        must(path, good, f"[{key}.points] {check} is {value!r}; write a number from 0 on")
    found = isinstance(own, str) and (not own or (path.parent / own).is_file())
    must(path, found, f"[{key}] checks names {own!r}, and there is no such file beside it")
    points = {name: float(value) for name, value in points.items()}
    return Part(points, table.get("leave_out", []), table.get("allow", []), own)


def _check(path: Path, assignment: LoadedAssignment, part: Part) -> None:
    """Whether the assignment has what is changed."""
    key, parts = assignment.slug[:4], sorted({check.part for check in assignment.checks} | {*assignment.manual})
    forbidden = sorted({name for names in assignment.forbidden.values() for name in names})
    no_other(path, f"[{key}.points] ", part.points, [check.name for check in assignment.checks])
    no_other(path, f"[{key}] leave_out: ", part.leave_out, parts)
    no_other(path, f"[{key}] allow: ", part.allow, forbidden)


def _are_texts(value: Any) -> bool:
    return isinstance(value, list) and all(isinstance(one, str) for one in value)


def _tell(path: Path, assignment: LoadedAssignment, part: Part, folder: Path) -> None:
    """Put the points, and what is left out or allowed, into what students get."""
    must(path, bool(assignment.checks), f"[{assignment.slug[:4]}] leaves no check: leave the assignment out instead")
    readme = with_points((folder / "README.md").read_text(encoding="utf-8"), assignment.worth)
    more = [f"Part ({letter}) is left out in this course." for letter in part.leave_out]
    more += [f"In this course you may use `{name}`." for name in part.allow]
    says = " ".join([*more, f"The autograder gives {assignment.max_score:g} points"])
    for letter in part.leave_out:
        readme = re.sub(rf"^\*\*\({letter}\)\*\*.*?(?=^\*\*\([a-z]\)\*\*|^\||^#|\Z)", "", readme, flags=re.M | re.S)
    readme = readme.replace(TIMES.format(**STANDARD), TIMES.format(**limits(assignment.root)))
    readme = with_rubric(SUM.sub(lambda _: says, readme, count=1), assignment.rubric)
    written(folder / "README.md", readme)
    written(folder / "contract.json", contract(assignment))
