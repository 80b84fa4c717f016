"""Whether compiled code repays. The work is counted and no clock is read: the same call gives the same answer."""

import importlib.util
import os

__all__ = ["PROBE", "Estimate", "WorthCompiling", "available", "repays"]

PROBE = 50  # steps in Python before the rest is estimated for the first time
# On a machine of 2024, median of the public problems of `benchmarks`, s; another machine has about the same ratios:
IN_PYTHON, BESIDE = 3e-8, 12.0  # an operation of the right-hand side, at a stage; a stage costs so many more
A_MODULE, AN_OPERATION = 0.15, 0.0012  # to import llvmlite and to compile
FIRST_OF = 3.0  # calls: compiled code is kept on disk, for the next one and the next process


class WorthCompiling(Exception):
    """The rest of the run takes longer in Python than the whole of it does compiled."""


class Estimate:
    """Counts the steps of a run in Python, and estimates the rest after 50, 100, 200, ... of them.

    Parameters
    ----------
    begin, end : float
        Of the run, s.
    operations : int
        Of the right-hand side.
    """

    def __init__(self, begin: float, end: float, operations: int) -> None:
        self.begin, self.end, self.operations = begin, end, operations
        self.steps, self.due = 0, PROBE

    def add(self, steps: int, t: float) -> None:
        """Count steps up to the time t. Raises WorthCompiling."""
        self.steps += steps
        if self.steps < self.due or t >= self.end:
            return
        self.due *= 2
        done = (t - self.begin) / (self.end - self.begin)
        if done and repays(self.steps * (1 / done - 1), self.operations):
            raise WorthCompiling


def repays(steps: float, operations: int) -> bool:
    """Return whether so many steps of order 8 take longer in Python than compiling does, for one of some calls."""
    in_python = IN_PYTHON * 12 * steps * (operations + BESIDE)
    return in_python * FIRST_OF > A_MODULE + AN_OPERATION * operations and available()


def available() -> bool:
    """Return whether llvmlite is installed, and not forbidden by TAM570_COMPILED=0; it is not imported for that."""
    return os.environ.get("TAM570_COMPILED") != "0" and importlib.util.find_spec("llvmlite") is not None
