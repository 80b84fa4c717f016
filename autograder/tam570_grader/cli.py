"""The instructor's command, `tam570-grader`."""

import argparse
import contextlib
import json
import os
import secrets
import sys
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from tam570_grader.audit import add_audit
from tam570_grader.handover import add_course, add_gradescope, add_lms, add_report

__all__ = ["main"]

INTERRUPTED = 130
SHORTEST_KEY = 16  # bytes
Record = dict[str, Any]  # a result line
Commands = Any  # argparse keeps the name of its subparsers' type to itself


class Usage(Exception):
    """Something on the command line is wrong; the message names it and the remedy."""


def main(argv: list[str] | None = None) -> int:
    """Run the command; the exit code is 0 (done), 1 (the grader failed), 2 (bad usage) or 130 (interrupted)."""
    arguments = _parser().parse_args(argv)
    command: Callable[[argparse.Namespace], int] = arguments.command
    try:
        return command(arguments)
    except KeyboardInterrupt:
        print("\ntam570-grader: interrupted; what was finished is kept", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        os.dup2(
            os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno()
        )  # the reader has gone; nothing more to say
        return 0
    except Exception as error:
        if type(error).__name__ not in ("Usage", "BadPath", "BookError", "NoCourse", "NoSandbox"):
            raise
        print(f"tam570-grader: error: {error}", file=sys.stderr)
        return 2


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="tam570-grader", description="Grade the assignments of the course.")
    _add_root(parser, None)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    known = _add_grade, _add_stubs, _add_kit, add_course, add_gradescope, add_lms, add_report, _add_audit
    for add in known:
        _add_root(add(commands), argparse.SUPPRESS)
    return parser


def _add_root(parser: argparse.ArgumentParser, default: str | None) -> None:
    """--root, before the command and after it."""
    where = "the course (default: the checkout you are in, else the one that is installed)"
    parser.add_argument("--root", metavar="DIR", default=default, help=where)


def _add_grade(commands: Commands) -> argparse.ArgumentParser:
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
    add(
        "--seed",
        type=_natural,
        metavar="S",
        help="of the hidden inputs (default: that of --out, else random)",
    )
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
    add("--only", nargs="+", metavar="SLUG", help="grade these assignments alone")
    for name, unit, default, what in (
        ("--jobs", "N", _cores(), "workers"),
        ("--memory", "MIB", 1024, "memory of a submission"),
        ("--cpu", "S", 60, "processor time of a submission"),
        ("--call", "S", 10, "processor time of one call"),
        ("--processes", "N", 1, "processes of a submission"),
    ):
        add(name, type=_positive, metavar=unit, default=default, help=f"{what} (default: %(default)s)")
    return grade


def _add_stubs(commands: Commands) -> argparse.ArgumentParser:
    stubs: argparse.ArgumentParser = commands.add_parser(
        "stubs", help="make the students' stubs from the solutions"
    )
    stubs.set_defaults(command=_stubs)
    stubs.add_argument("--check", action="store_true", help="write nothing; exit 1 if a stub is out of date")
    return stubs


def _add_kit(commands: Commands) -> argparse.ArgumentParser:
    kit: argparse.ArgumentParser = commands.add_parser(
        "kit", help="make what students install and start from"
    )
    kit.set_defaults(command=_kit)
    kit.add_argument("folder", type=Path, metavar="DIR", help="where to put it")
    return kit


def _add_audit(commands: Commands) -> argparse.ArgumentParser:
    return add_audit(commands, _audit, _cores())


def _grade(arguments: argparse.Namespace) -> int:
    _must_be_posix()
    from tam570_grader import feedback, root
    from tam570_grader.book import Book, read

    course = root.find(arguments.root)
    found = _submissions(arguments, root.slugs(course))
    if arguments.vary and arguments.seed is not None:
        raise Usage("--seed and --vary: a seed is for the whole class, a key varies it; give one of them")
    if arguments.out:
        feedback.must_write_pages()
    old = read(arguments.against) if arguments.against else []
    done: list[Record] = []
    try:
        with contextlib.closing(Book(arguments.out)) if arguments.out else contextlib.nullcontext() as book:
            plan = _plan(arguments, course, found, [*old, *(book.records() if book else [])])
            _warn_of_isolation()
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
        _print_tables(done, plan, old if arguments.against else None)
    return _exit_code(done)


def _plan(arguments: argparse.Namespace, course: Path, found: list[Any], earlier: list[Record]) -> Any:
    """What is graded and how; of the results that are there it takes the seed."""
    from tam570_grader.run import Plan
    from tam570_grader.sandbox import Allowance

    key = _key(arguments.vary, bool(earlier)) if arguments.vary else None
    seed = _seed(arguments.seed, earlier, key)
    allowance = Allowance(arguments.memory * 2**20, arguments.cpu, arguments.call, arguments.processes)
    ours = [*arguments.paths, *filter(None, (arguments.out, arguments.against, arguments.vary))]
    hidden = [course, *(path.resolve() for path in ours)]
    return Plan(course, found, seed, arguments.jobs, allowance, hidden, arguments.speed, key=key)


def _run(plan: Any, book: Any, old: list[Record], done: list[Record], arguments: argparse.Namespace) -> None:
    """Grade, and put each result into `done` as soon as it is there."""
    from tam570_grader import regrading
    from tam570_grader.run import records

    before = regrading.newest(old)
    for record in _with_progress(records(plan, book, old), len(plan.submissions)):
        done.append(record)
        if arguments.json:
            compared = {"change": regrading.told(before, record)} if arguments.against else {}
            print(json.dumps({**record, **compared}), flush=True)


def _seed(given: int | None, earlier: list[Record], key: bytes | None) -> int:
    """The seed asked for, else that of the results that are there, else any."""
    from tam570_grader.book import seed_of

    if key is not None or given is not None:
        return given or 0
    found = seed_of(earlier)
    return secrets.randbelow(2**31) if found is None else found


def _key(path: Path, needed: bool) -> bytes:
    """The key in the file; a new one if there is no file and nothing was graded with it yet."""
    if not path.exists():
        if needed:
            raise Usage(
                f"there is no key in {path}, and the earlier results want the one they were graded with"
            )
        with open(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w", encoding="ascii") as file:
            file.write(secrets.token_hex(32) + "\n")
        print(f"tam570-grader: a new key: {path}; keep it, the scores hang on it", file=sys.stderr)
    try:
        key = path.read_bytes().strip()
    except OSError as error:
        raise Usage(f"cannot read the key {path}: {error.strerror}") from None
    if len(key) < SHORTEST_KEY:
        raise Usage(
            f"{path} is no key: it holds fewer than {SHORTEST_KEY} bytes; name a new file to have one made"
        )
    return key


def _print_tables(done: list[Record], plan: Any, old: list[Record] | None) -> None:
    from tam570_grader import feedback, regrading

    print(feedback.table(sorted(done, key=lambda record: (record["assignment"], record["student"]))))
    inputs = "the same key" if plan.key else f"seed {plan.seed}; the same seed"
    print(f"\n{inputs} gives the same hidden inputs and the same scores")
    if old is not None:
        print("\n" + regrading.table(regrading.changes(old, done), len(done)))


def _print_gradescope(course: Path, done: list[Record]) -> int:
    """results.json of the one submission, or nothing if the grader failed on it; the exit code."""
    from tam570_grader import gradescope, root

    if len(done) != 1:
        raise Usage(f"--format gradescope is for one submission; there are {len(done)} at these paths")
    if code := _exit_code(done):
        return code
    lines = {check.name: check.line for check in root.assignment(course, done[0]["assignment"]).checks}
    print(json.dumps(gradescope.results(done[0], lines), indent=1))
    return 0


def _slug(name: str, known: list[str]) -> str:
    from tam570_grader.root import slug_of

    found = slug_of(name, known)
    if found is None:
        raise Usage(f"there is no assignment {name!r}; there are: {', '.join(known)}")
    return found


def _submissions(arguments: argparse.Namespace, known: list[str]) -> list[Any]:
    from tam570_grader.submissions import submissions

    given = _slug(arguments.assignment, known) if arguments.assignment else None
    only = [_slug(name, known) for name in arguments.only or known]
    found = [one for one in submissions(arguments.paths, known, given) if one.slug in only]
    if not found:
        raise Usage(f"there is no submission of {', '.join(only)} at these paths")
    return found


def _exit_code(done: list[Record]) -> int:
    failed = [r for r in done if r["score"] is None]
    for record in failed:
        errors = {mark["detail"]["error"] for mark in record["checks"] if mark["outcome"] == "grader_error"}
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


def _warn_of_isolation() -> None:
    from tam570_grader.launch import isolation

    if isolation() != "bubblewrap":
        print(
            "tam570-grader: warning: no bubblewrap, or no namespaces for it: submissions run as plain processes "
            "with limits; they can read files and use the network",
            file=sys.stderr,
        )


def _stubs(arguments: argparse.Namespace) -> int:
    from tam570_grader import root, stubs

    return stubs.run(root.find(arguments.root), check=arguments.check)


def _kit(arguments: argparse.Namespace) -> int:
    from tam570_grader import kit, root

    return kit.run(root.find(arguments.root), arguments.folder)


def _audit(arguments: argparse.Namespace) -> int:
    _must_be_posix()
    from tam570_grader import audit, root

    course = root.find(arguments.root)
    known = root.slugs(course)
    slugs = [_slug(name, known) for name in arguments.assignments] or known
    _warn_of_isolation()
    return audit.run(course, slugs, arguments)


def _must_be_posix() -> None:
    if os.name != "posix":
        raise Usage("grading needs Linux or macOS; on Windows, use WSL")


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _natural(text: str) -> int:
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 0 on")
    return int(text)


def _positive(text: str) -> int:
    number = _natural(text)
    if number == 0:
        raise argparse.ArgumentTypeError("must be at least 1")
    return number


if __name__ == "__main__":
    sys.exit(main())
