"""A student's progress by the visible tests and in the hints, stored between commands."""

import json
import os
import re
from collections.abc import Mapping
from pathlib import Path

from tam570.course import folder
from tam570.releases import digest, record
from tam570.values import Json

PASSED, FAILED = "passed", "failed"
PROGRESS, HINTS = "progress.json", "hints.json"  # files in the home folder
ROW = re.compile(r"^\| `(\w+)\(.*?\| *([\d.]+) *\|", re.MULTILINE)
TESTED = re.compile(r"^\| `(\w+)\(.*\| *(.+?) *\|$", re.MULTILINE)
Progress = Json  # keys: points, most, passed, tests, missing, next


def _home() -> Path:
    """Return the folder in which a student's progress is stored."""
    return Path(os.environ.get("TAM570_HOME") or os.path.expanduser("~/.tam570"))


def progress(
    slug: str, outcomes: Mapping[str, str], used: Mapping[str, set[str]], causes: Mapping[str, str | None] | None = None
) -> Progress:
    """Return the points by the visible tests, and the function to work on next.

    outcomes : of each test
    used     : the functions that each test calls
    causes   : of failed tests, the function that is certainly at fault

    A test judges the last function, in the README's order, that it calls. A function gets its points when all tests
    that judge it pass, or, if there are none, all that call it: so fixing a function never takes points from another.
    If another function is certainly at fault, a failure does not count against a function whose tests of it alone pass.
    `next` is a function that fails a test of it alone, else the cause of the first failure, else the only function that
    all failed tests call, else the first one without its points.
    """
    causes = causes or {}
    worth = {name: float(points) for name, points in ROW.findall(_readme(slug))}
    calling = {name: [test for test in used if name in used[test]] for name in worth}
    last = {test: max(used[test] & set(worth), key=list(worth).index, default="") for test in used}
    judging = {name: [test for test in calling[name] if last[test] == name] or calling[name] for name in worth}
    sound = {name for name in worth if {outcomes.get(test) for test in used if used[test] == {name}} == {PASSED}}
    counts = {
        name: [test for test in judging[name] if name not in sound or causes.get(test) in (None, name)]
        for name in worth
    }
    failed = {name: [test for test in counts[name] if outcomes.get(test) != PASSED] for name in worth if calling[name]}
    missing = [name for name in failed if failed[name]]
    alone = {test: name for name in missing for test in failed[name] if used[test] == {name}}
    certain = [name for test, name in alone.items() if causes.get(test) in (None, name)]
    calls = [used[test] & set(worth) for test in used if outcomes.get(test) != PASSED]
    common = set.intersection(*calls) if len(calls) > 1 else set()
    shared = common if len(common) == 1 else set()
    reasons = [causes.get(test) for test in failed[missing[0]]] if missing else []
    return {
        "points": sum(worth[name] for name in failed if name not in missing),
        "most": sum(worth[name] for name in failed),
        "passed": sum(outcome == PASSED for outcome in outcomes.values()),
        "tests": len(used),
        "missing": missing,
        "next": next(
            (name for name in [*certain, *reasons[:1], *shared, *missing] if name in {*missing, *shared}), None
        ),
    }


def said(state: Progress) -> str:
    """Return the progress as one line of text."""
    return (
        f"{state['passed']} of {state['tests']} tests pass; "
        f"{state['points']:g} of {state['most']:g} points by the visible tests"
    )


def remembered(file: Path) -> dict[str, tuple[str, str]]:
    """Return the stored outcomes of a file's tests: for each test its key and its outcome."""
    outcomes = _read(PROGRESS).get(_name(file), {}).get("outcomes", {})
    return {test: (key, outcome) for test, (key, outcome) in outcomes.items()}


def remember(file: Path, outcomes: Mapping[str, tuple[str, str]], state: Progress) -> None:
    """Store the outcomes of a file's tests and the progress."""
    _keep(PROGRESS, _name(file), {"digest": digest(file), "outcomes": dict(outcomes), "progress": state})


def recalled(file: Path) -> tuple[Progress, bool] | None:
    """Return the stored progress and whether the file is unchanged since; None if it was never checked."""
    stored = _read(PROGRESS).get(_name(file))
    return (stored["progress"], stored["digest"] == digest(file)) if stored else None


def hints_given(slug: str, function: str) -> int:
    """Return how many hints for a function the student has seen."""
    count = _read(HINTS).get(f"{slug} {function}", 0)
    return count if isinstance(count, int) else 0


def remember_hints(slug: str, function: str, count: int) -> bool:
    """Store how many hints for a function the student has seen; return whether that succeeded."""
    return _keep(HINTS, f"{slug} {function}", count)


def rows(slug: str) -> dict[str, str]:
    """Return, for each function, what the hidden tests look at, from the README."""
    return dict(TESTED.findall(_readme(slug)))


def _readme(slug: str) -> str:
    return (folder(slug) / "README.md").read_text(encoding="utf-8")


def _name(file: Path) -> str:
    return str(file.resolve())


def _read(name: str) -> Json:
    return record(_home() / name)


def _keep(name: str, key: str, value: object) -> bool:
    """Store a value under a key; return False if the file cannot be written."""
    data = _read(name) | {key: value}
    try:
        _home().mkdir(parents=True, exist_ok=True)
        draft = _home() / f"{name}.{os.getpid()}"
        draft.write_text(json.dumps(data))
        draft.replace(_home() / name)
    except OSError:
        return False
    return True
