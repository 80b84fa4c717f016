"""Grades the grader: does it catch what it must? Mutants of every solution are run through it in the sandbox."""

import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from tam570_grader.book import Record
from tam570_grader.equivalents import Slip, entry, equivalents, idle
from tam570_grader.mutate import Mutant, mutants
from tam570_grader.run import Plan, graded_sources
from tam570_grader.sandbox import Allowance
from tam570_grader.student import Source
from tam570_grader.submissions import Submission

__all__ = ["run"]

ALLOWANCE = Allowance(cpu=10, call=1)  # solutions take hundredths of a second a call; a slip may never end
QUICK = 10  # mutants of an assignment in the quick form
FATES = KILLED, EQUIVALENT, SURVIVES = "killed", "equivalent", "survive"


def run(
    course: Path, slugs: Sequence[str], *, jobs: int, quick: bool = False, functions: Sequence[str] = ()
) -> int:
    """Print what became of the mutants; 1 if one survives that is not listed, or one is listed that does not."""
    faults = 0
    for slug in slugs:
        found = mutants(slug, (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8"))
        asked = [mutant for mutant in found if not functions or mutant.function in functions]
        chosen = asked[:: max(1, len(asked) // QUICK)] if quick else asked
        outcome = dict(_graded(course, chosen, jobs))
        listed = equivalents(course, slug)
        faults += _report(slug, chosen, outcome, listed)
        faults += _report_of_idle_lines(listed, found, outcome)
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
    slug: str, chosen: Sequence[Mutant], outcome: Mapping[str, Record], listed: Mapping[Slip, str]
) -> int:
    """Print the counts by function and check, and the survivors of an assignment; how many survive."""
    fates = {mutant.name: _fate(outcome[mutant.name], _slip(mutant) in listed) for mutant in chosen}
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
        _show(mutant)
    sys.stdout.flush()
    return counts[SURVIVES]


def _show(mutant: Mutant) -> None:
    """Print where a survivor is, its line as it was and is, and the line that would list it."""
    print(f"  SURVIVES solutions/{mutant.slug}.py:{mutant.line} in {mutant.function}: {mutant.operator}")
    for mark, line in zip("-+", (mutant.before, mutant.after), strict=True):
        print(f"      {mark} {line.strip()}")
    for line in entry(mutant).splitlines():
        print(f"    {line}")


def _report_of_idle_lines(
    listed: Mapping[Slip, str], made: Iterable[Mutant], outcome: Mapping[str, Record]
) -> int:
    """Print the lines that list in vain; how many they are."""
    names = {_slip(mutant): mutant.name for mutant in made}
    killed = {slip for slip, name in names.items() if name in outcome and not _survives(outcome[name])}
    faults = idle(listed, names, killed)
    for (function, slip), fault in faults.items():
        print(f"  LISTED IN VAIN {function}: {slip}: {fault}")
    return len(faults)


def _slip(mutant: Mutant) -> Slip:
    return mutant.function, mutant.slip


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
