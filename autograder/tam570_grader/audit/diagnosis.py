"""Ask whether the feedback names the mistake.

Each known mistake whose numbers are compared must be named by its own sentence. It is made in the solution, and once
more in a right submission of another style: there its name is not found by construction.
"""

import ast
from collections.abc import Container, Sequence
from dataclasses import dataclass, replace
from itertools import cycle
from pathlib import Path

from tam570_grader.audit.gradings import Grading, submissions, tried
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import Mistake, mistakes
from tam570_grader.diagnosis.mutants import reached
from tam570_grader.errors import UsageError, progress
from tam570_grader.grading.executor import TaskExecutor, in_order
from tam570_grader.release.stubs import exported
from tam570_grader.results.records import Result

ENOUGH = 0.9  # share of the mistakes that the feedback must name
SEED = 1
QUICK = 10  # mistakes in the quick form
TAKEN = """

from types import ModuleType as _ModuleType
_mistaken = _ModuleType("_mistaken")
exec({text!r}, vars(_mistaken))
globals().update({{_name: vars(_mistaken)[_name] for _name in {names}}})
"""
ON = " on "  # between a mistake and the style that it is made in


@dataclass(frozen=True)
class Diagnosis:
    """What the feedback says of a wrong submission, and what it must say."""

    name: str
    expected: str  # "" if no number is compared
    is_named: bool
    suspects: tuple[str, ...]
    messages: tuple[str, ...]
    misled: bool  # another known mistake was named


def diagnoses(course: Path, slug: str, executor: TaskExecutor, quick: bool, seeds: int = 1) -> list[Diagnosis]:
    """Return the diagnosis of each wrong submission of an assignment, or of a fixed sample, with each of the seeds."""
    solution = (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8")
    wrong = submissions(course, slug, "mistakes")
    if not wrong:
        file = assignments.checks_folder(course, slug) / "mistakes.py"
        raise UsageError(f"there is no wrong submission to name in {file}; write one")
    wrong = dict(list(wrong.items())[:: max(1, len(wrong) // QUICK)]) if quick else wrong
    styles = submissions(course, slug, "alternatives")
    tasks = [Grading(course, slug, name, f"{solution}\n\n{text}", SEED, naming=True) for name, text in wrong.items()]
    for (name, text), (style, other) in zip(wrong.items(), cycle(styles.items())):
        tasks.append(Grading(course, slug, f"{name}{ON}{style}", other + _taken(solution, text), SEED, naming=True))
    tasks = [replace(task, seed=SEED + seed) for seed in range(seeds) for task in tasks]
    results = progress(in_order(executor, tried, tasks), len(tasks), "submission")
    known_mistakes = {mistake.name: mistake for mistake in mistakes(assignments.checks_folder(course, slug))}
    messages = {mistake.message for mistake in known_mistakes.values()}
    diagnosed = (diagnosis(result, known_mistakes[result.student.partition(ON)[0]], messages) for result in results)
    # another style may not call what is wrong
    return [each for each in diagnosed if each.messages or ON not in each.name]


def _taken(solution: str, changed: str) -> str:
    """Code that takes the mistaken functions from the solution with the slip, whose helpers stay its own."""
    changed_names, public = reached(changed), sorted(exported(ast.parse(solution)))
    wrong = [name for name in public if name in changed_names]
    wrong = wrong or [name for name in public if reached(f"{solution}\n\n{changed}")[name] & changed_names.keys()]
    return TAKEN.format(text=f"{solution}\n\n{changed}", names=wrong)


def diagnosis(result: Result, mistake: Mistake, listed: Container[str]) -> Diagnosis:
    """Return what the feedback of a wrong submission says, beside what it must say.

    listed : what known mistakes say; what is found by trying says what the numbers are, and misleads nobody
    """
    failed = [check for check in result.checks if check.outcome == "failed"]
    suspects = tuple(check.suspect for check in failed if check.suspect)
    messages = tuple(check.message for check in failed)
    expected = mistake.message if mistake.compared else ""
    is_named = not mistake.compared or expected in suspects  # else its check says what it is
    misled = any(message in listed and message != expected for message in suspects)
    return Diagnosis(result.student, expected, is_named, suspects, messages, misled)


def faults(diagnosed: Sequence[Diagnosis]) -> int:
    """Wrong names, and one more if too few mistakes are named."""
    return sum(each.misled for each in diagnosed) + (share(diagnosed) < ENOUGH)


def share(diagnosed: Sequence[Diagnosis]) -> float:
    """Of the mistakes that are named."""
    return sum(each.is_named for each in diagnosed) / len(diagnosed)


def report(slug: str, diagnosed: Sequence[Diagnosis]) -> list[str]:
    """Return the lines to print: the share, what is said of a mistake that is not named, and where a wrong one is."""
    count_named = sum(each.is_named for each in diagnosed)
    lines = [f"{slug}: {count_named} of {len(diagnosed)} mistakes are named ({share(diagnosed):.0%})"]
    for each in diagnosed:
        if not each.is_named:
            lines.append(f"  {each.name}: {'; '.join(each.messages)}")
        if each.misled:
            lines.append(f"  MISLED {each.name}: {'; '.join(each.suspects)}")
    return lines
