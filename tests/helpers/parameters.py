"""Parameters of tests: the slugs of all assignments, and marks for the cases that `make test` leaves out."""

from pathlib import Path

import pytest

SLUGS = sorted(path.stem for path in (Path(__file__).parents[2] / "solutions").glob("hw*.py"))


def first(n, cases):
    """Return the cases for `parametrize`; those after the first n are slow."""
    values = [case if isinstance(case, tuple) else (case,) for case in cases]
    return [*list(cases)[:n], *(pytest.param(*each, marks=pytest.mark.slow) for each in values[n:])]
