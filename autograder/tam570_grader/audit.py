"""The command that grades the grader: `tam570-grader audit`."""

import argparse
import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

__all__ = ["add_audit"]

Commands = Any  # argparse keeps the name of its subparsers' type to itself


def add_audit(
    commands: Commands, run: Callable[[argparse.Namespace], int], cores: int
) -> argparse.ArgumentParser:
    audit: argparse.ArgumentParser = commands.add_parser(
        "audit",
        help="grade the grader: does it catch what it must?",
        description="Run mutants of the reference solutions, one slip each, through the grader.",
        epilog="The exit code is 1 if a mutant survives that is not listed as equivalent, or one is listed in vain.",
    )
    audit.set_defaults(command=run)
    add = audit.add_argument
    add("assignments", nargs="*", metavar="SLUG", help="default: all")
    add("--quick", action="store_true", help="a small fixed sample")
    add("--json", action="store_true", help="print a JSON object for each assignment, one a line")
    add("--function", nargs="+", metavar="NAME", default=[], help="mutants of these functions alone")
    add("--jobs", type=_positive, metavar="N", default=cores, help="processes (default: %(default)s)")
    return audit


def _positive(text: str) -> int:
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 1 on")
    return int(text)


def run(course: Path, slugs: Sequence[str], arguments: argparse.Namespace) -> int:
    """Print what is asked for, an assignment at a time; 1 if there is a fault."""
    from tam570_grader import mutation

    faults = 0
    for slug in slugs:
        found = mutation.fates(course, slug, arguments.jobs, arguments.quick, arguments.function)
        lines = [json.dumps(mutation.as_json(found))] if arguments.json else mutation.report(found)
        print(*lines, sep="\n", flush=True)
        faults += found.faults
    return 1 if faults else 0
