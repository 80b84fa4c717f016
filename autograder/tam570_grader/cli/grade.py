"""The command `tam570-grader grade`, which grades submissions."""

import argparse
import json
import zlib
from collections.abc import Sequence
from contextlib import AbstractContextManager, ExitStack, closing
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.cli.options import add_cluster, natural, positive
from tam570_grader.course import course_config
from tam570_grader.errors import UsageError, counted, progress, say, warn, with_remedy
from tam570_grader.grading import regrade, roster, seeds
from tam570_grader.grading.batch import RunConfig, records
from tam570_grader.grading.executor import TaskExecutor, cores, executor
from tam570_grader.grading.prove import prove
from tam570_grader.grading.regrade import Change
from tam570_grader.grading.skipped_files import not_handed_in, skipped_files
from tam570_grader.grading.submissions import Submission, handed_in, submissions
from tam570_grader.reports import feedback
from tam570_grader.results import manual_points
from tam570_grader.results.manual_points import ManualAdjustments
from tam570_grader.results.store import Results, ResultStore, key_of, results
from tam570_grader.sandbox.launch import close_early, hide_from_submissions, isolation

if TYPE_CHECKING:
    from tam570_grader.grading.cluster import Cluster


@dataclass
class RunSummary:
    """Data of a run that are printed at its end; the results themselves are not kept in memory."""

    rows: list[tuple[str, ...]] = field(default_factory=list)  # rows of the table
    adjustments: ManualAdjustments | None = None  # by hand, from --out
    faults: list[str] = field(default_factory=list)
    changes: list[Change] = field(default_factory=list)
    compared: int = 0  # number of scores compared with --against
    last: Json = field(default_factory=dict)  # record of the last result
    store: ResultStore | None = None  # the results in --out


def add_grade(parser: argparse.ArgumentParser) -> None:
    """Add the options of `grade`."""
    parser.set_defaults(command=_grade)
    parser.description = (
        "Grade modules, notebooks, zip files, folders, or a tree of submissions <student>/<assignment>/."
    )
    parser.epilog = (
        "The exit code is 0 when grading worked, whatever the scores; 1 when the grader failed; 2 on bad usage."
    )
    add = parser.add_argument
    add("paths", nargs="+", type=Path, metavar="PATH", help="a module, a notebook, a zip file, a folder or a tree")
    add("--out", type=Path, metavar="DIR", help="write results.jsonl, grades.csv and feedback there")
    add("--json", action="store_true", help="print a JSON object for each submission, one a line")
    form = "the format of the printed results (default: %(default)s)"
    add("--format", choices=["table", "gradescope"], default="table", help=form)
    seed = "seed of the hidden inputs, or a file that holds it (default: the one in --out, else random)"
    add("--seed", type=_seed, metavar="S|@FILE", help=seed)
    vary = "give each student different inputs, from the key in this file; create the file if it is new"
    add("--vary", type=Path, metavar="KEYFILE", help=vary)
    against = "list the scores that differ from these results, and why; run only what has changed"
    add("--against", type=Path, metavar="OLD", help=against)
    join = "copy the results of other runs, such as parts of the class, in place of grading them again"
    add("--join", type=Path, nargs="+", metavar="DIR", default=[], help=join)
    add("--shard", type=_shard, metavar="K/N", help="grade only the K-th of N parts of the class, for N machines")
    add("--speed", action="store_true", help="also measure the run time of simulations, for the pages")
    add("--assignment", metavar="SLUG", help="the assignment, if no name tells it")
    add("--roster", type=Path, metavar="CSV", help="a list of all students; those without work get a row, too")
    add("--only", nargs="+", metavar="SLUG", help="grade only these assignments")
    add(
        "--jobs", type=positive, metavar="N", default=cores(), help="supervisors, a process each (default: %(default)s)"
    )
    add("--processes", type=positive, metavar="N", default=1, help="processes of a submission (default: %(default)s)")
    usual = "default: from course.toml, else"
    add("--memory", type=positive, metavar="MIB", help=f"memory of a submission ({usual} 1024)")
    add("--cpu", type=positive, metavar="S", help=f"processor time of a submission ({usual} 60)")
    add("--call", type=positive, metavar="S", help=f"processor time of one call ({usual} 10)")
    add_cluster(add)


def _seed(text: str) -> int:
    """Return the seed in a text, or for @FILE that in the file, so that lists of processes do not show it."""
    if not text.startswith("@"):
        return natural(text)
    try:
        return natural(Path(text[1:]).read_text(encoding="ascii").strip())
    except (OSError, ValueError) as error:
        raise argparse.ArgumentTypeError(f"cannot read a seed from {text[1:]}: {error}") from None


def _grade(arguments: argparse.Namespace) -> int:
    course = course_config.course_of(arguments.root, arguments.paths)
    chosen = _submissions(arguments, assignments.slugs(course))
    if arguments.format == "gradescope" and len(chosen) != 1:
        raise UsageError(f"--format gradescope is for one submission; there are {len(chosen)} at these paths")
    prove(course, sorted({submission.slug for submission in chosen}))
    if arguments.vary and arguments.seed is not None:
        raise UsageError("--seed and --vary: a seed is for the whole class, a key varies it; give one of them")
    if arguments.out:
        feedback.must_write_pages()
    if arguments.cluster:
        close_early()
    else:
        warn_of_isolation()
    summary = RunSummary()
    try:
        config = _run(arguments, course, chosen, summary)
    except BrokenPipeError:
        raise
    except KeyboardInterrupt:
        raise KeyboardInterrupt(_what_is_kept(arguments.out, summary)) from None
    except OSError as error:
        warn(f"{with_remedy(error)}; {_what_is_kept(arguments.out, summary)}", "error: ")
        return 1
    return _print_results(arguments, course, config, summary)


def _run(arguments: argparse.Namespace, course: Path, chosen: list[Submission], summary: RunSummary) -> RunConfig:
    """Grade all submissions, write the pages, and fill the summary; return the configuration of the run."""
    with ExitStack() as stack:
        earlier = [*arguments.join, *filter(None, [arguments.against])]
        old = [stack.enter_context(closing(results(folder))) for folder in earlier]
        store = ResultStore(arguments.out) if arguments.out else None
        if store is not None:
            summary.store = stack.enter_context(closing(store))
        config = _config(arguments, course, chosen, [*old, *filter(None, [store])])
        if store is not None:
            manual_points.join(arguments.out, arguments.join)
        for record in progress(records(config, store, old), len(chosen), "submission"):
            _add_result(record, old, summary, arguments)
        if arguments.against and not arguments.json:
            names = arguments.only or filter(None, [arguments.assignment])
            slugs = assignments.match_slugs(names, assignments.slugs(course))
            gone = regrade.gone(old[-1], chosen, arguments.paths, slugs)  # results without a submission now
            summary.changes += gone
            summary.compared += len(gone)
        if store is not None:  # write the pages of all results in the store, unless they are up to date
            failed = feedback.write_pages(arguments.out / "feedback", store, course)
            summary.faults += [f"{' '.join(key)} has no page of feedback" for key in failed]
            summary.adjustments = manual_points.read(arguments.out)
            summary.rows = feedback.with_hand(summary.rows, store, summary.adjustments)
    return config


def _add_result(record: Json, old: list[Results], summary: RunSummary, arguments: argparse.Namespace) -> None:
    """Add a result to the summary; with --json also print it, with the change of its score if there is --against."""
    summary.rows.append(feedback.row(record))
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


def _what_is_kept(out: Path | None, summary: RunSummary) -> str:
    if out is None:
        return "nothing is kept without --out"
    return f"{counted(len(summary.store or ()), 'result')} kept in {out}; the same command goes on from there"


def _print_results(arguments: argparse.Namespace, course: Path, config: RunConfig, summary: RunSummary) -> int:
    """Print the results in the requested format; return the exit code."""
    if arguments.format == "gradescope" and not summary.faults:
        from tam570_grader.gradescope import autograder

        checks = assignments.assignment(course, summary.last["assignment"]).checks
        say(json.dumps(autograder.results(summary.last, {check.name: check.title for check in checks}), indent=1))
    elif arguments.format != "gradescope" and not arguments.json:
        say(feedback.table(sorted(summary.rows, key=lambda row: (row[1], row[0]))))
        inputs = "the same key" if config.key else f"seed {config.seed}; the same seed"
        say(f"\n{inputs} gives the same hidden inputs and the same scores")
        if lacking := _missing_points(summary, config):
            say(f"the points that you give by hand are not in it yet: {lacking}")
        if arguments.against:
            say("\n" + regrade.table(summary.changes, summary.compared))
    for fault in summary.faults:
        warn(fault, "")
    return 1 if summary.faults else 0


def _config(arguments: argparse.Namespace, course: Path, chosen: list[Submission], earlier: list[Results]) -> RunConfig:
    """Return the configuration of the run; without --seed, the seed is that of the earlier results."""
    key = seeds.key(arguments.vary, any(earlier)) if arguments.vary else None
    seed = seeds.seed(arguments.seed, earlier, key)
    options = {name: vars(arguments)[name] for name in course_config.STANDARD}
    limits = course_config.resource_limits(course, arguments.processes, **options)
    ours = [*arguments.paths, *arguments.join, *filter(None, (arguments.out, arguments.against, arguments.vary))]
    hidden = [course, *(path.resolve() for path in ours)]
    if course.parent.name == course_config.ADAPTED_COURSES:  # also hide the checkout and course.toml's folder
        hidden += [(course / "shared").resolve().parent, course.parents[1]]
    cluster = _cluster(arguments)
    return RunConfig(course, chosen, seed, arguments.jobs, limits, hidden, arguments.speed, key=key, cluster=cluster)


def _cluster(arguments: argparse.Namespace) -> "Cluster | None":
    """Return the cluster that --cluster names; None for this machine."""
    if not arguments.cluster:
        if arguments.certificates or arguments.unconfined:
            raise UsageError("--certificates and --unconfined go with --cluster")
        return None
    from tam570_grader.grading.cluster import Cluster

    return Cluster(arguments.cluster, arguments.certificates, arguments.unconfined)


def executor_of(
    arguments: argparse.Namespace, course: Path, slugs: Sequence[str]
) -> AbstractContextManager[TaskExecutor]:
    """Return the executor for the options --jobs and --cluster."""
    cluster = _cluster(arguments)
    return cluster.executor(course, slugs, arguments.jobs) if cluster else executor(arguments.jobs)


def _missing_points(summary: RunSummary, config: RunConfig) -> str:
    """Return, as text, the points of each assignment's parts that are graded by hand but not included yet."""
    parts = {slug: assignments.rubric_of(config.course, slug) for slug in sorted({row[1] for row in summary.rows})}
    lacking = {slug: sum(part.points for part in rubric.values()) for slug, rubric in parts.items() if rubric}
    counted = {slug for slug in lacking if summary.adjustments and summary.adjustments.counts_parts(slug)}
    return ", ".join(f"{most:g} of {slug}" for slug, most in lacking.items() if slug not in counted)


def _shard_of(student: str, parts: int) -> int:
    """Return the number of the shard of a student, from 1 to `parts`; it is the same on every machine."""
    return zlib.crc32(student.encode()) % parts + 1


def _shard(text: str) -> tuple[int, int]:
    """Return the numbers 2 and 5 for "2/5"."""
    k, _, n = text.partition("/")
    if not (k.isdecimal() and n.isdecimal() and 1 <= int(k) <= int(n)):
        raise argparse.ArgumentTypeError(f"{text!r} is not K/N with K from 1 to N")
    return int(k), int(n)


def _submissions(arguments: argparse.Namespace, slugs: list[str]) -> list[Submission]:
    slug = assignments.match_slug(arguments.assignment, slugs)
    only = assignments.match_slugs(arguments.only or (), slugs)
    students = roster.folders(arguments.roster) if arguments.roster else ()
    if slug and arguments.format == "gradescope" and len(arguments.paths) == 1 and arguments.paths[0].is_dir():
        return [handed_in(arguments.paths[0], slug)]
    everything = submissions(arguments.paths, slugs, slug, students)
    for sentence in skipped_files(arguments.paths, everything, slugs, students):
        warn(sentence)
    chosen = [submission for submission in everything if submission.slug in only]
    if not chosen:
        raise UsageError(f"there is no submission of {', '.join(only)} at these paths")
    everyone = chosen + (not_handed_in(arguments.roster, chosen, arguments.paths) if arguments.roster else [])
    k, n = arguments.shard or (1, 1)
    return [submission for submission in everyone if _shard_of(submission.student, n) == k]


def warn_of_isolation() -> None:
    """Warn if there is no bubblewrap, and then hide data of this process that submissions could read."""
    if isolation() != "bubblewrap":
        hide_from_submissions()
        warn(
            "no bubblewrap, or no namespaces for it: submissions run as plain processes with limits, can read files "
            "and command lines (so write --seed @FILE), and use the network; install bubblewrap"
        )
