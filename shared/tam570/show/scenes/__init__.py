"""The scenes, a module for each: `film(student, parameters, start, seconds)` shows the student's functions.

A scene knows where things are drawn and, in EXAMPLE, START and SECONDS, with what they start. How they move is for
the student's functions to say.
"""

from collections.abc import Mapping
from functools import partial
from types import SimpleNamespace
from typing import Any

from tam570.values import Function


def drawn_for(film: Function, names: Mapping[str, Any]) -> Function:
    """Return the film of a lecture by the functions with these names: its own, or those of its copy."""
    return partial(film, SimpleNamespace(**names))
