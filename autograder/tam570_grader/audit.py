"""Grades the grader: does it catch what it must? Mutants of every solution are run through it in the sandbox."""

import sys
import tomllib
from collections.abc import Iterator, Sequence
from pathlib import Path

from tam570_grader.book import Record
from tam570_grader.mutate import Mutant, mutants
from tam570_grader.run import Plan, graded_sources
from tam570_grader.sandbox import Allowance
from tam570_grader.student import Source
from tam570_grader.submissions import Submission

__all__ = ["run"]

ALLOWANCE = Allowance(cpu=20, call=2)  # solutions take hundredths of a second a call; a slip may never end
QUICK = 10  # mutants of an assignment in the quick form


def run(course: Path, slugs: Sequence[str], *, jobs: int, quick: bool) -> int:
    """Print what became of the mutants; the exit code is 1 if one survives that is not known to be equivalent."""
    survivors = 0
    for slug in slugs:
        found = mutants(slug, (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8"))
        chosen = found[:: max(1, len(found) // QUICK)] if quick else found
        outcome = dict(_graded(course, chosen, jobs))
        survivors += _report(slug, chosen, outcome, _equivalents(course))
    return 1 if survivors else 0


def _graded(course: Path, chosen: Sequence[Mutant], jobs: int) -> Iterator[tuple[str, Record]]:
    from tqdm import tqdm

    plan = Plan(course, [], 570, jobs, ALLOWANCE, [course])
    work = [
        (Submission(mutant.name, mutant.slug, None, course), Source(mutant.text.encode()), mutant.name)
        for mutant in chosen
    ]
    results = graded_sources(plan, work)
    for result, name in tqdm(results, total=len(work), unit="mutant", leave=False, disable=None):
        yield name, result.record()


def _report(
    slug: str, chosen: Sequence[Mutant], outcome: dict[str, Record], equivalent: dict[str, str]
) -> int:
    """Print the counts and the survivors of an assignment; how many survive."""
    alive = [mutant for mutant in chosen if _survives(outcome[mutant.name])]
    unknown = [mutant for mutant in alive if mutant.name not in equivalent]
    known = len(alive) - len(unknown)
    counts = f"{len(chosen) - len(alive)} killed, {known} equivalent, {len(unknown)} survive"
    print(f"{slug}: {len(chosen)} mutants, {counts}")
    for mutant in unknown:
        print(f"  {mutant.name} line {mutant.line}: {mutant.was} -> {mutant.now}")
    for name in _unneeded(outcome):
        print(f"  no mutant needs {name}")
    sys.stdout.flush()
    return len(unknown)


def _survives(record: Record) -> bool:
    return bool(record["score"] == record["max_score"])


def _unneeded(outcome: dict[str, Record]) -> list[str]:
    """Checks without which every mutant would still lose points."""
    losses = [
        [mark["name"] for mark in record["checks"] if mark["outcome"] == "failed"]
        for record in outcome.values()
    ]
    alone = {names[0] for names in losses if len(names) == 1}
    some = next(iter(outcome.values()), None)
    return [mark["name"] for mark in some["checks"] if mark["name"] not in alone] if some else []


def _equivalents(course: Path) -> dict[str, str]:
    """Mutants that are no mistakes, and why, in one line each."""
    path = course / "autograder" / "equivalent_mutants.toml"
    return tomllib.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
