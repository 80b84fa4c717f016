"""The students' command, `tam570`. What a command does not need is not imported: `list` takes no numerical library."""

import argparse
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tam570 import __version__
from tam570.course import Unknown, assignments, folder, start, title
from tam570.lectures import commands as lectures
from tam570.progress import hints_given, recalled, remember_hints

__all__ = ["main"]

INTERRUPTED = 130


def main(argv: list[str] | None = None) -> int:
    """Run the command; the exit code is 0, 1 (a test failed), 2 (bad usage) or 130 (interrupted)."""
    arguments = _parser().parse_args(argv)
    command: Callable[[argparse.Namespace], int] = arguments.command
    try:
        return command(arguments)
    except Unknown as error:
        print(f"tam570: error: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:  # the reader has gone; nothing more to say
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        print(f"tam570: error: {error.filename or ''}: {error.strerror}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\ntam570: interrupted", file=sys.stderr)
        return INTERRUPTED


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="tam570", description="Homework in intermediate dynamics.")
    parser.add_argument("--version", action="version", version=f"tam570 {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    command = commands.add_parser("list", help="the assignments, and how far you are with those here")
    command.set_defaults(command=_list)
    command.add_argument("--lectures", action="store_true", help="the systems that are solved in class, by date")

    command = commands.add_parser("start", help="get an assignment, or a copy of a lecture to play with")
    command.set_defaults(command=_start)
    command.add_argument("assignment", metavar="ASSIGNMENT|LECTURE", help="hw07, or top, for example")
    command.add_argument("--into", type=Path, default=Path(), metavar="DIR", help="where (default: here)")

    command = commands.add_parser("check", help="run the visible tests on what you have written")
    command.set_defaults(command=_check)
    command.add_argument("what", nargs="?", metavar="ASSIGNMENT|FILE", help="default: all that you have started here")
    command.add_argument("--assignment", metavar="SLUG", help="which one a FILE of another name is")
    command.add_argument("--watch", action="store_true", help="test what has changed each time you save")

    command = commands.add_parser("show", help="see what your functions do, or a lecture, as a scene that moves")
    command.set_defaults(command=_show)
    command.add_argument(
        "assignment", metavar="ASSIGNMENT|LECTURE", help="hw07, or top, for example, or a lecture's copy"
    )
    command.add_argument("file", nargs="?", type=Path, metavar="FILE", help="default: yours that is here")
    command.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="of a lecture: mass=2")
    command.add_argument("--save", type=Path, metavar="FILE", help="a page (.html), picture (.png), .gif or .mp4")

    command = commands.add_parser("hint", help="one more hint each time you ask")
    command.set_defaults(command=_hint)
    command.add_argument("assignment")
    command.add_argument("function", nargs="?", help="default: the functions that there are hints for")
    command.add_argument("--again", action="store_true", help="begin with the first hint again")
    return parser


def _list(arguments: argparse.Namespace) -> int:
    if arguments.lectures:
        return lectures.listed()
    points = most = 0.0
    for slug in assignments():
        work = _work(slug)
        known = recalled(work) if work else None
        print(f"{slug:<26} {title(slug):<44} {_state(work, known)}".rstrip())
        if known:
            points, most = points + known[0]["points"], most + known[0]["most"]
    if most:
        print(f"\n{points:g} of {most:g} points by the visible tests of what you have checked here")
    return 0


def _state(file: Path | None, known: tuple[dict[str, Any], bool] | None) -> str:
    """How far the work on one assignment is, by the tests as they were run last; nothing is run for it."""
    if known is None:
        return "started" if file else ""
    found, current = known
    ahead = f"next: {found['next']}" if found["next"] else "done"
    return f"{found['points']:g} of {found['most']:g}, {ahead}{'' if current else '; changed since: tam570 check'}"


def _start(arguments: argparse.Namespace) -> int:
    if lectures.is_lecture(arguments.assignment):
        return lectures.start(arguments.assignment, arguments.into)
    work, copied, kept = start(arguments.assignment, arguments.into)
    for name in copied:
        print(work / name)
    if kept:
        print(f"left as you have them: {', '.join(kept)}")
    print(f"Read {work / 'README.md'}, fill in {work / (work.name + '.py')}, and try: tam570 check {work.name[:4]}")
    return 0


def _check(arguments: argparse.Namespace) -> int:
    work = _chosen(arguments.what, arguments.assignment)
    if arguments.watch:
        from tam570.watching import watch

        return watch(work)
    from tam570.checking import check

    return max(check(file, slug) for file, slug in work)


def _chosen(what: str | None, assignment: str | None) -> list[tuple[Path, str]]:
    """The files that are meant, and their assignments."""
    if what is not None and (what.endswith(".py") or len(Path(what).parts) > 1):
        file = Path(what)
        if not file.is_file():
            raise Unknown(f"there is no file {what}")
        return [(file, folder(assignment or _named(file)).name)]
    slugs = [folder(what).name] if what else assignments()
    found = [(work, slug) for slug in slugs if (work := _work(slug))]
    if not found:
        state = f"{what} is not" if what else "nothing is"
        raise Unknown(f"{state} started here; begin with: tam570 start {what or 'hw01'}")
    return found


def _named(file: Path) -> str:
    """The name that tells the assignment: the file's, else its folder's."""
    name = file.stem
    return name if any(name.startswith(slug[:4]) for slug in assignments()) else file.resolve().parent.name


def _show(arguments: argparse.Namespace) -> int:
    if arguments.file is None and lectures.is_lecture(arguments.assignment):
        return lectures.show(arguments.assignment, arguments.set, arguments.save)
    from tam570.show import command

    slug = folder(arguments.assignment).name
    file = arguments.file or _work(slug)
    if file is None:
        raise Unknown(f"{slug} is not started here; begin with: tam570 start {slug[:4]}")
    if not file.is_file():
        raise Unknown(f"there is no file {file}")
    return command(file, slug, arguments.save)


def _hint(arguments: argparse.Namespace) -> int:
    import tomllib

    released = folder(arguments.assignment)
    hints: dict[str, list[str]] = tomllib.loads((released / "hints.toml").read_text(encoding="utf-8"))
    if arguments.function is None:
        print("\n".join(f"{name:<32} {len(steps)} hints" for name, steps in hints.items()))
        return 0
    if arguments.function not in hints:
        raise Unknown(f"no hints for {arguments.function!r}; there are hints for {', '.join(hints)}")
    steps = hints[arguments.function]
    given = 0 if arguments.again else hints_given(released.name, arguments.function)
    step = min(given, len(steps) - 1)
    print(f"{steps[step]}\n({step + 1} of {len(steps)}{'' if step + 1 < len(steps) else '; this is the last'})")
    remember_hints(released.name, arguments.function, step + 1)
    return 0


def _work(slug: str) -> Path | None:
    """The student's file here: in a folder of its own, or in the working directory."""
    return next((path for path in (Path(slug, f"{slug}.py"), Path(f"{slug}.py")) if path.exists()), None)


if __name__ == "__main__":
    sys.exit(main())
