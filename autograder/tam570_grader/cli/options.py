"""Types and options that several commands share."""

import argparse
from pathlib import Path

from tam570.values import Function


def natural(text: str) -> int:
    """Return the whole number in a text, at least 0."""
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 0 on")
    return int(text)


def positive(text: str) -> int:
    """Return the whole number in a text, at least 1."""
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 1 on")
    return int(text)


def add_cluster(add: Function) -> None:
    """Add the options of commands that can run on a cluster."""
    cluster = "hand the work to Dask: the address tls://HOST:PORT of a scheduler, or `local` for --jobs workers here"
    add("--cluster", metavar="ADDRESS", help=cluster)
    certificates = "the cluster's certificates, made by `tam570-grader certificates`"
    add("--certificates", type=Path, metavar="DIR", help=certificates)
    unconfined = "let workers of the cluster without bubblewrap grade too; each result records how it was isolated"
    add("--unconfined", action="store_true", help=unconfined)
