"""Types of values that many modules share; a module loads nothing by importing them."""

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

Numbers: TypeAlias = Any  # what arithmetic takes: a number, an array or a sequence of them, or symbols in their place
Parameters: TypeAlias = Mapping[str, Any]  # of a problem, by name: numbers, tuples of them, words
Function: TypeAlias = Callable[..., Any]  # a student's or the reference: it takes and returns what the contract says
Json: TypeAlias = dict[str, Any]  # plain data, as json.loads returns it
