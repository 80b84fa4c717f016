"""Compare the limits of simulation checks with the errors of a careful student, and with those of wrong physics.

Known mistakes of numerics are reported separately: they integrate the right physics inaccurately, so that their errors
can be arbitrarily close to a limit.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tam570_grader.audit.gradings import Grading, tried
from tam570_grader.audit.local import calls_of_checks
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import Mistake, mistakes
from tam570_grader.diagnosis.mutants import reached
from tam570_grader.errors import progress
from tam570_grader.grading.executor import TaskExecutor, in_order

ENOUGH = 10  # factor by which careful errors must be below the limit, and wrong physics above it
SEEDS = 5
FIRST_SEED = 700
IMPORTED = "    from tam570.integrate import solve\n"  # an import in a function
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
    """Errors of a check in multiples of its limits; `careful` is the largest of a careful student.

    physics  : wrong physics with the smallest error, and that error; None if none fails the check by a number
    numerics : the same for inaccurate numerics, for information only
    """

    check: str
    careful: float
    physics: tuple[str, float] | None
    numerics: tuple[str, float] | None = None

    @property
    def small(self) -> bool:
        return self.careful * ENOUGH > 1 or (self.physics is not None and self.physics[1] < ENOUGH)


def _errors(grading: Grading) -> dict[str, float]:
    """Return the largest error / limit of each check of a grading, run alone; infinite if it fails otherwise."""
    assert grading.checks is not None
    by_check, shares = dict[str, float](), list[float]()
    for check in sorted(grading.checks):
        shares.clear()
        result = tried(replace(grading, checks=frozenset({check})), lambda _, error: shares.append(error))
        largest = max(shares, default=0.0)
        passed = all(check_result.outcome == "passed" for check_result in result.checks)
        if shares or not passed:  # a check that passes without a comparison has none
            by_check[check] = largest if passed or largest > 1 else np.inf
    return by_check


def margins(course: Path, slug: str, seeds: int, executor: TaskExecutor) -> list[Margin]:
    """Return the margins of the checks that call functions which integrate."""
    text = (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8")
    reach, (calls, _) = reached(_careful(text, METHODS[0])), calls_of_checks(course, slug)
    integrating = {name for name, reachable in reach.items() if "solve" in reachable}
    checks = frozenset(name for name, called_functions in calls.items() if called_functions & integrating)
    if not checks:
        return []
    wrong = {mistake.name: mistake for mistake in mistakes(assignments.checks_folder(course, slug))}
    sources = [(method, _careful(text, method), checks) for method in METHODS]
    order = [check.name for check in assignments.assignment(course, slug).checks]
    for name, mistake in wrong.items():
        not_passed = order[order.index(mistake.first_fails) :]  # earlier checks pass
        sources.append((name, f"{text}\n\n{mistake.text}", checks.intersection(not_passed)))
    tasks = [
        Grading(course, slug, name, source, seed, checks=checks_asked)
        for name, source, checks_asked in sources
        if checks_asked
        for seed in range(FIRST_SEED, FIRST_SEED + seeds)
    ]
    errors = progress(in_order(executor, _errors, tasks), len(tasks), "grading")
    named_errors = [(grading.name, by_check) for grading, by_check in zip(tasks, errors, strict=True)]
    return [by_check for check in order if (by_check := margin(check, named_errors, wrong))]


def _careful(text: str, method: str) -> str:
    """Return the solution with `solve` replaced by SciPy's `solve_ivp` at the tolerances of a careful student."""
    return text.replace(IMPORTED, "") + CAREFUL.format(method=method)


def margin(
    check: str, named_errors: Sequence[tuple[str, Mapping[str, float]]], slips: Mapping[str, Mistake]
) -> Margin | None:
    """Return the margin of a check; None if it compares nothing that a careful student integrates.

    A check after the first one that a mistake fails need not catch that mistake again: the mistake is ignored if it
    passes, and counts, if it fails, only when no wrong physics fails this check first.
    """
    errors = [(name, pair[check]) for name, pair in named_errors if check in pair]
    careful = [error for name, error in errors if name in METHODS]
    if not careful:
        return None
    wrong = [(name, error) for name, error in errors if name in slips and error < np.inf]
    caught = [(name, error) for name, error in wrong if error > 1 or check == slips[name].first_fails]
    inaccurate = [pair for pair in caught if slips[pair[0]].numerics]
    physics = [pair for pair in caught if pair not in inaccurate]
    first = [pair for pair in physics if check == slips[pair[0]].first_fails]
    return Margin(check, max(careful), _smallest(first or physics), _smallest(inaccurate))


def _smallest(errors: Sequence[tuple[str, float]]) -> tuple[str, float] | None:
    return min(errors, key=lambda pair: pair[1], default=None)


def faults(all_margins: Sequence[Margin]) -> int:
    """Return the number of margins that are too small."""
    return sum(margin_of.small for margin_of in all_margins)


def report(slug: str, all_margins: Sequence[Margin]) -> list[str]:
    """Return the lines to print: a summary, and the margins of each check."""
    lines = [f"{slug}: {len(all_margins)} checks of simulations, {faults(all_margins)} margins below {ENOUGH}"]
    for each in all_margins:
        text = f"careful {1 / each.careful:.1e} below" if each.careful else "careful exact"
        wrong = _told("physics", each.physics) if each.physics else "no wrong number"
        wrong += f", {_told('numerics', each.numerics)}" if each.numerics else ""
        lines.append(f"  {each.check:<48}{text}, {wrong}" + ("  TOO SMALL" if each.small else ""))
    return lines


def _told(text: str, wrong: tuple[str, float]) -> str:
    return f"wrong {text} {wrong[1]:.1e} above ({wrong[0]})"
