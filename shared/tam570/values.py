"""Types that many modules share; importing them loads no other library."""

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

Numbers: TypeAlias = Any  # a number, an array, a sequence of numbers, or symbols in their place
Parameters: TypeAlias = Mapping[str, Any]  # of a problem, by name: numbers, tuples of numbers, strings
Function: TypeAlias = Callable[..., Any]  # a student's function or the reference, by the contract
Json: TypeAlias = dict[str, Any]  # as json.loads returns it
