"""The students' command, `tam570`. Each command imports only what it needs: `list` loads no numerical library."""

import argparse
import io
import os
import shutil
import sys
import textwrap
import tomllib
from collections.abc import Callable, Sequence
from difflib import get_close_matches
from pathlib import Path

from tam570 import __version__, releases, work
from tam570.course import Unknown, assignments, contract, folder, title
from tam570.handin import HOW, before_handing_in, hand_in
from tam570.lectures import catalogue, is_lecture
from tam570.predictions import ask_for_predictions
from tam570.progress import hints_given, recalled, remember_hints
from tam570.signals import end_as_by_ctrl_c
from tam570.values import Json

INTERRUPTED = 130  # 128 + SIGINT, as shells report it


def main(argv: list[str] | None = None) -> int:
    """Run the command and return its exit code: 0, 1 (a test failed), 2 (bad usage) or 130 (interrupted)."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # print "?" for a character that it cannot encode
            stream.reconfigure(errors="replace")
    parser = _parser()
    try:
        _must_be_a_command(parser, (sys.argv[1:] if argv is None else argv)[:1])
        arguments = parser.parse_args(argv)
        end_as_by_ctrl_c()
        command: Callable[[argparse.Namespace], int] = arguments.command
        return command(arguments)
    except Unknown as error:
        print(_fitted(f"tam570: error: {error}"), file=sys.stderr)
        return 2
    except BrokenPipeError:  # the reader of a pipe has closed it, as `head` does
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        where = error.filename2 or error.filename or "this folder"
        print(f"tam570: error: {where}: {error.strerror}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\ntam570: interrupted", file=sys.stderr)
        return INTERRUPTED


def _fitted(text: str) -> str:
    """Wrap a message to lines of at most 80 characters, without breaking paths and names."""
    lines = text.splitlines()
    return "\n".join(textwrap.fill(line, 80, break_long_words=False, break_on_hyphens=False) for line in lines)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="tam570",
        description="Homework in intermediate dynamics.",
        epilog="Name an assignment by any unambiguous part: hw07, 7, double_pendulum.",
    )
    parser.add_argument("--version", action="version", version=f"tam570 {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    command = commands.add_parser("list", help="list all assignments and your progress")
    command.set_defaults(command=_list)
    command.add_argument("--lectures", action="store_true", help="list the systems shown in class, by date")

    command = commands.add_parser("start", help="get an assignment, or a copy of a lecture to play with")
    command.set_defaults(command=_start)
    command.add_argument("assignment", metavar="ASSIGNMENT|LECTURE", help="hw07, or top, for example")
    command.add_argument("--into", type=Path, metavar="DIR", help="where (default: here)")
    command.add_argument("--notebook", action="store_true", help="a notebook too")

    command = commands.add_parser("check", help="run the visible tests on what you have written")
    command.set_defaults(command=_check)
    command.add_argument("what", nargs="?", metavar="ASSIGNMENT|FILE", help="default: all that you have started here")
    command.add_argument("functions", nargs="*", metavar="FUNCTION", help="test only these functions")
    command.add_argument("--assignment", metavar="NAME", help="the assignment, if FILE has another name")
    command.add_argument("--watch", action="store_true", help="test what has changed each time you save")
    command.add_argument("--final", action="store_true", help="before you hand in: what the hidden tests look at")

    command = commands.add_parser("show", help="see what your functions do, or a lecture, as a scene that moves")
    command.set_defaults(command=_show)
    command.add_argument("what", nargs="?", metavar="ASSIGNMENT|LECTURE|FILE", help="default: the one in this folder")
    command.add_argument("file", nargs="?", type=Path, metavar="FILE", help="default: the file in this folder")
    command.add_argument("--assignment", metavar="NAME", help="the assignment, if FILE has another name")
    command.add_argument(
        "--set", action="append", default=[], metavar="NAME=VALUE", help="set a parameter, such as mass=2"
    )
    command.add_argument("--save", type=Path, metavar="FILE", help="a page (.html), a .png, .gif, .webp or .mp4")

    command = commands.add_parser("handin", help="pack what you hand in: code, notebook, plots, written parts")
    command.set_defaults(command=_handin)
    command.add_argument("what", nargs="?", metavar="ASSIGNMENT|FILE", help="default: the one in this folder")

    command = commands.add_parser("hint", help="one more hint each time you ask")
    command.set_defaults(command=_hint)
    command.add_argument("assignment", nargs="?", help="default: the one in this folder")
    command.add_argument("function", nargs="?", help="default: the functions that there are hints for")
    command.add_argument("--again", dest="restart", action="store_true", help="begin with the first hint again")
    command.add_argument("--all", action="store_true", help="all hints for the function")

    command = commands.add_parser("update", help="bring the problem and the tests up to this kit")
    command.set_defaults(command=_update)
    command.add_argument("assignment", nargs="?", help="default: all that you have started here")

    command = commands.add_parser("completion", help="a script that completes commands in your shell")
    command.set_defaults(command=_completion)
    command.add_argument("shell", choices=["bash", "zsh", "tcsh"])

    return parser


def _must_be_a_command(parser: argparse.ArgumentParser, words: Sequence[str]) -> None:
    """Raise Unknown, with the closest command, if the first word is neither a command nor an option."""
    (action,) = (action for action in parser._actions if isinstance(action, argparse._SubParsersAction))
    if words and not words[0].startswith("-") and words[0] not in action.choices:
        close = "".join(f"; did you mean {word}?" for word in get_close_matches(words[0], action.choices, 1))
        raise Unknown(f"there is no command {words[0]!r}{close or '; there are ' + ', '.join(action.choices)}")


def _list(arguments: argparse.Namespace) -> int:
    if arguments.lectures:
        for lecture in catalogue().values():
            print(f"{lecture.date:<15} {lecture.name:<18} {lecture.title}")
        return 0
    points = most = 0.0
    for slug in assignments():
        file = work.work_of(slug)
        recalled_progress = recalled(file) if file else None
        print(f"{slug:<26} {_state(file, recalled_progress) or title(slug)}")
        if recalled_progress:
            points, most = points + recalled_progress[0]["points"], most + recalled_progress[0]["most"]
    if most:
        print(f"\n{points:g} of {most:g} points by the visible tests of what you have checked here")
    return 0


def _state(file: Path | None, recalled_progress: tuple[Json, bool] | None) -> str:
    """Describe the progress on an assignment by the last run of its tests; run no tests."""
    if recalled_progress is None:
        return "started" if file else ""
    progress, is_current = recalled_progress
    ahead = f"next: {progress['next']}" if progress["next"] else "done"
    return f"{progress['points']:g} of {progress['most']:g}, {ahead}" if is_current else "changed since you checked it"


def _start(arguments: argparse.Namespace) -> int:
    where = arguments.into or work.beside()
    if arguments.assignment in catalogue():
        return _start_lecture(catalogue()[arguments.assignment].file, where)
    copied = releases.start(arguments.assignment, where, notebook=arguments.notebook)
    for name in copied.new:
        print(copied.work / name)
    if not copied.new:
        print(f"{copied.work} is there already and stays as it is")
    _differing(copied)
    slug = copied.work.name
    if arguments.notebook and not (copied.work / f"{slug}.ipynb").exists():
        print("there is no notebook of it here; the kit of your course has one", file=sys.stderr)
    print(f"Read {copied.work / 'README.md'}, fill in {copied.work / f'{slug}.py'},")
    print(f"and try: tam570 check {slug[:4]}")
    print(_fitted(HOW.format(name=slug[:4])))
    return 0


def _start_lecture(source: Path, where: Path) -> int:
    """Copy a lecture's module to `where` for the student to change; keep an existing copy."""
    copy = where / source.name
    if copy.exists():
        print(f"{copy} is there already and stays as it is; see it with: tam570 show {copy}")
        return 0
    where.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, copy)
    print(f"{copy}\nChange it as you like and see what it does: tam570 show {copy}")
    return 0


def _differing(copied: releases.Copied) -> None:
    for name in copied.differing:
        print(f"{name} is not as this kit has it: yours is older, or you have changed it.")
        print(f"    To get this kit's, move {copied.work / name} away, then: tam570 update {copied.work.name[:4]}")


def _update(arguments: argparse.Namespace) -> int:
    for file, slug in work.chosen(arguments.assignment):
        copied = releases.update(file.parent, slug)
        changed = [*copied.new, *copied.refreshed]
        print(f"{slug[:4]}: {'now as this kit has them: ' + ', '.join(changed) if changed else 'up to date'}")
        _differing(copied)
        for signature in copied.signatures:
            print(f"    this kit asks for {signature}")
    return 0


def _check(arguments: argparse.Namespace) -> int:
    files = work.chosen(arguments.what, arguments.assignment)
    from tam570 import checking

    if arguments.watch:
        return checking.watch(files)
    for function in arguments.functions:
        if not any(function in contract(slug)["results"] for _, slug in files):
            names = ", ".join(name for _, slug in files for name in contract(slug)["results"])
            raise Unknown(f"there is no function {function!r} to write; there are {names}")
    code = checking.check(files, arguments.functions)
    if arguments.final:
        for file, slug in files:
            before_handing_in(file, slug)
    return code


def _handin(arguments: argparse.Namespace) -> int:
    hand_in(*work.single(arguments.what))
    return 0


def _show(arguments: argparse.Namespace) -> int:
    from tam570.show import load_student, present, scene_of
    from tam570.show.lecture import filmed, lecture_module, settings

    what = arguments.what
    if what and arguments.file is None and is_lecture(what):
        return present(lambda: filmed(lecture_module(what), settings(arguments.set)), arguments.save, Path(what).stem)
    if arguments.file:
        file, slug = arguments.file, folder(arguments.assignment or what, or_lecture=True).name
        if not file.is_file():
            raise Unknown(f"there is no file {file}")
    else:
        file, slug = work.single(what, arguments.assignment)
    notes = ask_for_predictions(file.parent, slug)
    return present(
        lambda: scene_of(load_student(file, slug), slug, settings(arguments.set)), arguments.save, slug, notes
    )


def _hint(arguments: argparse.Namespace) -> int:
    released, function = _hinted(arguments.assignment, arguments.function)
    hints: dict[str, list[str]] = tomllib.loads((released / "hints.toml").read_text(encoding="utf-8"))
    if function is None:
        print("\n".join(f"{name:<32} {len(steps)} hints" for name, steps in hints.items()))
        print(f"One of them: tam570 hint {released.name[:4]} {next(iter(hints))}")
        return 0
    if function not in hints:
        raise Unknown(f"no hints for {function!r}; there are hints for {', '.join(hints)}")
    steps = hints[function]
    seen = 0 if arguments.restart else hints_given(released.name, function)
    step = len(steps) - 1 if arguments.all else min(seen, len(steps) - 1)
    for number in range(0 if arguments.all else step, step + 1):
        print(textwrap.fill(steps[number], 80))
        print(f"({number + 1} of {len(steps)}{'' if number + 1 < len(steps) else '; this is the last'})")
    if not remember_hints(released.name, function, step + 1) and step + 1 < len(steps):
        print("Which hints you have seen cannot be kept here: --all shows all of them.")
    return 0


def _hinted(assignment: str | None, function: str | None) -> tuple[Path, str | None]:
    """Return an assignment's folder and the function to hint at; a single word may name a function of the work here."""
    if assignment is None:
        return folder(work.single(None)[1]), None
    try:
        return folder(assignment), function
    except Unknown:
        file, slug = next(iter(work.here()), (None, ""))
        if function or file is None or assignment not in contract(slug)["results"]:
            raise
        return folder(slug), assignment


def _completion(arguments: argparse.Namespace) -> int:
    import shtab

    parser = _parser()
    # argparse has no public access to subparsers
    choices = [action.choices for action in parser._actions if isinstance(action.choices, dict)]
    commands = [command for several in choices for command in several.values()]
    for action in (action for command in commands for action in command._actions):
        if action.dest in ("what", "assignment"):
            action.choices = assignments()
    print(shtab.complete(parser, arguments.shell))
    return 0


if __name__ == "__main__":
    sys.exit(main())
