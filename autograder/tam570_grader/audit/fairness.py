"""Grade right submissions with many seeds, to count false failures and bound their rate."""

import hashlib
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from tam570.values import Json
from tam570_grader.audit.gradings import Grading, tried
from tam570_grader.checks import assignments
from tam570_grader.errors import UsageError, progress, writing
from tam570_grader.grading.executor import TaskExecutor, in_order

FIRST_SEED = 5000
CONFIDENCE = 0.95
Line = Json  # has FIELDS; "fails": [[check, message], ...]
FIELDS = {"assignment", "submission", "digest", "seed", "fails"}


@dataclass(frozen=True)
class Class:
    """A task: the right submissions of an assignment to grade with one seed, so that they share expected results."""

    course: Path
    slug: str
    seed: int
    texts: Mapping[str, str]  # by name
    digests: Mapping[str, str]


def fair(course: Path, slug: str, seeds: int, executor: TaskExecutor, keep: Path | None = None) -> list[Line]:
    """Return a line for each right submission and seed; reuse up-to-date lines of the file `keep`, and add new ones."""
    solution = (course / "solutions" / f"{slug}.py").read_text(encoding="utf-8")
    texts = {"solution": solution, **assignments.alternatives(course, slug)}
    digests = {}  # of all that the outcome depends on: submission, checks and engine
    for name, text in texts.items():
        parts = (text.encode(), assignments.checks_digest(course, slug), assignments.engine_digest())
        digests[name] = hashlib.sha256(b"\0".join(parts)).hexdigest()
    all_seeds = range(FIRST_SEED, FIRST_SEED + seeds)
    earlier = {
        (line["submission"], line["seed"]): line
        for line in _kept(keep)
        if line["digest"] == digests.get(line["submission"]) and line["seed"] in all_seeds
    }
    tasks = []
    for seed in all_seeds:
        if fresh := {name: text for name, text in texts.items() if (name, seed) not in earlier}:
            tasks.append(Class(course, slug, seed, fresh, digests))
    lines = [*earlier.values()]
    for graded in progress(in_order(executor, _graded, tasks), len(tasks), "seed"):
        _add(keep, graded)
        lines += graded
    return lines


def _graded(group: Class) -> list[Line]:
    lines = []
    for name, text in group.texts.items():
        result = tried(Grading(group.course, group.slug, name, text, group.seed))
        fails = [[check.name, check.message] for check in result.checks if check.outcome != "passed"]
        about = {"assignment": group.slug, "submission": name, "digest": group.digests[name], "seed": group.seed}
        lines.append({**about, "fails": fails})
    return lines


def _kept(keep: Path | None) -> Iterator[Line]:
    """Yield the lines of an earlier run, without incomplete ones; create the file if it does not exist."""
    if keep is None:
        return
    with writing(keep), keep.open("a+b") as file:
        file.seek(0)
        texts = file.read().splitlines()
    for text in texts:
        try:
            line = json.loads(text)
        except json.JSONDecodeError:
            continue
        except UnicodeDecodeError:
            line = None
        if not isinstance(line, dict) or not line.keys() >= FIELDS:
            raise UsageError(f"{keep} holds a line that --fairness did not write; name another file with --keep")
        yield line


def _add(keep: Path | None, lines: Iterable[Line]) -> None:
    """Append lines to the file, on a new line if its last one is incomplete."""
    if keep:
        with keep.open("a+b") as file:
            file.seek(max(0, file.seek(0, os.SEEK_END) - 1))
            if file.read() not in (b"", b"\n"):
                file.write(b"\n")
            file.writelines(json.dumps(line).encode() + b"\n" for line in lines)


def upper_bound(failures: int, runs: int) -> float:
    """Return an upper bound on the rate of false failures, with 95 % confidence (Clopper and Pearson)."""
    from scipy.stats import beta

    return 1.0 if failures == runs else float(beta.ppf(CONFIDENCE, failures + 1, runs - failures))


def report(lines: Sequence[Line]) -> list[str]:
    """Return the lines to print: runs, false failures and bound of each submission, and every false failure."""
    shown = []
    for name in dict.fromkeys(line["submission"] for line in lines):
        of_it = [line for line in lines if line["submission"] == name]
        shown.append(f"  {name:<32}{counted(of_it)}")
        for line in of_it:
            shown += [f"    seed {line['seed']}: {check}: {message}" for check, message in line["fails"]]
    return [f"{lines[0]['assignment']}: {counted(lines)}", *shown]


def counted(lines: Sequence[Line]) -> str:
    """Return runs, false failures and the bound as text."""
    fails = sum(bool(line["fails"]) for line in lines)
    return f"{len(lines):>6} runs, {fails} false fails, rate below {upper_bound(fails, len(lines)):.2%}"
