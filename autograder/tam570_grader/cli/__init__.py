"""The instructor's command, `tam570-grader`."""

import argparse
import contextlib
import importlib
import os
import signal
import sys
from collections.abc import Callable

from tam570 import __version__
from tam570_grader.cli.options import add_root
from tam570_grader.errors import UsageError, say, warn
from tam570_grader.sandbox.launch import launched_early

__all__ = ["main"]

INTERRUPTED = 130
MODULES = {  # where each command is, in the order of the help
    "collect": "exchange",
    "grade": "grade",
    "watch": "watch",
    "points": "points",
    "mark": "manual_grading",
    "replay": "replay",
    "stubs": "release",
    "trust": "release",
    "kit": "release",
    "course": "release",
    "gradescope": "release",
    "export": "exchange",
    "alike": "exchange",
    "lms": "exchange",
    "report": "exchange",
    "audit": "audit",
    "certificates": "certificates",
}


def main(argv: list[str] | None = None) -> int:
    """Run the command; the exit code is 0 (done), 1 (the grader failed), 2 (bad usage) or 130 (interrupted)."""
    argv = sys.argv[1:] if argv is None else argv
    grades_here = "grade" in argv and not any(option.startswith("--cl") for option in argv)
    with launched_early() if grades_here else contextlib.nullcontext():
        return _run(argv)


def _run(argv: list[str]) -> int:
    arguments = _parser(argv).parse_args(argv)
    command: Callable[[argparse.Namespace], int] = arguments.command
    with contextlib.suppress(ValueError):  # not the main thread
        signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        return command(arguments)
    except KeyboardInterrupt as ended:
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # a second one ends what is still being put away
        say("", error=True)
        warn("; ".join(["interrupted", *map(str, ended.args)]), "")
        return INTERRUPTED
    except BrokenPipeError:
        # the reader has gone; nothing more to say
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except UsageError as error:
        warn(str(error), "error: ")
        return 2
    except OSError as error:
        warn(str(error), "error: ")
        return 1


def _parser(argv: list[str]) -> argparse.ArgumentParser:
    """Return a parser of the commands that are named, for each takes time to import, or of all."""
    parser = argparse.ArgumentParser(prog="tam570-grader", description="Grade the assignments of the course.")
    parser.add_argument("--version", action="version", version=f"tam570-grader {__version__}")
    add_root(parser, None)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    for name in [name for name in MODULES if name in argv] or MODULES:
        getattr(importlib.import_module(f"tam570_grader.cli.{MODULES[name]}"), f"add_{name}")(commands)
    completion = commands.add_parser("completion", help="print a script that completes commands in your shell")
    completion.add_argument("shell", choices=["bash", "zsh", "tcsh"])
    completion.set_defaults(command=lambda arguments: _complete(parser, arguments.shell))
    return parser


def _complete(parser: argparse.ArgumentParser, shell: str) -> int:
    import shtab

    sys.stdout.write(f"{shtab.complete(parser, shell)}\n")  # its tabs stay
    return 0


if __name__ == "__main__":
    sys.exit(main())
