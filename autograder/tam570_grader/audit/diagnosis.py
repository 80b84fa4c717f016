"""Test whether the feedback names the mistakes of wrong submissions.

The feedback must name each known mistake that it compares by its own sentence. Each is made in the solution, and again
in a right submission in another style, where the diagnosis does not succeed by construction.
"""

import ast
from collections.abc import Container, Sequence
from dataclasses import dataclass, replace
from itertools import cycle
from pathlib import Path

from tam570_grader.audit.gradings import Grading, tried
from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mistakes import Mistake, mistakes, overlays
from tam570_grader.diagnosis.mutants import reached
from tam570_grader.errors import UsageError, progress
from tam570_grader.grading.executor import TaskExecutor, in_order
from tam570_grader.release.stubs import exported
from tam570_grader.results.records import Result

ENOUGH = 0.9  # share of the mistakes that the feedback must name
SEED = 1
QUICK = 10  # about this many mistakes with --quick
TAKEN = """

from types import ModuleType as _ModuleType
_mistaken = _ModuleType("_mistaken")
exec({text!r}, vars(_mistaken))
globals().update({{_name: vars(_mistaken)[_name] for _name in {names}}})
"""
ON = " on "  # between the names of a mistake and of the style in which it is made


@dataclass(frozen=True)
class Diagnosis:
    """The feedback on a wrong submission, and the sentence that it must contain."""

    name: str
    expected: str  # "" if the mistake is not compared with numbers
    is_named: bool
    suspects: tuple[str, ...]
    messages: tuple[str, ...]
    misled: bool  # another known mistake was named


def diagnoses(course: Path, slug: str, executor: TaskExecutor, quick: bool, seeds: int = 1) -> list[Diagnosis]:
    """Return the diagnosis of each wrong submission, or with `quick` of a fixed sample, with each of the seeds."""
    solution = (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8")
    folder = assignments.checks_folder(course, slug)
    wrong = overlays(folder)
    if not wrong:
        raise UsageError(f"there is no wrong submission to name in {folder / 'mistakes.py'}; write one")
    wrong = dict(list(wrong.items())[:: max(1, len(wrong) // QUICK)]) if quick else wrong
    styles = assignments.alternatives(course, slug)
    tasks = [Grading(course, slug, name, f"{solution}\n\n{text}", SEED, naming=True) for name, text in wrong.items()]
    for (name, text), (style, other) in zip(wrong.items(), cycle(styles.items())):
        tasks.append(Grading(course, slug, f"{name}{ON}{style}", other + _taken(solution, text), SEED, naming=True))
    tasks = [replace(task, seed=SEED + seed) for seed in range(seeds) for task in tasks]
    results = progress(in_order(executor, tried, tasks), len(tasks), "submission")
    known_mistakes = {mistake.name: mistake for mistake in mistakes(folder)}
    messages = {mistake.message for mistake in known_mistakes.values()}
    diagnosed = (diagnosis(result, known_mistakes[result.student.partition(ON)[0]], messages) for result in results)
    # a submission in another style may not call the wrong function, and then passes
    return [each for each in diagnosed if each.messages or ON not in each.name]


def _taken(solution: str, changed: str) -> str:
    """Return code that replaces functions by those of the solution with the mistake, which keep their helpers."""
    changed_names, public = reached(changed), sorted(exported(ast.parse(solution)))
    wrong = [name for name in public if name in changed_names]
    wrong = wrong or [name for name in public if reached(f"{solution}\n\n{changed}")[name] & changed_names.keys()]
    return TAKEN.format(text=f"{solution}\n\n{changed}", names=wrong)


def diagnosis(result: Result, mistake: Mistake, listed: Container[str]) -> Diagnosis:
    """Return the feedback on a wrong submission, and whether it names the mistake or another known one.

    listed : sentences of known mistakes; other sentences describe the numbers, and do not mislead
    """
    failed = [check for check in result.checks if check.outcome == "failed"]
    suspects = tuple(check.suspect for check in failed if check.suspect)
    messages = tuple(check.message for check in failed)
    expected = mistake.message if mistake.compared else ""
    is_named = not mistake.compared or expected in suspects  # else the check itself explains it
    misled = any(message in listed and message != expected for message in suspects)
    return Diagnosis(result.student, expected, is_named, suspects, messages, misled)


def faults(diagnosed: Sequence[Diagnosis]) -> int:
    """Return the number of wrong names, plus one if too few mistakes are named."""
    return sum(each.misled for each in diagnosed) + (share(diagnosed) < ENOUGH)


def share(diagnosed: Sequence[Diagnosis]) -> float:
    """Return the share of mistakes that are named."""
    return sum(each.is_named for each in diagnosed) / len(diagnosed)


def report(slug: str, diagnosed: Sequence[Diagnosis]) -> list[str]:
    """Return the lines to print: the share, and the feedback on mistakes that are not named, or named wrongly."""
    count_named = sum(each.is_named for each in diagnosed)
    lines = [f"{slug}: {count_named} of {len(diagnosed)} mistakes are named ({share(diagnosed):.0%})"]
    for each in diagnosed:
        if not each.is_named:
            lines.append(f"  {each.name}: {'; '.join(each.messages)}")
        if each.misled:
            lines.append(f"  MISLED {each.name}: {'; '.join(each.suspects)}")
    return lines
