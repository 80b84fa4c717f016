"""A case: the arguments of one call, and what the student is told about them."""

import functools
from dataclasses import dataclass

import numpy as np

from tam570.values import Numbers
from tam570_grader.protocol.wire import packed


class Case:
    """The arguments of one call, with a label: the kind of input, in words that give no input away.

        Case(0.3, mass=2.0).labelled("a small angle", hint="For small angles sin th is th.")

    Cases are equal if their arguments, labels and hints are. They are not changed after construction.
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
        """The packed arguments, as they are sent; cached, because students share cases."""
        return packed([[*map(_sent, self.args)], {key: _sent(value) for key, value in self.kwargs.items()}])

    @property
    def points(self) -> list[dict[str, float]]:
        """The points {symbol: number} at which the call evaluates a formula; empty for any other call."""
        (first, *_) = self.args or [None]
        return first if isinstance(first, list) and first and isinstance(first[0], dict) else []

    def labelled(self, label: str, hint: str = "") -> "Case":
        """Return a copy with a label, and with a hint that `compare` prefers to that of the check."""
        case = Case(*self.args, **self.kwargs)
        case.label, case.hint = label, hint
        return case

    def replace(self, *args: Numbers, **kwargs: Numbers) -> "Case":
        """Return a copy with other leading arguments, or other parameters."""
        changed = Case(*args, *self.args[len(args) :], **{**self.kwargs, **kwargs})
        return changed.labelled(self.label, self.hint)

    def with_leading(self, *args: Numbers) -> "Case":
        """Return a copy with additional leading arguments."""
        return Case(*args, *self.args, **self.kwargs).labelled(self.label, self.hint)


@dataclass(frozen=True)
class Call:
    """A call that a check made, and its result."""

    name: str
    case: Case
    result: Numbers  # None if the call raised, or the result does not have the promised form


def _sent(value: Numbers) -> Numbers:
    """Return an argument as it is sent: any sequence of numbers as a float64 array, as the contract promises."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.astype(float)
    if isinstance(value, list | tuple) and value:
        if all(isinstance(item, int | float | np.number) for item in value):
            return np.array(value, float)
        return [_sent(item) for item in value]
    return list(value) if isinstance(value, tuple) else value
