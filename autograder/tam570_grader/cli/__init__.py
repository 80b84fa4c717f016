"""The instructor's command, `tam570-grader`."""

import argparse
import atexit
import gc
import importlib
import os
import signal
import sys
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NoReturn

from tam570 import __version__
from tam570.signals import end_as_by_ctrl_c
from tam570_grader.errors import UsageError, say, warn, with_remedy
from tam570_grader.sandbox.launch import close_early, launch_early

INTERRUPTED = 130
COMMANDS = {  # the module and the help of each command, in the order of the help
    "collect": ("exchange", "collect what was downloaded from a learning management system"),
    "grade": ("grade", "grade submissions"),
    "watch": ("watch", "grade submissions when they arrive"),
    "points": ("points", "add points by hand, late days and changes to results"),
    "mark": ("manual_grading", "open a page to grade parts by hand"),
    "replay": ("replay", "show the input, the expected and the actual value of a failed check"),
    "stubs": ("release", "make the students' stubs from the solutions"),
    "trust": ("release", "use this course from now on, in its folder and below"),
    "kit": ("release", "make what students install and start from"),
    "course": ("release", "make a course that nbgrader runs"),
    "gradescope": ("release", "make the archives that Gradescope runs"),
    "export": ("exchange", "lay submissions out for Dolos, JPlag or Moss, with names hidden"),
    "alike": ("exchange", "list pairs of submissions that share code"),
    "lms": ("exchange", "make a table that a learning management system imports"),
    "report": ("exchange", "make one page on the class"),
    "audit": ("audit", "grade the grader: does it catch what it must?"),
    "certificates": ("certificates", "make the certificates of a cluster"),
}


def main(argv: list[str] | None = None) -> int:
    """Run a command; return the exit code: 0 (done), 1 (the grader failed), 2 (bad usage) or 130 (interrupted)."""
    try:
        arguments = _parser().parse_args(argv)
        end_as_by_ctrl_c()
        command: Callable[[argparse.Namespace], int] = arguments.command
        return command(arguments)
    except KeyboardInterrupt as ended:
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # a second Ctrl-C also ends the cleanup
        say("", error=True)
        warn("; ".join(["interrupted", *map(str, ended.args)]), "")
        return INTERRUPTED
    except BrokenPipeError:
        # the reader of stdout has ended
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except UsageError as error:
        warn(str(error), "error: ")
        return 2
    except OSError as error:
        warn(with_remedy(error), "error: ")
        return 1
    finally:
        close_early()


def run() -> NoReturn:
    """Run the command, and end without freeing each object: the system frees all at once."""
    code = main()
    atexit._run_exitfuncs()
    os._exit(code)


class _Command(argparse.ArgumentParser):
    """A command that imports its module and adds its options only when it is used, by `load`, as imports take time."""

    load: Callable[[], None] | None
    grades = False  # the command launches a sandbox, which starts during the imports

    def parse_known_args(self, *args: Any, **kwargs: Any) -> Any:
        if self.load is None:
            return super().parse_known_args(*args, **kwargs)
        if self.grades:
            gc.set_threshold(100_000)  # modules and records have no reference cycles
            launch_early()
        load, self.load = self.load, None
        load()
        return self.parse_known_intermixed_args(*args, **kwargs)  # paths before, between and after options


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="tam570-grader", description="Grade the assignments of the course.")
    parser.add_argument("--version", action="version", version=f"tam570-grader {__version__}")
    _add_root(parser, None)
    commands = parser.add_subparsers(required=True, metavar="COMMAND", parser_class=_Command)
    for name, (module, text) in COMMANDS.items():
        command = commands.add_parser(name, help=text, description=f"{text[0].upper()}{text[1:]}.")
        command.load = partial(_load, command, module, name)
        command.grades = name == "grade"
    completion = commands.add_parser("completion", help="print a script that completes commands in your shell")
    completion.load = lambda: None
    completion.add_argument("shell", choices=["bash", "zsh", "tcsh"])
    completion.set_defaults(command=lambda arguments: _complete(parser, commands.choices, arguments.shell))
    return parser


def _load(command: argparse.ArgumentParser, module: str, name: str) -> None:
    getattr(importlib.import_module(f"tam570_grader.cli.{module}"), f"add_{name}")(command)
    _add_root(command, argparse.SUPPRESS)


def _add_root(parser: argparse.ArgumentParser, default: str | None) -> None:
    """Add the option --root, which is allowed before and after the command."""
    where = "the course (default: $TAM570_COURSE, the trusted course you are in, the one that is installed)"
    parser.add_argument("--root", metavar="DIR", default=default, help=where)


def _complete(parser: argparse.ArgumentParser, commands: Mapping[str, _Command], shell: str) -> int:
    import shtab

    for command in commands.values():
        if command.load:
            command.load()
    sys.stdout.write(f"{shtab.complete(parser, shell)}\n")  # not by `say`, which escapes tabs
    sys.stdout.flush()
    return 0
