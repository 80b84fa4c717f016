"""How far the limits of simulation checks lie from a careful student's errors, and from those of wrong physics.

A known mistake of numerics has right physics, integrated inaccurately: its error can be as near to a limit as one
likes. It is told apart.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from tam570_grader.audit.gradings import Grading, progress, tried
from tam570_grader.audit.mutation import calls_of_checks
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import Mistake, mistakes
from tam570_grader.diagnosis.mutants import reached
from tam570_grader.grading.executor import TaskExecutor, in_order

__all__ = ["ENOUGH", "SEEDS", "Margin", "as_json", "faults", "margin", "margins", "report"]

ENOUGH = 10  # times: below the limit for a careful student, above it for wrong physics
SEEDS = 5
FIRST_SEED = 700
METHODS = "DOP853", "RK45", "LSODA"
CAREFUL = """

def solve(rhs, t, y0, *, parameters=None, **_):
    from scipy.integrate import solve_ivp
    given = parameters or {{}}
    rates = lambda s, y: rhs(s, y, **given)
    return solve_ivp(rates, (t[0], t[-1]), y0, method="{method}", t_eval=t, rtol=1e-9, atol=1e-9).y.T
"""


@dataclass(frozen=True)
class Margin:
    """Of a check, in multiples of its limits: the largest careful error, and the smallest of wrong submissions.

    physics  : the smallest error of wrong physics, and which; None if none fails the check by a number
    numerics : the same of inaccurate numerics; printed, and not judged
    """

    check: str
    careful: float
    physics: tuple[str, float] | None
    numerics: tuple[str, float] | None = None

    @property
    def small(self) -> bool:
        return self.careful * ENOUGH > 1 or (self.physics is not None and self.physics[1] < ENOUGH)


def _errors(grading: Grading) -> dict[str, float]:
    """Return the largest error over its limit of each check of a grading, run one by one.

    Infinite if it fails otherwise.
    """
    assert grading.checks is not None
    found = {check: _largest(replace(grading, checks=frozenset({check}))) for check in sorted(grading.checks)}
    return {check: error for check, error in found.items() if error is not None}


def _largest(grading: Grading) -> float | None:
    """Return the largest error over its limit of a grading of one check; None if it passes without a comparison."""
    found: list[float] = []
    result = tried(grading, lambda _, error: found.append(error))
    largest = max(found, default=0.0)
    passed = all(check_result.outcome == "passed" for check_result in result.checks)
    if not found and passed:
        return None
    return largest if passed or largest > 1 else np.inf


def margins(course: Path, slug: str, seeds: int, executor: TaskExecutor) -> list[Margin]:
    """Return the margins of the checks that compare what an integration gave."""
    text = (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8")
    checks = _simulating(course, slug, text)
    if not checks:
        return []
    wrong = {known.name: known for known in mistakes(assignments.checks_folder(course, slug))}
    sources = [(method, _careful(text, method), checks) for method in METHODS]
    sources += [
        (name, f"{text}\n\n{known.text}", checks & _not_passed(course, slug, known)) for name, known in wrong.items()
    ]
    tasks = [
        Grading(course, slug, name, source, seed, checks=asked)
        for name, source, asked in sources
        if asked
        for seed in range(FIRST_SEED, FIRST_SEED + seeds)
    ]
    errors = progress(in_order(executor, _errors, tasks), len(tasks), "grading")
    found = [(grading.name, one) for grading, one in zip(tasks, errors, strict=True)]
    order = [check.name for check in assignments.assignment(course, slug).checks]
    return [one for check in order if (one := margin(check, found, wrong))]


def _not_passed(course: Path, slug: str, known: Mistake) -> frozenset[str]:
    """Return the checks that a wrong submission may not pass: from the first that fails on."""
    order = [check.name for check in assignments.assignment(course, slug).checks]
    return frozenset(order[order.index(known.first_fails) :])


def _careful(text: str, method: str) -> str:
    """Return the solution, whose `solve` is another from here on: that of a careful student."""
    return text + CAREFUL.format(method=method)


def _simulating(course: Path, slug: str, text: str) -> frozenset[str]:
    """Return the checks that call what integrates."""
    reach = reached(_careful(text, METHODS[0]))
    within = {name for name, reachable in reach.items() if "solve" in reachable}
    calls, _ = calls_of_checks(course, slug, text)
    return frozenset(name for name, asked in calls.items() if asked & within)


def margin(check: str, found: Sequence[tuple[str, Mapping[str, float]]], slips: Mapping[str, Mistake]) -> Margin | None:
    """Return the margin of a check; None if nothing that a careful student integrates is compared in it.

    A check that comes after a failed one need not tell that mistake, too: what passes it there is left out, and what
    does not pass counts only where no wrong physics fails this check in its own right.
    """
    errors = [(name, one[check]) for name, one in found if check in one]
    careful = [error for name, error in errors if name in METHODS]
    if not careful:
        return None
    wrong = [(name, error) for name, error in errors if name in slips and error < np.inf]
    told = [(name, error) for name, error in wrong if error > 1 or check == slips[name].first_fails]
    inaccurate = [one for one in told if slips[one[0]].numerics]
    physics = [one for one in told if one not in inaccurate]
    own = [one for one in physics if check == slips[one[0]].first_fails]
    return Margin(check, max(careful), _smallest(own or physics), _smallest(inaccurate))


def _smallest(errors: Sequence[tuple[str, float]]) -> tuple[str, float] | None:
    return min(errors, key=lambda one: one[1], default=None)


def faults(found: Sequence[Margin]) -> int:
    """Margins that are too small."""
    return sum(one.small for one in found)


def as_json(slug: str, found: Sequence[Margin]) -> dict[str, Any]:
    """Return the report as plain data."""
    checks = {one.check: [one.careful, one.physics, one.numerics] for one in found}
    return {"assignment": slug, "checks": checks}


def report(slug: str, found: Sequence[Margin]) -> list[str]:
    """Return the lines to print."""
    lines = [f"{slug}: {len(found)} checks of simulations, {faults(found)} margins below {ENOUGH}"]
    for one in found:
        room = f"careful {1 / one.careful:.1e} below" if one.careful else "careful exact"
        wrong = _told("physics", one.physics) if one.physics else "no wrong number"
        wrong += f", {_told('numerics', one.numerics)}" if one.numerics else ""
        lines.append(f"  {one.check:<48}{room}, {wrong}" + ("  TOO SMALL" if one.small else ""))
    return lines


def _told(kind: str, wrong: tuple[str, float]) -> str:
    return f"wrong {kind} {wrong[1]:.1e} above ({wrong[0]})"
