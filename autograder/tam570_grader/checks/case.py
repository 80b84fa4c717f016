"""A case: the arguments of one call, and what the student is told of them."""

import functools
from dataclasses import dataclass

import numpy as np

from tam570.values import Numbers
from tam570_grader.protocol.wire import packed


class Case:
    """The arguments of one call, with a label: the kind of input, in words that give no input away.

        Case(0.3, mass=2.0).labelled("a small angle", hint="For small angles sin th is th.")

    Equal if arguments, label and hint are. Not changed once it is made.
    """

    def __init__(self, /, *args: Numbers, **kwargs: Numbers) -> None:
        self.args, self.kwargs, self.label, self.hint = args, kwargs, "", ""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and self._fields() == other._fields()

    def __repr__(self) -> str:
        arguments = ", ".join([*map(repr, self.args), *(f"{name}={value!r}" for name, value in self.kwargs.items())])
        return f"Case({arguments})" + (f".labelled({self.label!r})" if self.label else "")

    def _fields(self) -> tuple[Numbers, ...]:
        return self.args, self.kwargs, self.label, self.hint

    @functools.cached_property
    def packed(self) -> bytes:
        """The arguments as they are sent: packed once for a class that shares them."""
        return packed([[*map(_sent, self.args)], {key: _sent(value) for key, value in self.kwargs.items()}])

    @property
    def points(self) -> list[dict[str, float]]:
        """The numbers for its symbols at which a formula is evaluated; none of another call."""
        (first, *_) = self.args or [None]
        return first if isinstance(first, list) and first and isinstance(first[0], dict) else []

    def labelled(self, label: str, hint: str = "") -> "Case":
        """Return the same arguments with a label, and with a hint that `compare` prefers to that of the check."""
        case = Case(*self.args, **self.kwargs)
        case.label, case.hint = label, hint
        return case

    def replace(self, *args: Numbers, **kwargs: Numbers) -> "Case":
        """Return the same call with other leading arguments, or other parameters."""
        changed = Case(*args, *self.args[len(args) :], **{**self.kwargs, **kwargs})
        return changed.labelled(self.label, self.hint)

    def with_leading(self, *args: Numbers) -> "Case":
        """Return the same call with more arguments before its own."""
        return Case(*args, *self.args, **self.kwargs).labelled(self.label, self.hint)


@dataclass(frozen=True)
class Call:
    """A call that a check made, and the result that came back."""

    name: str
    case: Case
    result: Numbers  # None where the call raised, or returned what was not promised


def _sent(value: Numbers) -> Numbers:
    """Return an argument as it is sent: any sequence of numbers is a float64 array, as the contract promises."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.astype(float)
    if isinstance(value, list | tuple) and value:
        if all(isinstance(item, int | float | np.number) for item in value):
            return np.array(value, float)
        return [_sent(item) for item in value]
    return list(value) if isinstance(value, tuple) else value
