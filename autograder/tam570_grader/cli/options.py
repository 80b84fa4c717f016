"""Types and options that several commands share."""

import argparse
from functools import partial
from pathlib import Path

from tam570.values import Function


def natural(text: str, least: int = 0) -> int:
    """Return the whole number in a text, at least `least`."""
    if not text.isdecimal() or int(text) < least:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from {least} on")
    return int(text)


positive = partial(natural, least=1)


def add_cluster(add: Function) -> None:
    """Add the options of commands that can run on a cluster."""
    cluster = "hand the work to Dask: the address tls://HOST:PORT of a scheduler, or `local` for --jobs workers here"
    add("--cluster", metavar="ADDRESS", help=cluster)
    certificates = "the cluster's certificates, made by `tam570-grader certificates`"
    add("--certificates", type=Path, metavar="DIR", help=certificates)
    unconfined = "let workers of the cluster without bubblewrap grade too; each result records how it was isolated"
    add("--unconfined", action="store_true", help=unconfined)
