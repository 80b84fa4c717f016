"""Runs that differ from an earlier one in their start alone: all else is at hand."""

from collections.abc import Callable, Hashable, Mapping
from functools import lru_cache, partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate.adaptive import Run, at_hand
from tam570.integrate.arguments import Array
from tam570.integrate.engine import Engine
from tam570.integrate.fingerprint import Changeable, fingerprint
from tam570.integrate.stiffness import COMPILED
from tam570.integrate.when_to_compile import available

__all__ = ["At_once", "Place", "at_once", "keep", "place_of"]

At_once = Callable[[Any], Array | None]
Place = list[At_once]  # empty, or with what to try last in it

METHODS = ("auto", "compiled")  # whose runs are kept
LARGEST = 20_000  # numbers in the result of a run that is kept


def at_once(made: Engine, times: Array, rtol: float, floor: list[float]) -> At_once:
    """States at `times` from a start, by Taylor's method alone; None where it does not get there."""
    if made.graph is None or not available():
        return _nothing
    whole = Run(made, float(times[0]), times - times[0], np.empty((len(times), made.formulas.size)), rtol)
    try:
        from tam570.integrate.compiled import repeated

        runs = repeated.taylor_repeated(made.graph, whole, floor, partial(whole.watch, COMPILED))
    except (ImportError, OSError, RuntimeError):  # a broken llvmlite: nobody asked for it
        runs = None
    return runs or _nothing


def place_of(
    method: str, rhs: Any, t: ArrayLike, y0: Any, parameters: Mapping[str, Any] | None, rtol: float, atol: Any
) -> Place | None:
    """Where a run with such arguments is kept; None where they may change unseen, or are not what they should be."""
    if method not in METHODS:
        return None
    try:
        times, held = np.asarray(t, dtype=float), fingerprint(dict(parameters)) if parameters else None
        return _place((fingerprint(rhs), held, len(y0), times.shape, times.tobytes(), rtol, atol))
    except (Changeable, TypeError, ValueError):
        return None


@lru_cache(maxsize=64)
def _place(key: Hashable) -> Place:
    return []


def keep(place: Place, made: Engine, times: Array, rtol: float, floor: list[float]) -> None:
    """Note that a run was asked for; where it was before, keep it for the next time."""
    if not place:
        place.append(_nothing)
    elif len(place) == 1 and at_hand(made.graph) and len(times) * made.formulas.size <= LARGEST:
        place.append(at_once(made, times, rtol, floor))


def _nothing(y0: Any) -> None:
    return None
