"""Find which hidden cases catch which wrong submission, and a small set of cases that still catches them all.

With every seed, these must be caught: every mutant that any case catches, every known mistake at its first check, and
the difference between a mistake and each mistake that the diagnosis tries before it.
"""

import ast
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from tam570_grader.audit import local
from tam570_grader.audit.local import SEED, Key, LocalStudent, Replies, failed_cases, module_of, solution_replies
from tam570_grader.audit.mutate import mutants
from tam570_grader.audit.mutation import Wrong, to_catch, within_reach
from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.check import Check
from tam570_grader.checks.returns import Array, Group
from tam570_grader.diagnosis.mistakes import answer, candidates, mistakes, same, tolerance_of
from tam570_grader.diagnosis.mutants import reached
from tam570_grader.errors import progress
from tam570_grader.grading.executor import TaskExecutor, in_order

SEEDS = 20
EXPENSIVE = 2e-3  # s; cases with longer calls are chosen only for subjects that no other case catches
CHUNKS = 4  # tasks into which the wrong submissions of a seed are divided
Subject = tuple[int, str]  # a seed, and the name of what must be caught with it


@dataclass(frozen=True)
class CaseRun:
    """A task: wrong submissions to run with one seed."""

    course: Path
    slug: str
    seed: int
    wrong: Sequence[Wrong]
    first: bool  # the first task of its seed, which also runs the solution


@dataclass(frozen=True)
class CaseReport:
    """The hidden cases of an assignment: seconds of each, the cases that catch each subject, and the needed ones."""

    slug: str
    seeds: int
    seconds: Mapping[Key, float]
    caught: Mapping[Subject, frozenset[Key]]
    needed: Sequence[Key]


def report_cases(course: Path, slug: str, executor: TaskExecutor, seeds: int) -> CaseReport:
    """Run mutants and mistakes with `seeds` seeds, and choose few cases that catch them all."""
    assignment = assignments.assignment(course, slug)
    students = local.students_of_checks(course, slug)
    calls = {check: {key.function for key in student.cases} for check, student in students.items()}
    slipped = to_catch(assignment.solution, mutants(slug, assignment.solution), calls)
    wrong = [*(replace(each, name=f"mutant {each.name}") for each in slipped), *_mistakes(assignment)]
    runs = [
        CaseRun(course, slug, SEED + seed, wrong[start::CHUNKS], start == 0)
        for seed in range(seeds)
        for start in range(CHUNKS)
    ]
    seconds, caught = dict[Key, float](), dict[Subject, frozenset[Key]]()
    for costs, keys in progress(in_order(executor, judged_cases, runs), len(runs), "chunk"):
        caught |= keys
        for key, spent in costs.items():
            seconds[key] = max(spent, seconds.get(key, 0.0))
    return CaseReport(slug, seeds, seconds, caught, fewest(caught, seconds))


def judged_cases(run: CaseRun) -> tuple[dict[Key, float], dict[Subject, frozenset[Key]]]:
    """Return the seconds of each case (in the first task of a seed), and the cases that catch each subject."""
    assignment = assignments.assignment(run.course, run.slug)
    solution = solution_replies(run.course, run.slug, run.seed)
    seconds, caught = dict[Key, float](), dict[str, frozenset[Key]]()
    for check in assignment.checks if run.first else ():
        student = LocalStudent(assignment, check, solution, solution)
        failed = failed_cases(student, check, run.seed, run.slug)
        assert not failed, failed
        seconds |= {key: solution.seconds.get((key.function, case.packed), 0.0) for key, case in student.cases.items()}
        caught.update(_told_apart(assignment, check, student))
    for wrong in run.wrong:
        replies = Replies(module_of(wrong.text), solution, wrong.reach)
        checks = [check for check in assignment.checks if check.name in wrong.checks]
        students = [(LocalStudent(assignment, check, solution, replies), check) for check in checks]
        failures = (failed_cases(student, check, run.seed, run.slug) for student, check in students)
        caught[wrong.name] = frozenset(key for keys in failures for key in keys)
    return seconds, {(run.seed, name): keys for name, keys in caught.items() if keys}


def _mistakes(assignment: LoadedAssignment) -> Iterator[Wrong]:
    """Yield each known mistake, with the check that it must fail first."""
    reachable = reached(assignment.solution)
    for mistake in mistakes(assignments.checks_folder(assignment.root, assignment.slug)):
        function = ast.parse(mistake.text).body[-1]
        assert isinstance(function, ast.FunctionDef)
        reach = within_reach(reachable, function.name)
        text = f"{assignment.solution}\n\n{mistake.text}"
        yield Wrong(f"mistake {mistake.name}", text, reach, frozenset({mistake.first_fails}))


def _told_apart(assignment: LoadedAssignment, check: Check, student: LocalStudent) -> Iterator[Any]:
    """Yield, for each mistake of a check and each tried before it, a name and the cases in which they differ."""
    folder, solution = assignments.checks_folder(assignment.root, assignment.slug), assignment.solution
    compared = {name for name, returns in assignment.returns.items() if isinstance(returns, Array | Group)}
    calls = [call for call in student.calls if call.name in compared]
    suspects = candidates(solution, folder, {call.name for call in calls})
    for index, mistake in enumerate(suspects):
        for other in suspects[:index] if mistake.first_fails == check.name else ():
            keys = [
                student.key(call.name, call.case)
                for call in calls
                if other.label in call.case.label
                and not same(
                    answer(solution, mistake.text, call),
                    answer(solution, other.text, call),
                    other.tolerance or tolerance_of(call),
                )
            ]
            yield f"mistake {mistake.name}, not {other.name}", frozenset(keys)


def fewest(caught: Mapping[Subject, frozenset[Key]], seconds: Mapping[Key, float]) -> list[Key]:
    """Return a small set of cases that catches every subject, chosen greedily, cheap ones first."""
    catches = defaultdict[Key, set[Subject]](set)
    for subject, keys in caught.items():
        for key in keys:
            catches[key].add(subject)
    needed, missing = list[Key](), set(caught)

    def worth(key: Key) -> tuple[int, float, int]:
        return len(catches[key] & missing), -seconds.get(key, 0.0), -key.nth

    cheap = [key for key in catches if seconds.get(key, 0.0) < EXPENSIVE]
    for some in (cheap, list(catches)):
        while some and catches[best := max(some, key=worth)] & missing:
            needed.append(best)
            missing -= catches[best]
    for key in sorted(needed, key=lambda key: (-seconds.get(key, 0.0), len(catches[key]))):
        others = set(needed) - {key}
        if all(caught[subject] & others for subject in catches[key]):
            needed.remove(key)
    return needed


def report(cases: CaseReport) -> list[str]:
    """Return the lines of a table in Markdown."""
    lines = [
        f"## {cases.slug}: {len(cases.seconds)} cases, {len(cases.needed)} needed by {cases.seeds} seeds",
        "",
        "| check | label | cases | needed | catches alone |",
        "|---|---|---|---|---|",
    ]
    count, needed = (Counter(key[:3] for key in keys) for keys in (cases.seconds, cases.needed))
    catches = defaultdict[tuple[str, str, str], list[str]](list)  # subjects that only this row catches
    for (_, subject), keys in cases.caught.items():
        if len(rows := {key[:3] for key in keys}) == 1:
            catches[rows.pop()].append(subject)
    check = ""
    for row in count:
        name, _, label = row
        numbers = Counter(subject.split()[0] for subject in {*catches[row]})
        summary = ", ".join(f"{number} {subject}{'s' * (number > 1)}" for subject, number in sorted(numbers.items()))
        lines.append(f"| {name if name != check else ''} | {label} | {count[row]} | {needed[row] or ''} | {summary} |")
        check = name
    return [*lines, ""]
