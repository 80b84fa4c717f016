"""The record at the end of a module of checks: return values, names that are off limits, modules to import."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from tam570_grader.checks.returns import ReturnSpec

EVERYWHERE = "*"  # key of `forbidden` that applies to all functions


@dataclass(frozen=True, kw_only=True)
class Assignment:
    """Settings of an assignment, stated in its module of checks; required fields, so that a typo cannot lift a ban.

    Parameters
    ----------
    returns : {function: its ReturnSpec}, for all functions that students write
    forbidden : {function, or "*" for all: names of modules and functions that are off limits in it}
    needs : modules that the sandbox imports before it loads a submission
    states : numbers of components of the states that submissions integrate; the sandbox compiles a step for each first

    Raises
    ------
    ValueError
        If `forbidden` has a function that `returns` lacks, or a string in place of a tuple of names.
    """

    returns: Mapping[str, ReturnSpec]
    forbidden: Mapping[str, Sequence[str]]
    needs: Sequence[str]
    states: Sequence[int] = ()

    def __post_init__(self) -> None:
        if unknown := sorted(self.forbidden.keys() - self.returns.keys() - {EVERYWHERE}):
            raise ValueError(f"forbidden names {unknown[0]!r}, which is no function of the assignment")
        texts = [names for names in (self.needs, *self.forbidden.values()) if isinstance(names, str)]
        if texts:
            raise ValueError(f"{texts[0]!r} must be a tuple of names")
