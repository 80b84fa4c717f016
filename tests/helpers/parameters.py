"""Parameters of tests: the assignments, and which cases `make test` runs."""

import pytest

from tam570_grader.checks import assignments

__all__ = ["SLUGS", "first"]

SLUGS = assignments.slugs(assignments.find())


def first(n, cases):
    """Return the cases for `parametrize`; those after the first n are slow."""
    marked = [pytest.param(*_values(case), marks=pytest.mark.slow) for case in list(cases)[n:]]
    return [*list(cases)[:n], *marked]


def _values(case):
    return case if isinstance(case, tuple) else (case,)
