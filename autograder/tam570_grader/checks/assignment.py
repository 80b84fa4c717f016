"""The record in which a module of checks ends: what its functions return, what they must not use, what they need."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from tam570_grader.checks.returns import ReturnSpec

EVERYWHERE = "*"  # in `forbidden`: not only in one function


@dataclass(frozen=True, kw_only=True)
class Assignment:
    """What a module of checks states about its assignment; each field is needed, so that no typo lifts a ban.

    Parameters
    ----------
    returns : {function: what it returns}, of all functions that students write
    forbidden : {function, or "*" for all: names of modules and functions that it must not use}
    needs : modules that the sandbox imports before it loads a submission
    states : numbers of components of the states that submissions integrate, for which it compiles a step before

    Raises
    ------
    ValueError
        If `forbidden` names a function that `returns` does not, or holds a text where a tuple belongs.
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
