"""How far the limits of simulation checks lie from a careful student's errors, and from those of wrong physics."""

import functools
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tam570_grader import root
from tam570_grader.mutation import calls_of_checks, reached
from tam570_grader.trials import Trial, done, header, progress, submissions, tried

__all__ = ["ENOUGH", "Margin", "as_json", "faults", "margins", "report"]

ENOUGH = 10  # times: below the limit for a careful student, above it for wrong physics
SEEDS = 5
FIRST_SEED = 700
METHODS = "DOP853", "RK45", "LSODA"
IMPORT = "from tam570.integrate import solve"
CAREFUL = """

def solve(rhs, t, y0, *, parameters=None, rtol=None, method=None):
    from scipy.integrate import solve_ivp
    given = parameters or {{}}
    rates = lambda s, y: rhs(s, y, **given)
    return solve_ivp(rates, (t[0], t[-1]), y0, method="{method}", t_eval=t, rtol=1e-9, atol=1e-9).y.T
"""


@dataclass(frozen=True)
class Margin:
    """Of a check, in multiples of its limits: the largest careful error, and the smallest of wrong physics."""

    check: str
    careful: float
    careless: tuple[str, float] | None  # which wrong submission; None if none fails it by a number

    @property
    def small(self) -> bool:
        return self.careful * ENOUGH > 1 or (self.careless is not None and self.careless[1] < ENOUGH)


@contextmanager
def _recorded(trial: Trial) -> Iterator[dict[str, float]]:
    """The largest error over its limit that each check compares, while a trial runs."""
    found: dict[str, float] = {}
    checks = root.assignment(trial.course, trial.slug).checks
    spaces = {id(check.judge.__globals__): check.judge.__globals__ for check in checks}
    space = next(iter(spaces.values()))
    expect = space["expect"]

    @functools.wraps(expect)
    def recording(actual: Any, expected: Any, *, within: float, scale: Any = 1.0, **words: Any) -> None:
        errors = np.abs(np.asarray(actual, float) - np.asarray(expected, float)) / scale
        worst = float(np.max(errors)) if errors.size else np.nan
        found["now"] = max(found.get("now", 0.0), np.inf if np.isnan(worst) else worst / within)
        expect(actual, expected, within=within, scale=scale, **words)

    space["expect"] = recording
    try:
        yield found
    finally:
        space["expect"] = expect


def _errors(trial: Trial) -> dict[str, float]:
    """The largest error over its limit of each check of a trial, run one by one; of those that fail otherwise, none."""
    assert trial.checks is not None
    errors = {}
    for check in sorted(trial.checks):
        alone = Trial(trial.course, trial.slug, trial.name, trial.text, trial.seed, checks=frozenset({check}))
        with _recorded(trial) as found:
            failed = [mark for mark in tried(alone).checks if mark.name == check and mark.outcome != "passed"]
        if found and (not failed or found["now"] > 1):
            errors[check] = found["now"]
    return errors


def margins(course: Path, slug: str, seeds: int, jobs: int) -> list[Margin]:
    """The margins of the checks that call what integrates."""
    text = (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8")
    if IMPORT not in text:
        return []
    plain = text.replace(IMPORT, "pass")
    reach = reached(plain + CAREFUL.format(method=METHODS[0]))
    within = {name for name, reachable in reach.items() if "solve" in reachable}
    calls, _ = calls_of_checks(course, slug, text)
    simulating = frozenset(name for name, asked in calls.items() if asked & within)
    careful = [
        Trial(course, slug, method, plain + CAREFUL.format(method=method), seed, checks=simulating)
        for method in METHODS
        for seed in range(FIRST_SEED, FIRST_SEED + seeds)
    ]
    wrong = [
        Trial(course, slug, name, f"{text}\n\n{slip}", FIRST_SEED, checks=named)
        for name, slip in submissions(course, "wrong", slug).items()
        if (named := simulating & set(header(slip).get("fails", "").split(", ")))
    ]
    tasks = [*careful, *wrong]
    found = list(progress(done(_errors, tasks, jobs), len(tasks), "grading"))
    told = [(trial.name, errors) for trial, errors in zip(wrong, found[len(careful) :], strict=True)]
    return [_margin(check, found[: len(careful)], told) for check in calls if check in simulating]


def _margin(
    check: str, careful: Sequence[dict[str, float]], wrong: Sequence[tuple[str, dict[str, float]]]
) -> Margin:
    errors = [(name, errors[check]) for name, errors in wrong if check in errors]
    largest = max((errors.get(check, 0.0) for errors in careful), default=0.0)
    return Margin(check, largest, min(errors, key=lambda one: one[1], default=None))


def faults(found: Sequence[Margin]) -> int:
    """Margins that are too small."""
    return sum(one.small for one in found)


def as_json(slug: str, found: Sequence[Margin]) -> dict[str, Any]:
    """The report as plain data."""
    return {"assignment": slug, "checks": {one.check: [one.careful, one.careless] for one in found}}


def report(slug: str, found: Sequence[Margin]) -> list[str]:
    """The lines to print."""
    lines = [f"{slug}: {len(found)} checks of simulations, {faults(found)} margins below {ENOUGH}"]
    for one in found:
        room = f"careful {1 / one.careful:.1e} below" if one.careful else "careful exact"
        wrong = (
            f"wrong {one.careless[1]:.1e} above ({one.careless[0]})" if one.careless else "no wrong number"
        )
        lines.append(f"  {one.check:<48}{room}, {wrong}" + ("  TOO SMALL" if one.small else ""))
    return lines
