"""Adapt a course by `course.toml`: assignments, points, parts, limits, added checks, dates.

A generated folder in `.course`, beside `course.toml`, combines that file and the checkout. All commands use the folder
instead of the checkout, so nothing else needs to read `course.toml` for points, parts or checks. If one of the two
changes, a new folder is generated. The old ones are kept because a running command may use them.
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

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import ADDITIONS, OVERRIDES, LoadedAssignment
from tam570_grader.checks.rubric import with_rubric
from tam570_grader.course import late_policy
from tam570_grader.course.contract import contract, with_points
from tam570_grader.course.course_toml import COLUMNS, COPY, FILE, by_slug, is_number, must, no_other, toml
from tam570_grader.errors import UsageError, warn, writing
from tam570_grader.results.tables import written
from tam570_grader.sandbox.zygote import ResourceLimits

ADAPTED_COURSES = ".course"
VARIABLE = "TAM570_COURSE"  # environment variable that names a course, as --root does
REMEDY = "no autograder/checks and solutions; name a checkout of the course"
SHARED = ("shared", "autograder/tam570_grader", "pyproject.toml", "README.md", "LICENSE", "NOTATION.md")
TIMES = "One call may take {call} s of processor time, the whole submission {cpu} s."
STANDARD = {"call": 10, "cpu": 60, "memory": 1024}  # s, s, MiB, as in the options of `grade`
SUM = re.compile(r"^The autograder gives (?:all )?ten points", re.MULTILINE)


@dataclass(frozen=True)
class Changes:
    """What a course changes in one assignment."""

    points: Mapping[str, float]  # by check
    leave_out: Sequence[str] = ()  # letters of parts
    allow: Sequence[str] = ()  # names that are otherwise off limits
    checks: str = ""  # name of a file beside course.toml with added checks


def course_of(root: str | Path | None = None, graded: Iterable[Path] = (), *, is_told: bool = True) -> Path:
    """Return the folder of the course that a command uses.

    root    : the option --root
    graded  : paths of submissions; the course must not be inside one of them
    is_told : print which course it is
    """
    folder, why = _located(root, [path.resolve() for path in graded])
    base, path = _base_of(folder), folder / FILE
    if is_told:
        warn(f"course: {path if path.is_file() else folder} ({why})", "")
    return root_of(path, base) if path.is_file() else folder


def trust(folder: Path) -> None:
    """Add a course to the trusted ones; commands that run in its folder, or below, use it from now on."""
    folder = folder.resolve()
    if not _holds_course(folder):
        raise UsageError(f"{folder} holds no course: neither {FILE} nor autograder/checks and solutions are in it")
    path = _trusted_file()
    with writing(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        written(path, "".join(f"{line}\n" for line in sorted({*_trusted(), str(folder)})))


def _trusted_file() -> Path:
    return Path(os.environ.get("TAM570_HOME") or os.path.expanduser("~/.tam570")) / "trusted"


def _trusted() -> set[str]:
    """Return the trusted folders, and the checkout of an editable install, from which the grader itself runs."""
    path = _trusted_file()
    said = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
    return {*said, *map(str, assignments.INSTALLED)}


def _located(root: str | Path | None, graded: Sequence[Path]) -> tuple[Path, str]:
    """Return the course's folder and how it was chosen: by an option, the environment, trust, or the installation."""
    for name, why in ((root, "--root"), (os.environ.get(VARIABLE), VARIABLE)):
        if name:
            folder = Path(name).resolve()
            if not _holds_course(folder):
                raise UsageError(f"{name} does not hold a course: {REMEDY}")
            if any(map(folder.is_relative_to, graded)):
                raise UsageError(f"{folder}, which {why} names, lies in what is graded: name a course outside of it")
            return folder, why
    return _around(graded) or (assignments.find(), "installed")


def _around(graded: Sequence[Path]) -> tuple[Path, str] | None:
    """Return the nearest course at or above the working directory outside of `graded`; UsageError if untrusted."""
    trusted = _trusted()
    for folder in filter(_holds_course, (Path.cwd(), *Path.cwd().parents)):
        if any(map(folder.is_relative_to, graded)):
            if str(folder) in trusted:
                raise UsageError(
                    f"the course {folder} lies in what is graded: name the folder of the submissions alone"
                )
            warn(f"{folder} holds a course of its own, and lies in what is graded: it is not used")
        elif str(folder) in trusted:
            return folder, "installed" if folder in assignments.INSTALLED else "trusted"
        else:
            raise UsageError(
                f"the course {folder} is not trusted, and its checks would run as you; if you wrote it, give once: "
                f"tam570-grader trust {shlex.quote(str(folder))}; if it came with a submission, name yours with --root"
            )
    return None


def _holds_course(folder: Path) -> bool:
    return (folder / FILE).is_file() or assignments.is_checkout(folder)


def _base_of(folder: Path) -> Path:
    """Return the checkout that a course.toml changes: in its folder, the nearest trusted above, or the installed."""
    if assignments.is_checkout(folder):
        return folder
    trusted = _trusted()
    above = (parent for parent in folder.parents if str(parent) in trusted and assignments.is_checkout(parent))
    return next(above, None) or assignments.find()


def root_of(path: Path, base: Path) -> Path:
    """Return the folder generated from `path`, a course.toml, and the checkout `base`; generate it if it is missing."""
    parts = _parts(path, toml(path), assignments.slugs(base))
    root = path.parent / ADAPTED_COURSES / _digest(path, base, parts)
    if not root.is_dir():
        with writing(root), tempfile.TemporaryDirectory(prefix=f"{ADAPTED_COURSES}-", dir=path.parent) as draft:
            new = Path(draft) / root.name
            _make(path, base, parts, new)
            root.parent.mkdir(exist_ok=True)
            (root.parent / ".gitignore").write_text("*\n", encoding="utf-8")  # it contains solutions and checks
            try:
                os.rename(new, root)
            except OSError:
                if not root.is_dir():  # else another command has just generated the same folder
                    raise
    return root


def limits(root: Path) -> dict[str, int]:
    """Return the limits of a submission in s, s and MiB, as in STANDARD: the course's, else the standard ones."""
    path = root / COPY
    return {**STANDARD, **(toml(path).get("limits", {}) if path.is_file() else {})}


def resource_limits(root: Path, processes: int = 1, **chosen: int | None) -> ResourceLimits:
    """Return the limits of a submission for the sandbox: those chosen by options, else the course's."""
    most = {name: chosen.get(name) or usual for name, usual in limits(root).items()}
    return ResourceLimits(most["memory"] * 2**20, most["cpu"], most["call"], processes)


def _digest(path: Path, base: Path, parts: Mapping[str, Changes]) -> str:
    """Return a digest of course.toml, its added checks, this module, and the modification times of all copied files."""
    digest = hashlib.sha256(path.read_bytes() + str(base).encode() + Path(__file__).read_bytes())
    for checks in sorted({part.checks for part in parts.values() if part.checks}):
        digest.update((path.parent / checks).read_bytes())
    for folder in ("assignments", "solutions", "autograder/checks"):
        for file in sorted((base / folder).rglob("*")):
            if file.is_file() and "__pycache__" not in file.parts:
                digest.update(f"{file} {file.stat().st_mtime_ns}".encode())
    return digest.hexdigest()[:12]


def _make(path: Path, base: Path, parts: Mapping[str, Changes], new: Path) -> None:
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
        if part != Changes({}) or limits(new) != STANDARD:
            said = "".join(f"{name.upper()} = {value!r}\n" for name, value in vars(part).items() if name != "checks")
            written(folder / f"{OVERRIDES}.py", f'"""What {FILE} changes."""\n\n{said}')
            if part.checks:
                shutil.copyfile(path.parent / part.checks, folder / f"{ADDITIONS}.py")
            _rewrite_readme(path, assignments.assignment(new, slug), part, new / "assignments" / slug)


def _parts(path: Path, settings: Json, slugs: Sequence[str]) -> dict[str, Changes]:
    """Return the changes of each assignment of the course; raise UsageError for anything invalid in course.toml."""
    tables = {key: value for key, value in settings.items() if re.match(r"hw\d", key)}
    no_other(path, "", settings.keys() - tables, ("assignments", "limits", "late"))
    must(path, isinstance(settings.get("limits", {}), dict), "limits must be a table: write [limits] above its lines")
    no_other(path, "[limits] ", settings.get("limits", {}), [*STANDARD])
    for name, value in settings.get("limits", {}).items():
        is_positive = isinstance(value, int) and not isinstance(value, bool) and value > 0
        must(path, is_positive, f"[limits] {name} is {value!r}; write a whole number from 1 on")
    names = settings.get("assignments", [])
    must(path, _are_texts(names), 'assignments is a list of names, as in ["hw01", "hw07"]')
    for name in (*names, *tables):
        must(path, assignments.slug_of(name, slugs) is not None, f"there is no assignment {name!r}")
    chosen = assignments.match_slugs(names, slugs)
    changed = by_slug(path, tables, slugs)
    for slug, (key, _) in changed.items():
        must(path, slug in chosen, f"[{key}] is not among the assignments: add it there, or leave it out")
    parts = {slug: _part(path, *changed[slug]) if slug in changed else Changes({}) for slug in chosen}
    late_policy.policies(path, settings, chosen)
    return parts


def _part(path: Path, key: str, table: Json) -> Changes:
    must(path, isinstance(table, dict), f"{key} must be a table: write [{key}] above its lines")
    no_other(path, f"[{key}] ", table, [*(field.name for field in fields(Changes)), *late_policy.KEYS, *COLUMNS])
    for name in ("leave_out", "allow"):
        must(path, _are_texts(table.get(name, [])), f"[{key}] {name} must be a list of texts")
    for name in COLUMNS:
        column = table.get(name, "")
        good = isinstance(column, str | int) and not isinstance(column, bool)
        must(path, good, f"[{key}] {name} is {column!r}; write the heading of a column, or its id")
    points, checks = table.get("points", {}), table.get("checks", "")
    must(path, isinstance(points, dict), f"[{key}] points is a table of checks: write [{key}.points]")
    for check, value in points.items():
        must(path, is_number(value, 1e6), f"[{key}.points] {check} is {value!r}; write a number from 0 on")
    exists = isinstance(checks, str) and (not checks or (path.parent / checks).is_file())
    must(path, exists, f"[{key}] checks names {checks!r}, and there is no such file beside it")
    points = {name: float(value) for name, value in points.items()}
    return Changes(points, table.get("leave_out", []), table.get("allow", []), checks)


def _check(path: Path, assignment: LoadedAssignment, part: Changes) -> None:
    """Raise UsageError if the assignment does not have the checks, parts or names that course.toml changes."""
    key, parts = assignment.slug[:4], sorted({check.part for check in assignment.checks} | {*assignment.rubric})
    forbidden = sorted({name for names in assignment.forbidden.values() for name in names})
    no_other(path, f"[{key}.points] ", part.points, [check.name for check in assignment.checks])
    no_other(path, f"[{key}] leave_out: ", part.leave_out, parts)
    no_other(path, f"[{key}] allow: ", part.allow, forbidden)


def _are_texts(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(item, str) for item in value)


def _rewrite_readme(path: Path, assignment: LoadedAssignment, part: Changes, folder: Path) -> None:
    """Write the points, the parts left out and the names allowed into the students' README and contract."""
    must(path, bool(assignment.checks), f"[{assignment.slug[:4]}] leaves no check: leave the assignment out instead")
    readme = with_points((folder / "README.md").read_text(encoding="utf-8"), assignment.worth)
    more = [f"Part ({letter}) is left out in this course." for letter in part.leave_out]
    more += [f"In this course you may use `{name}`." for name in part.allow]
    sentences = " ".join([*more, f"The autograder gives {assignment.max_score:g} points"])
    for letter in part.leave_out:
        readme = re.sub(rf"^\*\*\({letter}\)\*\*.*?(?=^\*\*\([a-z]\)\*\*|^\||^#|\Z)", "", readme, flags=re.M | re.S)
    readme = readme.replace(TIMES.format(**STANDARD), TIMES.format(**limits(assignment.root)))
    readme = with_rubric(SUM.sub(lambda _: sentences, readme, count=1), assignment.rubric)
    written(folder / "README.md", readme)
    written(folder / "contract.json", contract(assignment))
