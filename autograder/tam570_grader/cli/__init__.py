"""The instructor's command, `tam570-grader`."""

import argparse
import contextlib
import os
import signal
import sys
from collections.abc import Callable

from tam570 import __version__
from tam570_grader.cli.audit import add_audit
from tam570_grader.cli.certificates import add_certificates
from tam570_grader.cli.exchange import add_alike, add_collect, add_export, add_lms, add_report
from tam570_grader.cli.grade import add_grade
from tam570_grader.cli.manual_grading import add_mark
from tam570_grader.cli.options import add_root
from tam570_grader.cli.points import add_points
from tam570_grader.cli.release import add_course, add_gradescope, add_kit, add_stubs, add_trust
from tam570_grader.cli.replay import add_replay
from tam570_grader.cli.watch import add_watch
from tam570_grader.errors import UsageError, say, warn

__all__ = ["main"]

INTERRUPTED = 130
COMMANDS = (
    add_collect,
    add_grade,
    add_watch,
    add_points,
    add_mark,
    add_replay,
    add_stubs,
    add_trust,
    add_kit,
    add_course,
    add_gradescope,
    add_export,
    add_alike,
    add_lms,
    add_report,
    add_audit,
    add_certificates,
)


def main(argv: list[str] | None = None) -> int:
    """Run the command; the exit code is 0 (done), 1 (the grader failed), 2 (bad usage) or 130 (interrupted)."""
    arguments = _parser().parse_args(argv)
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


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="tam570-grader", description="Grade the assignments of the course.")
    parser.add_argument("--version", action="version", version=f"tam570-grader {__version__}")
    add_root(parser, None)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    for add in COMMANDS:
        add(commands)
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
