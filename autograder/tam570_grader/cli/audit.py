"""The command `tam570-grader audit`, which tests the grader."""

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path

from tam570_grader.audit import cases, diagnosis, fairness, margins, mutation
from tam570_grader.checks import assignments
from tam570_grader.cli.grade import executor_of, warn_of_isolation
from tam570_grader.cli.options import add_cluster, positive
from tam570_grader.course import course_config
from tam570_grader.diagnosis.mutants import reached
from tam570_grader.errors import UsageError, say
from tam570_grader.grading.executor import TaskExecutor, cores

QUICK_SEEDS = 2
Answer = tuple[list[str], int]  # lines to print, faults
Question = Callable[[Path, str, TaskExecutor, argparse.Namespace], Answer]


def add_audit(parser: argparse.ArgumentParser) -> None:
    """Add the options of `audit`."""
    parser.set_defaults(command=_audit)
    parser.description = "Run mutants of the reference solutions, one slip each, through the grader."
    parser.epilog = (
        "The exit code is 0 if all is well, and 2 on bad usage. It is 1 if a mutant survives that is not listed "
        "as equivalent, or one is listed in vain. It is also 1 if a right submission loses points, a mistake gets a "
        "wrong name, too few get one, or a margin is too small."
    )
    add, asks = parser.add_argument, parser.add_mutually_exclusive_group().add_argument
    add("assignments", nargs="*", metavar="SLUG", help="default: all")
    add("--quick", action="store_true", help="a small fixed sample")
    fairness = "do right submissions ever lose points? with N seeds (default: %(const)s)"
    asks("--fairness", nargs="?", type=positive, const=100, metavar="N", help=fairness)
    asks("--diagnosis", action="store_true", default=None, help="does feedback name the mistakes of wrong ones?")
    asks("--cases", action="store_true", default=None, help="which hidden cases catch what, and how few are needed?")
    margins = "how far do limits lie from a careful student's errors, and from wrong physics?"
    asks("--margins", action="store_true", default=None, help=margins)
    add("--keep", type=Path, metavar="FILE", help="add the lines of --fairness there, and skip those that it has")
    seeds = "seeds of mutants and --diagnosis (default: 1) or --cases (default: 20)"
    add("--seeds", type=positive, metavar="N", help=seeds)
    add("--function", nargs="+", metavar="NAME", default=[], help="mutants of these functions only")
    add("--jobs", type=positive, metavar="N", default=cores(), help="processes (default: %(default)s)")
    add_cluster(add)


def _audit(arguments: argparse.Namespace) -> int:
    """Print the answers for each assignment; return 1 if there is a fault."""
    course = course_config.course_of(arguments.root)
    questions = [name for name in QUESTIONS if getattr(arguments, name) is not None]
    if arguments.keep and questions != ["fairness"]:
        raise UsageError("--keep: it goes with --fairness alone")
    if arguments.seeds and questions and questions[0] in ("fairness", "margins"):
        raise UsageError(f"--seeds: it does not go with --{questions[0]}")
    if arguments.function and questions:
        raise UsageError(f"--function: it chooses mutants; it does not go with --{questions[0]}")
    question = QUESTIONS[questions[0]] if questions else _mutation
    if not arguments.cluster:
        warn_of_isolation()
    faults = 0
    slugs = assignments.match_slugs(arguments.assignments, assignments.slugs(course))
    slugs = _with_functions(course, slugs, arguments.function) if arguments.function else slugs
    with executor_of(arguments, course, slugs) as executor:
        for slug in slugs:
            lines, survived = question(course, slug, executor, arguments)
            say("\n".join(lines))
            faults += survived
    return 1 if faults else 0


def _with_functions(course: Path, slugs: Sequence[str], names: Sequence[str]) -> list[str]:
    """Return the assignments with functions of these names; raise UsageError for a name that none of them has."""
    texts = {slug: (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8") for slug in slugs}
    there = {slug: set(reached(text)) for slug, text in texts.items()}
    functions = sorted(set().union(*there.values()))
    if unknown := [name for name in names if name not in functions]:
        raise UsageError(f"--function: there is no function {unknown[0]!r}; there are: {', '.join(functions)}")
    return [slug for slug in slugs if there[slug] & set(names)]


def _mutation(course: Path, slug: str, executor: TaskExecutor, arguments: argparse.Namespace) -> Answer:
    fates = mutation.fates(course, slug, executor, arguments.quick, arguments.function, arguments.seeds or 1)
    return mutation.report(fates), fates.faults


def _fairness(course: Path, slug: str, executor: TaskExecutor, arguments: argparse.Namespace) -> Answer:
    seeds = QUICK_SEEDS if arguments.quick else arguments.fairness
    lines = fairness.fair(course, slug, seeds, executor, arguments.keep)
    return fairness.report(lines), sum(bool(line["fails"]) for line in lines)


def _diagnosis(course: Path, slug: str, executor: TaskExecutor, arguments: argparse.Namespace) -> Answer:
    diagnoses = diagnosis.diagnoses(course, slug, executor, arguments.quick, arguments.seeds or 1)
    return diagnosis.report(slug, diagnoses), diagnosis.faults(diagnoses)


def _margins(course: Path, slug: str, executor: TaskExecutor, arguments: argparse.Namespace) -> Answer:
    by_check = margins.margins(course, slug, QUICK_SEEDS if arguments.quick else margins.SEEDS, executor)
    return margins.report(slug, by_check), margins.faults(by_check)


def _cases(course: Path, slug: str, executor: TaskExecutor, arguments: argparse.Namespace) -> Answer:
    seeds = arguments.seeds or (QUICK_SEEDS if arguments.quick else cases.SEEDS)
    return cases.report(cases.report_cases(course, slug, executor, seeds)), 0


QUESTIONS: dict[str, Question] = {"fairness": _fairness, "diagnosis": _diagnosis, "cases": _cases, "margins": _margins}
