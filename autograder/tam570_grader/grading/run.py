"""A run of `tam570-grader grade`: grades what is there, writes the pages, and keeps what the end of the run needs."""

import argparse
import contextlib
import json
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

__all__ = ["Seen", "whole_run"]

Record = dict[str, Any]  # a result line


@dataclass
class Seen:
    """What is kept of the results of a run until its end: not the results."""

    rows: list[tuple[str, ...]] = field(default_factory=list)  # of the table
    hand: Any = None  # what was added by hand
    faults: list[str] = field(default_factory=list)
    changes: list[Any] = field(default_factory=list)
    compared: int = 0
    last: Record = field(default_factory=dict)
    book: Any = None  # the results in --out


def whole_run(arguments: argparse.Namespace, course: Path, plan_of: Callable[[list[Any]], Any], seen: Seen) -> Any:
    """Grade all, write the pages, and note what the end of the run needs; the plan, made of earlier results."""
    from tam570_grader.pages import feedback
    from tam570_grader.results import by_hand
    from tam570_grader.results.journal import Book, results

    with contextlib.ExitStack() as stack:
        earlier = [*arguments.join, *filter(None, [arguments.against])]
        old = [stack.enter_context(contextlib.closing(results(place, feedback.row))) for place in earlier]
        book = None
        if arguments.out:
            book = seen.book = stack.enter_context(contextlib.closing(Book(arguments.out, note=feedback.row)))
        plan = plan_of([*old, *filter(None, [book])])
        if book is not None:
            by_hand.join(arguments.out, arguments.join)
        _run(plan, book, old, seen, arguments)
        if arguments.against and not arguments.json:
            gone = _gone(old[-1], plan, arguments)
            seen.changes += gone
            seen.compared += len(gone)
        if book is not None:  # the pages of all results that are there; of a finished run, of those that changed
            feedback.write_pages(arguments.out / "feedback", book, course, _with_progress)
            seen.hand = by_hand.read(arguments.out)
            seen.rows = feedback.with_hand(seen.rows, book, seen.hand)
    return plan


def _run(plan: Any, book: Any, old: list[Any], seen: Seen, arguments: argparse.Namespace) -> None:
    """Grade, and note of each result what the end of the run will need."""
    from tam570_grader.grading.many import Known, outcomes
    from tam570_grader.pages.feedback import row

    is_read = arguments.json or arguments.against or arguments.format == "gradescope"
    for outcome in _with_progress(outcomes(plan, book, old), len(plan.submissions)):
        if isinstance(outcome, Known) and not is_read:
            seen.rows.append(outcome.note)
            continue
        record = outcome.record if isinstance(outcome, Known) else outcome
        seen.rows.append(row(record))
        seen.faults += _faults(record)
        seen.last = record
        change = _change(old[-1], record, seen) if arguments.against else {}
        if arguments.json:
            print(json.dumps({**record, **change}, allow_nan=False), flush=True)


def _change(old: Any, record: Record, seen: Seen) -> dict[str, Any]:
    """What became of the old score, as `--json` has it."""
    from tam570_grader.grading import regrade
    from tam570_grader.results.journal import key_of

    change = regrade.change(old.get(key_of(record)), record)
    seen.changes += [change] if change else []
    seen.compared += 1
    return {"change": change and asdict(change)}


def _gone(old: Any, plan: Any, arguments: argparse.Namespace) -> list[Any]:
    """The changes of those who are no longer there; they count among what is compared."""
    from tam570_grader.grading import regrade
    from tam570_grader.writing import assignments

    names = arguments.only or filter(None, [arguments.assignment])
    asked = assignments.named(names, assignments.slugs(plan.course))
    return regrade.gone(old, plan.submissions, arguments.paths, asked)


def _faults(record: Record) -> list[str]:
    if record["score"] is not None:
        return []
    errors = {mark["error"] for mark in record["checks"] if mark["outcome"] == "grader_error"}
    return [f"the grader failed on {record['student']} {record['assignment']}: {'; '.join(errors)}"]


def _with_progress(records: Iterable[Any], total: int) -> Iterator[Any]:
    """The records, with a bar on a terminal."""
    if not sys.stderr.isatty():
        yield from records
        return
    from tqdm import tqdm

    yield from tqdm(records, total=total, unit="submission", leave=False, delay=1.0)
