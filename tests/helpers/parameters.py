"""Parameters of tests: the assignments, and which cases `make test` runs."""

from pathlib import Path

import pytest

SLUGS = sorted(path.stem for path in (Path(__file__).parents[2] / "solutions").glob("hw*.py"))


def first(n, cases):
    """Return the cases for `parametrize`; those after the first n are slow."""
    marked = [pytest.param(*_values(case), marks=pytest.mark.slow) for case in list(cases)[n:]]
    return [*list(cases)[:n], *marked]


def _values(case):
    return case if isinstance(case, tuple) else (case,)
