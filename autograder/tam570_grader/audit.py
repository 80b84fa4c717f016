"""Grades the grader: does it catch what it must? Mutants of every solution are run through it in the sandbox."""

import sys
import tomllib
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from tam570_grader.book import Record
from tam570_grader.mutate import Mutant, mutants
from tam570_grader.run import Plan, graded_sources
from tam570_grader.sandbox import Allowance
from tam570_grader.student import Source
from tam570_grader.submissions import Submission

__all__ = ["run"]

ALLOWANCE = Allowance(cpu=10, call=1)  # solutions take hundredths of a second a call; a slip may never end
QUICK = 10  # mutants of an assignment in the quick form
FATES = KILLED, EQUIVALENT, SURVIVES = "killed", "equivalent", "survive"


def run(course: Path, slugs: Sequence[str], *, jobs: int, quick: bool) -> int:
    """Print what became of the mutants; 1 if one survives that is not listed, or one is listed that does not."""
    faults = 0
    for slug in slugs:
        found = mutants(slug, (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8"))
        chosen = found[:: max(1, len(found) // QUICK)] if quick else found
        outcome = dict(_graded(course, chosen, jobs))
        listed = {name: why for name, why in _equivalents(course).items() if name.startswith(slug[:4])}
        faults += _report(slug, chosen, outcome, listed)
        if not quick:
            faults += _report_of_idle_lines(listed, chosen, outcome)
    return 1 if faults else 0


def _graded(course: Path, chosen: Sequence[Mutant], jobs: int) -> Iterator[tuple[str, Record]]:
    from tqdm import tqdm

    plan = Plan(
        course, [], 570, jobs, ALLOWANCE, [course], enough=2
    )  # one tells less: was it caught by that alone?
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
    """Print the counts by function and check, and the survivors of an assignment; how many survive."""
    fates = {mutant.name: _fate(outcome[mutant.name], mutant.name in equivalent) for mutant in chosen}
    counts = Counter(fates.values())
    print(f"{slug}: {len(chosen)} mutants, " + ", ".join(f"{counts[fate]} {fate}" for fate in FATES))
    for function in dict.fromkeys(mutant.function for mutant in chosen):
        of_it = Counter(fates[mutant.name] for mutant in chosen if mutant.function == function)
        print(f"  {function:<34}" + "".join(f"{of_it[fate]:>6} {fate}" for fate in FATES if of_it[fate]))
    for check, (first, alone) in _catches(outcome.values()).items():
        print(
            f"  {check:<48} first to catch {first}, alone {alone}" + ("" if alone else ": no mutant needs it")
        )
    for mutant in (mutant for mutant in chosen if fates[mutant.name] == SURVIVES):
        print(f"  SURVIVES {mutant.name} line {mutant.line}: {mutant.was} -> {mutant.now}")
    sys.stdout.flush()
    return counts[SURVIVES]


def _report_of_idle_lines(
    listed: dict[str, str], chosen: Sequence[Mutant], outcome: dict[str, Record]
) -> int:
    """Print the listed equivalents that are no longer made, or lose points; how many they are."""
    made = {mutant.name for mutant in chosen}
    idle = [name for name in listed if name not in made or not _survives(outcome[name])]
    for name in idle:
        print(
            f"  LISTED IN VAIN {name}: " + ("it loses points" if name in made else "there is no such mutant")
        )
    return len(idle)


def _fate(record: Record, listed: bool) -> str:
    return KILLED if not _survives(record) else EQUIVALENT if listed else SURVIVES


def _survives(record: Record) -> bool:
    return bool(record["score"] == record["max_score"])


def _catches(records: Iterable[Record]) -> dict[str, tuple[int, int]]:
    """For each check the number of mutants that it is the first to catch, and that it alone catches."""
    first: Counter[str] = Counter()
    alone: Counter[str] = Counter()
    names: list[str] = []
    for record in records:
        names = [mark["name"] for mark in record["checks"]]
        failed = [mark["name"] for mark in record["checks"] if mark["outcome"] == "failed"]
        first.update(failed[:1])
        alone.update(failed if len(failed) == 1 else [])
    return {name: (first[name], alone[name]) for name in names}


def _equivalents(course: Path) -> dict[str, str]:
    """Mutants that are no mistakes, and why, in one line each."""
    path = course / "autograder" / "equivalent_mutants.toml"
    return tomllib.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
