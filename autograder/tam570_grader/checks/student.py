"""The student's functions as checks see them; each call is made in the sandbox."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tam570.values import Numbers
from tam570_grader.checks.case import Case


class StudentFunction(Protocol):
    """A student's function of the contract."""

    @property
    def name(self) -> str: ...
    @property
    def returns(self) -> Any: ...  # its specification in `Assignment.returns`
    @property
    def student(self) -> Any: ...  # has the other functions as attributes

    def __call__(self, *args: Numbers, **kwargs: Numbers) -> Numbers: ...

    def each(self, calls: Iterable[Case]) -> Iterator[tuple[Case, Numbers]]: ...

    def ahead(self, calls: Sequence[Case]) -> "StudentFunction": ...

    def many(self, calls: Sequence[Case]) -> list[Numbers]: ...

    def aside(self, call: Case) -> Numbers: ...

    def uses(self, helper: str, call: Case) -> bool: ...

    def scaled(self, helper: str, index: int, factor: float, call: Case) -> Numbers: ...

    def refusals(self, calls: Iterable[Case]) -> Iterator[tuple[Case, bool]]: ...

    def at(self, points: Sequence[Mapping[str, float]]) -> NDArray[np.float64]: ...
