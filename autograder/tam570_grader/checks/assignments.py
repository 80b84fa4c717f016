"""Find the checkout of the course, and load its assignments, solutions and checks by path."""

import ast
import functools
import hashlib
import importlib
import os
import re
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

import tam570
from tam570.values import Numbers
from tam570_grader.checks.assignment import Assignment
from tam570_grader.checks.check import Check, draw_once
from tam570_grader.checks.effort import PACKAGES, Finder
from tam570_grader.checks.rubric import ManualPart, load_rubric
from tam570_grader.errors import UsageError

if TYPE_CHECKING:
    from tam570_grader.checks.figures import Figure

INSTALLED = tuple(Path(tam570.__file__).resolve().parents[1:3])  # possible roots of an editable install
sys.meta_path.insert(0, Finder)  # their steps are counted
OVERRIDES, ADDITIONS = "adapted", "own"  # modules beside `checks` in an adapted course


@dataclass(frozen=True, kw_only=True)
class LoadedAssignment(Assignment):
    """An assignment with all that the grader needs."""

    slug: str
    checks: tuple[Check, ...]
    rubric: Mapping[str, ManualPart]  # parts graded by hand, by letter
    root: Path

    @property
    def solution(self) -> str:
        """The source of the reference solution."""
        return (self.root / "solutions" / f"{self.slug}.py").read_text(encoding="utf-8")

    @property
    def solutions(self) -> list[str]:
        """The source of the reference solution, alone and followed by each of `other_functions`."""
        others = other_functions(checks_folder(self.root, self.slug))
        return [self.solution, *(f"{self.solution}\n\n{other}" for other in others)]

    def signature(self, name: str) -> str:
        """Return the parameters of a function of the contract, as text: `amplitude, *, length, gravity`."""
        defined = (node for node in ast.parse(self.solution).body if isinstance(node, ast.FunctionDef))
        return next((ast.unparse(node.args) for node in defined if node.name == name), "...")

    @property
    def worth(self) -> dict[str, float]:
        """The points of each function: the sum over the checks that are about it."""
        checks = self.checks
        return {name: sum(check.points for check in checks if check.function == name) for name in self.returns}

    @property
    def max_score(self) -> float:
        return round(sum(check.points for check in self.checks), 6)


def find() -> Path:
    """Return the checkout of an editable install; raise UsageError if there is none."""
    if checkout := next(filter(is_checkout, INSTALLED), None):
        return checkout
    message = "no course is installed: no autograder/checks and solutions; name a checkout of the course with --root"
    raise UsageError(message)


def is_checkout(folder: Path) -> bool:
    """Return whether a folder contains the checks and solutions of a course."""
    return (folder / "autograder" / "checks").is_dir() and (folder / "solutions").is_dir()


def slugs(root: Path) -> list[str]:
    """Return the slugs of the assignments that have checks, in order."""
    return sorted(path.parent.name for path in (root / "autograder" / "checks").glob("hw*/checks.py"))


def other_functions(folder: Path) -> list[str]:
    """Return the sources of right functions of the assignment that use its other functions, or differ in form."""
    return [path.read_text(encoding="utf-8") for path in sorted(folder.glob("consequences*.py"))]


def alternatives(root: Path, slug: str) -> dict[str, str]:
    """Return the right submissions in other styles, by name."""
    paths = sorted((checks_folder(root, slug) / "alternatives").glob("*.py"))
    return {path.stem: path.read_text(encoding="utf-8") for path in paths}


def checks_folder(root: Path, slug: str) -> Path:
    """Return the folder with all hidden files of an assignment."""
    return root / "autograder" / "checks" / slug


def title(root: Path, slug: str) -> str:
    """Return the title of an assignment: the heading of its README without the number, else its slug."""
    try:
        with open(root / "assignments" / slug / "README.md", encoding="utf-8") as file:
            return file.readline().partition(": ")[2].strip() or slug
    except OSError:
        return slug


def slug_of(name: str, slugs: Sequence[str]) -> str | None:
    """Return the slug for the name of a file or folder, such as hw07, HW7, homework 7 or hw07-final; else None."""
    if name in slugs:
        return name
    number = re.match(r"(?:hw|homework)[ _-]*(\d{1,2})(?!\d)", name, re.IGNORECASE)
    return next((slug for slug in slugs if number and slug.startswith(f"hw{int(number[1]):02}_")), None)


def match_slugs(names: Iterable[str], slugs: Sequence[str]) -> list[str]:
    """Return the slugs for these names on the command line, all slugs if there are none; else raise UsageError."""
    matches = [(name, slug_of(name, slugs)) for name in names]
    if unknown := [name for name, slug in matches if slug is None]:
        raise UsageError(f"there is no assignment {unknown[0]!r}; there are: {', '.join(slugs)}")
    return [slug for _, slug in matches if slug] or list(slugs)


def match_slug(name: str | None, slugs: Sequence[str]) -> str | None:
    """Return the slug for the option --assignment; None without it."""
    return match_slugs([name], slugs)[0] if name else None


@functools.cache
def assignment(root: Path, slug: str) -> LoadedAssignment:
    """Load an assignment from its checks and rubric, with the overrides of an adapted course."""
    (slug,) = match_slugs([slug], slugs(root))
    folder = checks_folder(root, slug)
    module = _checks(folder)
    checks, stated = _named_checks(module), _stated(module)
    rubric = load_rubric(root / "assignments" / slug)
    if unknown := [check.name for check in checks if check.function not in stated.returns]:
        raise UsageError(f"{slug}: the check {unknown[0]} is about no function of the assignment")
    loaded = LoadedAssignment(slug=slug, checks=checks, rubric=rubric, root=root, **vars(stated))
    return _adapted(loaded, folder) if (folder / f"{OVERRIDES}.py").exists() else loaded


@functools.cache
def sandbox_imports(root: Path, slug: str) -> tuple[frozenset[str], frozenset[str]]:
    """Parse a sandbox's imports and off-limits names from the checks' source, so that it can start before they load."""
    (slug,) = match_slugs([slug], slugs(root))
    record = ast.parse((checks_folder(root, slug) / "checks.py").read_bytes()).body[-1]
    stated = record.value.keywords if isinstance(record, ast.Assign) and isinstance(record.value, ast.Call) else []
    values = {field.arg: field.value for field in stated}
    try:
        needs, forbidden = (ast.literal_eval(values[name]) for name in ("needs", "forbidden"))
    except (KeyError, ValueError):
        raise UsageError(f"{slug}: ASSIGNMENT ends its checks, with needs and forbidden as plain texts") from None
    return frozenset(needs), frozenset(forbidden.get("*", ()))


def _adapted(original: LoadedAssignment, folder: Path) -> LoadedAssignment:
    """Return an assignment with the points, parts and checks of an adapted course."""
    change, added = importlib.import_module(f"{PACKAGES}{folder.name}.{OVERRIDES}"), None
    if (folder / f"{ADDITIONS}.py").exists():
        added = importlib.import_module(f"{PACKAGES}{folder.name}.{ADDITIONS}")
    checks = {
        check.name: replace(check, points=change.POINTS.get(check.name, check.points)) for check in original.checks
    }
    chosen = {name: check for name, check in checks.items() if check.part not in change.LEAVE_OUT and check.points}
    chosen |= {check.name: check for check in (_named_checks(added) if added else ())}
    forbidden = {
        where: [name for name in names if name not in change.ALLOW] for where, names in original.forbidden.items()
    }
    return replace(
        original,
        checks=tuple(
            replace(check, after=tuple(chosen[each.name] for each in check.after if each.name in chosen))
            for check in chosen.values()
        ),
        returns={**original.returns, **(_stated(added).returns if added and hasattr(added, "ASSIGNMENT") else {})},
        forbidden={where: names for where, names in forbidden.items() if names},
        rubric={letter: part for letter, part in original.rubric.items() if letter not in change.LEAVE_OUT},
    )


def rubric_of(root: Path, slug: str) -> Mapping[str, ManualPart]:
    """Return the parts graded by hand, by letter; load the checks only if the course is adapted."""
    is_adapted = (checks_folder(root, slug) / f"{OVERRIDES}.py").exists()
    return assignment(root, slug).rubric if is_adapted else load_rubric(root / "assignments" / slug)


def solution(slug: str, root: Path | None = None) -> ModuleType:
    """Load the reference solution as a new module."""
    path, name = (root or find()) / "solutions" / f"{slug}.py", f"_solution_{slug}"
    module = sys.modules[name] = ModuleType(name)
    exec(compile(path.read_bytes(), path, "exec"), vars(module))
    return module


@functools.cache
def figure(root: Path, slug: str, **parameters: Numbers) -> "Figure | None":
    """Return the figure of an assignment, drawn with its reference functions; None if it has none.

    parameters : other values of the parameters that the figure shows
    """
    folder = checks_folder(root, slug)
    if not (folder / "figure.py").exists():
        return None
    _checks(folder)
    drawn: Figure = importlib.import_module(f"_checks_{slug}.figure").figure(**parameters)
    return drawn


def checks_digest(root: Path, slug: str) -> bytes:
    """Return the digest of an assignment's hidden Python files, without loading them."""
    return _digest(checks_folder(root, slug))


@functools.cache
def engine_digest() -> bytes:
    """Return the digest of the code of the grader and of `tam570`: results may change if it does."""
    return _digest(Path(__file__).parents[1], Path(tam570.__file__).parent)


def _digest(*folders: Path) -> bytes:
    """Return the digest of paths and contents of all Python files in folders, except stubs in an installed course."""
    digest = hashlib.sha256()
    for folder in map(str, folders):  # strings: Path objects would take a third of the time
        paths = (f"{parent}/{name}" for parent, _, names in os.walk(folder) for name in names if name.endswith(".py"))
        for path in sorted(path.removeprefix(f"{folder}/") for path in paths):
            if not path.startswith("assignments/"):
                with open(f"{folder}/{path}", "rb", buffering=0) as file:
                    digest.update(f"{path}\0".encode() + file.read())
    return digest.digest()


def _checks(folder: Path) -> ModuleType:
    """Load the module `checks` of a folder in a package with a private name, so that it can import its neighbours."""
    name = f"{PACKAGES}{folder.name}"
    package = ModuleType(name)
    package.__path__ = [str(folder)]
    for loaded in [key for key in sys.modules if key == name or key.startswith(f"{name}.")]:
        del sys.modules[loaded]
    sys.modules[name] = package
    if (folder / "cases.py").exists():
        draw_once(importlib.import_module(f"{name}.cases"))
    return importlib.import_module(f"{name}.checks")


def _stated(module: ModuleType) -> Assignment:
    """Return the ASSIGNMENT of a module of checks; raise UsageError if it has none."""
    stated = getattr(module, "ASSIGNMENT", None)
    if not isinstance(stated, Assignment):
        raise UsageError(f"{module.__file__} does not end in ASSIGNMENT = Assignment(...)")
    return stated


def _named_checks(module: ModuleType) -> tuple[Check, ...]:
    return tuple(value for value in vars(module).values() if isinstance(value, Check))
