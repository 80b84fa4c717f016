"""A run of `tam570-grader grade`: grades what is there, writes the pages, and keeps what the end of the run needs."""

import argparse
import contextlib
import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.errors import progress, say
from tam570_grader.grading import regrade
from tam570_grader.grading.batch import CachedResult, RunConfig, outcomes
from tam570_grader.grading.regrade import Change
from tam570_grader.reports import feedback
from tam570_grader.reports.feedback import row
from tam570_grader.results import manual_points
from tam570_grader.results.manual_points import ManualAdjustments
from tam570_grader.results.store import Results, ResultStore, key_of, results

Record = Json  # a result line


@dataclass
class RunSummary:
    """What is kept of the results of a run until its end: not the results."""

    rows: list[tuple[str, ...]] = field(default_factory=list)  # of the table
    adjustments: ManualAdjustments | None = None  # what was added by hand
    faults: list[str] = field(default_factory=list)
    changes: list[Change] = field(default_factory=list)
    compared: int = 0
    last: Record = field(default_factory=dict)
    store: ResultStore | None = None  # the results in --out


def whole_run(
    arguments: argparse.Namespace, course: Path, config_of: Callable[[list[Results]], RunConfig], summary: RunSummary
) -> RunConfig:
    """Grade all submissions, write the pages, and fill the summary; return the configuration."""
    with contextlib.ExitStack() as stack:
        earlier = [*arguments.join, *filter(None, [arguments.against])]
        old = [stack.enter_context(contextlib.closing(results(folder, feedback.row))) for folder in earlier]
        store = None
        if arguments.out:
            store = summary.store = stack.enter_context(
                contextlib.closing(ResultStore(arguments.out, summary_row=feedback.row))
            )
        config = config_of([*old, *filter(None, [store])])
        if store is not None:
            manual_points.join(arguments.out, arguments.join)
        _run(config, store, old, summary, arguments)
        if arguments.against and not arguments.json:
            names = arguments.only or filter(None, [arguments.assignment])
            slugs = assignments.match_slugs(names, assignments.slugs(course))
            gone = regrade.gone(old[-1], config.submissions, arguments.paths, slugs)  # who are no longer there
            summary.changes += gone
            summary.compared += len(gone)
        if store is not None:  # the pages of all results that are there; of a finished run, of those that changed
            failed = feedback.write_pages(arguments.out / "feedback", store, course)
            summary.faults += [f"{' '.join(key)} has no page of feedback" for key in failed]
            summary.adjustments = manual_points.read(arguments.out)
            summary.rows = feedback.with_hand(summary.rows, store, summary.adjustments)
    return config


def _run(
    config: RunConfig, store: ResultStore | None, old: list[Results], summary: RunSummary, arguments: argparse.Namespace
) -> None:
    """Grade, and fill the summary."""
    is_read = arguments.json or arguments.against or arguments.format == "gradescope"
    for outcome in progress(outcomes(config, store, old), len(config.submissions), "submission"):
        if isinstance(outcome, CachedResult) and not is_read:
            summary.rows.append(outcome.summary_row)
            continue
        record = outcome.record if isinstance(outcome, CachedResult) else outcome
        summary.rows.append(row(record))
        if record["score"] is None:
            errors = {check["error"] for check in record["checks"] if check["outcome"] == "grader_error"}
            who = f"{record['student']} {record['assignment']}"
            summary.faults.append(f"the grader failed on {who}: {'; '.join(errors)}")
        summary.last, more = record, Json()
        if arguments.against:
            change = regrade.change(old[-1].get(key_of(record)), record)
            summary.changes += [change] if change else []
            summary.compared += 1
            more = {"change": change and asdict(change)}
        if arguments.json:
            say(json.dumps({**record, **more}, allow_nan=False))
