"""The command that grades submissions: `tam570-grader grade`."""

import argparse
import contextlib
import json
import os
import secrets
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from tam570_grader.errors import UsageError, writing
from tam570_grader.options import Commands, cores, natural, positive

__all__ = ["add_grade", "warn_of_isolation"]

SHORTEST_KEY = 16  # bytes
OTHERS = 0o077  # of a file's mode: what others may do with it
Record = dict[str, Any]  # a result line


def add_grade(commands: Commands) -> argparse.ArgumentParser:
    grade: argparse.ArgumentParser = commands.add_parser(
        "grade",
        help="grade submissions",
        description="Grade modules, notebooks, their folders, or a tree of submissions <student>/<assignment>/.",
        epilog="The exit code is 0 when grading worked, whatever the scores; 1 when the grader failed; 2 on bad usage.",
    )
    grade.set_defaults(command=_grade)
    add = grade.add_argument
    add("paths", nargs="+", type=Path, metavar="PATH", help="a module, a notebook, a folder or a tree")
    add("--out", type=Path, metavar="DIR", help="write results.jsonl, grades.csv and feedback there")
    add("--json", action="store_true", help="print a JSON object for each submission, one a line")
    add("--format", choices=["table", "gradescope"], default="table", help="of what is printed")
    add("--seed", type=natural, metavar="S", help="of the hidden inputs (default: the one in --out, else random)")
    add(
        "--vary",
        type=Path,
        metavar="KEYFILE",
        help="give each student other inputs, by the key in this file; made if new",
    )
    add(
        "--against",
        type=Path,
        metavar="OLD",
        help="say which scores of these results change, and why; what is as it was is not run",
    )
    add("--speed", action="store_true", help="also measure the run time of simulations, for the pages")
    add("--assignment", metavar="SLUG", help="which one it is, where the names do not tell")
    add("--roster", type=Path, metavar="CSV", help="all students: who handed in nothing gets a row, too")
    add("--only", nargs="+", metavar="SLUG", help="grade these assignments alone")
    for name, unit, default, what in (
        ("--jobs", "N", cores(), "workers"),
        ("--memory", "MIB", 1024, "memory of a submission"),
        ("--cpu", "S", 60, "processor time of a submission"),
        ("--call", "S", 10, "processor time of one call"),
        ("--processes", "N", 1, "processes of a submission"),
    ):
        add(name, type=positive, metavar=unit, default=default, help=f"{what} (default: %(default)s)")
    return grade


def _grade(arguments: argparse.Namespace) -> int:
    from tam570_grader.pages import feedback
    from tam570_grader.results.journal import Book, read
    from tam570_grader.writing import assignments

    course = assignments.find(arguments.root)
    found = _submissions(arguments, assignments.slugs(course))
    if arguments.vary and arguments.seed is not None:
        raise UsageError("--seed and --vary: a seed is for the whole class, a key varies it; give one of them")
    if arguments.out:
        feedback.must_write_pages()
    old = read(arguments.against) if arguments.against else []
    done: list[Record] = []
    try:
        with contextlib.closing(Book(arguments.out)) if arguments.out else contextlib.nullcontext() as book:
            plan = _plan(arguments, course, found, [*old, *(book.records() if book else [])])
            warn_of_isolation()
            _run(plan, book, old, done, arguments)
        if book:
            feedback.write_pages(arguments.out / "feedback", book.records(), course)
    except BrokenPipeError:
        raise
    except OSError as error:
        print(f"tam570-grader: error: {error}; {len(done)} results are kept", file=sys.stderr)
        return 1
    if arguments.format == "gradescope":
        return _print_gradescope(course, done)
    if not arguments.json:
        _print_tables(done, plan)
        if arguments.against:
            _print_changes(old, done, plan, arguments)
    return _exit_code(done)


def _plan(arguments: argparse.Namespace, course: Path, found: list[Any], earlier: list[Record]) -> Any:
    """What is graded and how; of the results that are there it takes the seed."""
    from tam570_grader.grading.many import Plan
    from tam570_grader.sandbox.worker import Allowance

    key = _key(arguments.vary, bool(earlier)) if arguments.vary else None
    seed = _seed(arguments.seed, earlier, key)
    allowance = Allowance(arguments.memory * 2**20, arguments.cpu, arguments.call, arguments.processes)
    ours = [*arguments.paths, *filter(None, (arguments.out, arguments.against, arguments.vary))]
    hidden = [course, *(path.resolve() for path in ours)]
    return Plan(course, found, seed, arguments.jobs, allowance, hidden, arguments.speed, key=key)


def _run(plan: Any, book: Any, old: list[Record], done: list[Record], arguments: argparse.Namespace) -> None:
    """Grade, and put each result into `done` as soon as it is there."""
    from tam570_grader.grading.many import records
    from tam570_grader.results import regrade

    before = regrade.newest(old)
    for record in _with_progress(records(plan, book, old), len(plan.submissions)):
        done.append(record)
        if arguments.json:
            compared = {"change": regrade.told(before, record)} if arguments.against else {}
            print(json.dumps({**record, **compared}), flush=True)


def _seed(given: int | None, earlier: list[Record], key: bytes | None) -> int:
    """The seed asked for, else that of the results that are there, else any."""
    from tam570_grader.results.journal import seed_of

    if key is not None or given is not None:
        return given or 0
    found = seed_of(earlier)
    return secrets.randbelow(2**31) if found is None else found


def _key(path: Path, needed: bool) -> bytes:
    """The key in the file; a new one if there is no file and nothing was graded with it yet."""
    if not path.exists():
        if needed:
            raise UsageError(
                f"there is no key in {path}, and there are earlier results. Name the key that they were varied by. "
                "If they were graded with a seed, leave --vary away or name a new folder with --out."
            )
        _make_key(path)
    try:
        key = path.read_bytes().strip()
        if path.stat().st_mode & OTHERS:
            print(f"tam570-grader: warning: the key is not yours alone: chmod 600 {path}", file=sys.stderr)
    except OSError as error:
        raise UsageError(f"cannot read the key {path}: {error.strerror}") from None
    if len(key) < SHORTEST_KEY:
        raise UsageError(
            f"{path} is not a key: it holds fewer than {SHORTEST_KEY} bytes; name a new file to have one made"
        )
    return key


def _make_key(path: Path) -> None:
    with writing(path):
        file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with open(file, "w", encoding="ascii") as key:
        key.write(secrets.token_hex(32) + "\n")
    print(f"tam570-grader: a new key: {path}; keep it, the scores hang on it", file=sys.stderr)


def _print_tables(done: list[Record], plan: Any) -> None:
    from tam570_grader.pages import feedback

    print(feedback.table(sorted(done, key=lambda record: (record["assignment"], record["student"]))))
    inputs = "the same key" if plan.key else f"seed {plan.seed}; the same seed"
    print(f"\n{inputs} gives the same hidden inputs and the same scores")


def _print_changes(old: list[Record], done: list[Record], plan: Any, arguments: argparse.Namespace) -> None:
    from tam570_grader.results import regrade
    from tam570_grader.writing import assignments

    names = arguments.only or filter(None, [arguments.assignment])
    asked = assignments.named(names, assignments.slugs(plan.course))
    gone = regrade.gone(old, plan.submissions, arguments.paths, asked)
    print("\n" + regrade.table([*regrade.changes(old, done), *gone], len(done) + len(gone)))


def _print_gradescope(course: Path, done: list[Record]) -> int:
    """results.json of the one submission, or nothing if the grader failed on it; the exit code."""
    from tam570_grader.delivery import gradescope
    from tam570_grader.writing import assignments

    if len(done) != 1:
        raise UsageError(f"--format gradescope is for one submission; there are {len(done)} at these paths")
    if code := _exit_code(done):
        return code
    lines = {check.name: check.line for check in assignments.assignment(course, done[0]["assignment"]).checks}
    print(json.dumps(gradescope.results(done[0], lines), indent=1))
    return 0


def _submissions(arguments: argparse.Namespace, known: list[str]) -> list[Any]:
    from tam570_grader.grading.overlooked import not_handed_in, overlooked
    from tam570_grader.grading.submissions import submissions
    from tam570_grader.writing import assignments

    given = assignments.named([arguments.assignment], known)[0] if arguments.assignment else None
    only = assignments.named(arguments.only or (), known)
    everything = submissions(arguments.paths, known, given)
    for sentence in overlooked(arguments.paths, everything, known):
        print(f"tam570-grader: warning: {sentence}", file=sys.stderr)
    found = [one for one in everything if one.slug in only]
    if not found:
        raise UsageError(f"there is no submission of {', '.join(only)} at these paths")
    return found + (not_handed_in(arguments.roster, found) if arguments.roster else [])


def _exit_code(done: list[Record]) -> int:
    failed = [r for r in done if r["score"] is None]
    for record in failed:
        errors = {mark["error"] for mark in record["checks"] if mark["outcome"] == "grader_error"}
        print(
            f"tam570-grader: the grader failed on {record['student']} {record['assignment']}: {'; '.join(errors)}",
            file=sys.stderr,
        )
    return 1 if failed else 0


def _with_progress(records: Iterable[Any], total: int) -> Iterator[Any]:
    """The records, with a bar on a terminal."""
    if not sys.stderr.isatty():
        yield from records
        return
    from tqdm import tqdm

    yield from tqdm(records, total=total, unit="submission", leave=False, delay=1.0)


def warn_of_isolation() -> None:
    from tam570_grader.sandbox.launch import isolation

    if isolation() != "bubblewrap":
        print(
            "tam570-grader: warning: no bubblewrap, or no namespaces for it: submissions run as plain processes "
            "with limits; they can read files and use the network",
            file=sys.stderr,
        )
