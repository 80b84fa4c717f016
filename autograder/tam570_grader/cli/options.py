"""What the commands' options have in common."""

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tam570.values import Function

Commands = Any  # argparse keeps the name of its subparsers' type to itself


def add_root(parser: argparse.ArgumentParser, default: str | None) -> None:
    """Add the option --root: before the command and after it."""
    where = "the course (default: $TAM570_COURSE, the trusted course you are in, the one that is installed)"
    parser.add_argument("--root", metavar="DIR", default=default, help=where)


def add_command(
    commands: Commands, name: str, command: Callable[[argparse.Namespace], int], **words: str
) -> argparse.ArgumentParser:
    """Add a command.

    words : `help`, `description` and `epilog`; without a description the help is one
    """
    text = words["help"]
    words.setdefault("description", f"{text[0].upper()}{text[1:]}.")
    parser: argparse.ArgumentParser = commands.add_parser(name, **words)
    parser.set_defaults(command=command)
    add_root(parser, argparse.SUPPRESS)
    return parser


def natural(text: str) -> int:
    """Return a whole number from 0 on."""
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 0 on")
    return int(text)


def positive(text: str) -> int:
    """Return a whole number from 1 on."""
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 1 on")
    return int(text)


def add_cluster(add: Function) -> None:
    """Add the options of what may run on other machines."""
    add(
        "--cluster",
        metavar="ADDRESS",
        help="hand the work to Dask: the address tls://HOST:PORT of a scheduler, or `local` for --jobs workers here",
    )
    add("--certificates", type=Path, metavar="DIR", help="of the cluster, as `tam570-grader certificates` made them")
    add(
        "--unconfined",
        action="store_true",
        help="let workers of the cluster without bubblewrap grade too; each result says how it was kept apart",
    )
