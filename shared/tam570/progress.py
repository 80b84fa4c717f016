"""How far a student has come by the visible tests, remembered from one check to the next."""

import hashlib
import json
import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tam570.course import folder

__all__ = ["home", "kept", "progress", "recalled", "remember", "said"]

PASSED, FAILED = "passed", "failed"
ROW = re.compile(r"^\| `(\w+)\(.*?\| *([\d.]+) *\|", re.MULTILINE)
Progress = dict[str, Any]  # points, most, passed, tests, next: plain data


def home() -> Path:
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
    at_fault = {
        name for test in used if outcomes.get(test) != PASSED for name in used[test] - proven or used[test]
    }
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
    known = _all().get(_name(file), {}).get("outcomes", {})
    return {test: (key, outcome) for test, (key, outcome) in known.items()}


def remember(file: Path, outcomes: Mapping[str, tuple[str, str]], found: Progress) -> None:
    """Keep the outcomes and the progress; where nothing can be kept, go on without."""
    known = _all()
    known[_name(file)] = {"digest": _digest(file), "outcomes": dict(outcomes), "progress": found}
    try:
        home().mkdir(parents=True, exist_ok=True)
        draft = home() / f"progress.json.{os.getpid()}"
        draft.write_text(json.dumps(known))
        draft.replace(home() / "progress.json")
    except OSError:
        pass


def recalled(file: Path) -> tuple[Progress, bool] | None:
    """The progress with a file, and whether the file is as it was then; None if it was never checked."""
    known = _all().get(_name(file))
    return (known["progress"], known["digest"] == _digest(file)) if known else None


def _readme(slug: str) -> str:
    return (folder(slug) / "README.md").read_text(encoding="utf-8")


def _name(file: Path) -> str:
    return str(file.resolve())


def _digest(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def _all() -> dict[str, Any]:
    try:
        known = json.loads((home() / "progress.json").read_text())
    except (OSError, ValueError):
        return {}
    return known if isinstance(known, dict) else {}
