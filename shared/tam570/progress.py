"""How far a student has come: by the visible tests and in the hints, remembered from one command to the next."""

import hashlib
import json
import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tam570.course import folder

__all__ = ["FAILED", "PASSED", "hints_given", "kept", "progress", "recalled", "remember", "remember_hints", "said"]

PASSED, FAILED = "passed", "failed"
PROGRESS, HINTS = "progress.json", "hints.json"  # the files in which it is kept
ROW = re.compile(r"^\| `(\w+)\(.*?\| *([\d.]+) *\|", re.MULTILINE)
Progress = dict[str, Any]  # points, most, passed, tests, next: plain data


def _home() -> Path:
    """Where things are remembered for a student."""
    return Path(os.environ.get("TAM570_HOME", Path.home() / ".tam570"))


def progress(slug: str, outcomes: Mapping[str, str], calls: Mapping[str, set[str]]) -> Progress:
    """Points by the visible tests, and the function to look at next.

    A function has its points when a test that calls it passes and none that fails is its fault; a test that fails
    is the fault of those of its functions that no test has passed with, if there are such.
    """
    worth = {name: float(points) for name, points in ROW.findall(_readme(slug))}
    used = {test: functions & set(worth) for test, functions in calls.items()}
    proven = {name for test in used if outcomes.get(test) == PASSED for name in used[test]}
    at_fault = {name for test in used if outcomes.get(test) != PASSED for name in used[test] - proven or used[test]}
    seen = [name for name in worth if any(name in functions for functions in used.values())]
    done = [name for name in seen if name in proven - at_fault]
    return {
        "points": sum(worth[name] for name in done),
        "most": sum(worth[name] for name in seen),
        "passed": sum(outcome == PASSED for outcome in outcomes.values()),
        "tests": len(calls),
        "next": next((name for name in seen if name not in done), None),
    }


def said(found: Progress) -> str:
    """The progress in a line."""
    ahead = f"next: {found['next']}" if found["next"] else "all done"
    return (
        f"{found['passed']} of {found['tests']} tests pass; "
        f"{found['points']:g} of {found['most']:g} points by the visible tests; {ahead}"
    )


def kept(file: Path) -> dict[str, tuple[str, str]]:
    """What was remembered of the tests of a file: for each its key and its outcome."""
    known = _read(PROGRESS).get(_name(file), {}).get("outcomes", {})
    return {test: (key, outcome) for test, (key, outcome) in known.items()}


def remember(file: Path, outcomes: Mapping[str, tuple[str, str]], found: Progress) -> None:
    """Keep the outcomes and the progress."""
    _keep(PROGRESS, _name(file), {"digest": _digest(file), "outcomes": dict(outcomes), "progress": found})


def recalled(file: Path) -> tuple[Progress, bool] | None:
    """The progress with a file, and whether the file is as it was then; None if it was never checked."""
    known = _read(PROGRESS).get(_name(file))
    return (known["progress"], known["digest"] == _digest(file)) if known else None


def hints_given(slug: str, function: str) -> int:
    """How many of the hints for a function were given."""
    count = _read(HINTS).get(f"{slug} {function}", 0)
    return count if isinstance(count, int) else 0


def remember_hints(slug: str, function: str, count: int) -> None:
    """Keep how many of the hints for a function were given."""
    _keep(HINTS, f"{slug} {function}", count)


def _readme(slug: str) -> str:
    return (folder(slug) / "README.md").read_text(encoding="utf-8")


def _name(file: Path) -> str:
    return str(file.resolve())


def _digest(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def _read(name: str) -> dict[str, Any]:
    """What is remembered under this name; nothing where it cannot be read."""
    try:
        known = json.loads((_home() / name).read_text())
    except (OSError, ValueError):
        return {}
    return known if isinstance(known, dict) else {}


def _keep(name: str, key: str, value: Any) -> None:
    """Remember this too; where nothing can be kept, go on without."""
    known = _read(name) | {key: value}
    try:
        _home().mkdir(parents=True, exist_ok=True)
        draft = _home() / f"{name}.{os.getpid()}"
        draft.write_text(json.dumps(known))
        draft.replace(_home() / name)
    except OSError:
        pass
