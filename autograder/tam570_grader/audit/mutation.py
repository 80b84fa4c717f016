"""Grade mutants of the solutions: each is killed, is equivalent, or survives because of a gap in the checks."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from tam570_grader.audit.gradings import Grading, seeds_that_fail, tried
from tam570_grader.audit.local import SEED, calls_of_checks
from tam570_grader.audit.mutate import Slip, SolutionMutant, entry, equivalents, idle, mutants
from tam570_grader.diagnosis.mutants import reached
from tam570_grader.errors import counted, progress
from tam570_grader.grading.executor import TaskExecutor, in_order
from tam570_grader.results.records import Result
from tam570_grader.sandbox.zygote import ResourceLimits

QUICK = 10  # about this many mutants of an assignment with --quick
SLOWER = 10  # time limit of a mutant's call, in multiples of the solution's longest call
SHORTEST = 0.25  # s, least time limit, as times on a busy machine are uncertain
CALLS = 12  # CPU time of a mutant in multiples of that limit
KILLED, EQUIVALENT, SURVIVES, CRASHED = FATES = "killed", "equivalent", "survive", "crash"


@dataclass(frozen=True)
class Wrong:
    """A wrong submission: its text, the functions that its slip may affect, and the checks that may catch it."""

    name: str
    text: str
    reach: frozenset[str]
    checks: frozenset[str]


@dataclass(frozen=True)
class Fates:
    """The graded mutants of an assignment; mappings are by name of the mutant, except `in_vain`."""

    slug: str
    chosen: Sequence[SolutionMutant]
    fate: Mapping[str, str]
    failed: Mapping[str, Sequence[str]]  # checks that failed
    checks: Sequence[str]
    in_vain: Mapping[Slip, str]  # listed slips that must not be listed, with the reason
    missed: Mapping[str, Sequence[int]]  # seeds with which the mutant has full points

    @property
    def survivors(self) -> list[SolutionMutant]:
        return [mutant for mutant in self.chosen if self.fate[mutant.name] == SURVIVES]

    @property
    def crashing(self) -> list[SolutionMutant]:
        """Mutants on which the grader failed, so that they have no score."""
        return [mutant for mutant in self.chosen if self.fate[mutant.name] == CRASHED]

    @property
    def faults(self) -> int:
        return len(self.survivors) + len(self.crashing) + len(self.in_vain)


def fates(
    course: Path, slug: str, executor: TaskExecutor, quick: bool, functions: Sequence[str], seeds: int = 1
) -> Fates:
    """Grade the mutants of an assignment, or a fixed sample if `quick`; only of `functions` if there are any.

    A mutant survives if it survives with any seed; if it does with the first, the others are not tried.
    """
    text = (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8")
    all_mutants, listed = mutants(slug, text), equivalents(course, slug)
    wanted = [mutant for mutant in all_mutants if not functions or mutant.function in functions]
    chosen = wanted[:: max(1, len(wanted) // QUICK)] if quick else wanted
    calls, longest = calls_of_checks(course, slug)
    call = max(SHORTEST, SLOWER * longest)
    # two failures are enough to see that no single check is needed
    grading = partial(Grading, course, slug, seed=SEED, limits=ResourceLimits(cpu=CALLS * call, call=call), enough=2)
    tasks = [grading(wrong.name, wrong.text, checks=wrong.checks) for wrong in to_catch(text, chosen, calls)]
    first = [*progress(in_order(executor, tried, tasks), len(tasks), "mutant")]
    results = defaultdict[str, list[Result]](list, {result.student: [result] for result in first})
    caught = [(task, _failed(result), seeds) for task, result in zip(tasks, first, strict=True) if _is_caught(result)]
    for more in progress(in_order(executor, _with_other_seeds, caught if seeds > 1 else []), len(caught), "mutant"):
        for result in more:
            results[result.student].append(result)
    slips = {mutant.name: (mutant.function, mutant.change) for mutant in chosen}
    runs_of = {name: results[name] + results[f"{name} alone"] for name in slips}
    fate = {name: _fate(runs_of[name], change in listed) for name, change in slips.items()}
    killed = {change for name, change in slips.items() if fate[name] == KILLED}
    vain = idle(listed, {(mutant.function, mutant.change) for mutant in all_mutants}, killed)
    failed = {name: _failed(runs[0]) for name, runs in results.items() if runs}
    missed = {  # seeds with full points
        name: sorted({run.seed for run in runs if run.score == run.max_score}) for name, runs in runs_of.items()
    }
    return Fates(slug, chosen, fate, failed, list(calls), vain, missed)


def _fate(results: Sequence[Result], listed: bool) -> str:
    if any(result.score is None for result in results):
        return CRASHED
    if all(map(_is_caught, results)):
        return KILLED
    return EQUIVALENT if listed else SURVIVES


ALONE = """_right, _slipped = {{}}, {{}}
exec({solution!r}, _right)
exec({slipped!r}, _slipped)
{exports}
{function} = _slipped[{function!r}]
"""


def to_catch(solution: str, chosen: Iterable[SolutionMutant], calls: Mapping[str, set[str]]) -> Iterator[Wrong]:
    """Yield each mutant, and if other functions may call its function, also a module in which these call the right one.

    Otherwise their checks might catch the slip, and hide a gap in the checks of this function.
    """
    reachable, called = reached(solution), set().union(*calls.values())
    exports = "\n".join(f"{name} = _right[{name!r}]" for name in sorted(called))
    for mutant in chosen:
        reach = within_reach(reachable, function := mutant.function)
        yield Wrong(mutant.name, mutant.text, reach, calling(calls, reach))
        if function in called and len(reach) > 1:
            itself = frozenset({function})
            alone = ALONE.format(solution=solution, slipped=mutant.text, exports=exports, function=function)
            yield Wrong(f"{mutant.name} alone", alone, itself, calling(calls, itself))


def _with_other_seeds(task: tuple[Grading, Sequence[str], int]) -> list[Result]:
    """Return the results of a mutant with the other seeds, except those with which its first failed check fails again.

    With these, it would also lose points in a full grading, because each check has its own random generator.
    """
    grading, failed, seeds = task
    others = range(SEED + 1, SEED + seeds)
    caught = seeds_that_fail(grading, failed[0], others) if failed else ()
    return [tried(replace(grading, seed=seed)) for seed in others if seed not in caught]


def _is_caught(result: Result) -> bool:
    return result.score is not None and result.score < result.max_score


def _failed(result: Result) -> list[str]:
    return [check_result.name for check_result in result.checks if check_result.outcome == "failed"]


def within_reach(reachable: Mapping[str, set[str]], function: str) -> frozenset[str]:
    """Return the functions that may call `function`, directly or not, and itself."""
    return frozenset(name for name, names in reachable.items() if function in names)


def calling(calls: Mapping[str, set[str]], functions: Set[str]) -> frozenset[str]:
    """Return the checks that call one of these functions directly."""
    return frozenset(check for check, names in calls.items() if names & functions)


def catches(fates_of_all: Fates) -> dict[str, tuple[int, int]]:
    """Return by check the number of mutants that it catches first, and of those that only it catches."""
    failed = [names for names in fates_of_all.failed.values() if names]
    first = Counter(names[0] for names in failed)
    alone = Counter(names[0] for names in failed if len(names) == 1)
    return {name: (first[name], alone[name]) for name in fates_of_all.checks}


def report(fates_of_all: Fates) -> list[str]:
    """Return the lines to print: counts by function and check, checks that no mutant needs, and faults."""
    counts = Counter(fates_of_all.fate.values())
    summary = [counted(len(fates_of_all.chosen), "mutant"), *(f"{counts[fate]} {fate}" for fate in FATES)]
    lines = [f"{fates_of_all.slug}: {', '.join(summary)}"]
    by_function: dict[str, Counter[str]] = {}
    for mutant in fates_of_all.chosen:
        by_function.setdefault(mutant.function, Counter())[fates_of_all.fate[mutant.name]] += 1
    for function, fate in by_function.items():
        lines.append(f"  {function:<48}" + "".join(f"{fate[name]:>6} {name}" for name in FATES if fate[name]))
    for check, (first, alone) in catches(fates_of_all).items():
        needless = "" if alone else "; no mutant tried needs it"
        lines.append(f"  {check:<48}{first:>6} caught first, {alone} by it alone{needless}")
    for mutant in fates_of_all.survivors:
        lines += _shown(mutant, fates_of_all.missed[mutant.name])
    for mutant in fates_of_all.crashing:
        lines.append(f"  CRASHES A CHECK {mutant.function}: {mutant.change}")
    for (function, change), fault in fates_of_all.in_vain.items():
        lines.append(f"  LISTED IN VAIN {function}: {change}: {fault}")
    return lines


def _shown(mutant: SolutionMutant, seeds: Sequence[int]) -> list[str]:
    """Return lines on a survivor: its place, the original and the changed line, and the entry that would list it."""
    where = f"solutions/{mutant.slug}.py:{mutant.line} in {mutant.function}"
    return [
        f"  SURVIVES {where}: {mutant.operator}; with seed {', '.join(map(str, seeds))}",
        f"      - {mutant.before.strip()}",
        f"      + {mutant.after.strip()}",
        *(f"    {line}" for line in entry(mutant).splitlines()),
    ]
