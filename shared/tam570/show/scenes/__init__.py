"""The scenes, a module for each: `film(student, parameters, start, seconds)` draws the student's results.

A scene defines the drawing and, in EXAMPLE, START and SECONDS, the parameters and the initial state. The student's
functions compute the motion.
"""

from collections.abc import Mapping
from functools import partial
from types import SimpleNamespace
from typing import Any

from tam570.values import Function


def drawn_for(film: Function, names: Mapping[str, Any]) -> Function:
    """Return a lecture's `film` with its functions, from the globals of the lecture or of a copy."""
    return partial(film, SimpleNamespace(**names))
