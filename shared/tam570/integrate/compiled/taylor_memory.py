"""The memory of one motion by Taylor's method, `z`, as the translated loop knows it.

NUMBERS first, then seven numbers a component and its polynomial, HIGHEST + 1 coefficients. Names put in place for one
right-hand side: SIZE components, ORDER of the run, STRIDE and LANES of `series.Layout`.
"""

from typing import Any

from tam570.integrate.compiled.coefficients import HIGHEST

__all__ = [
    "BASE",
    "FIRST",
    "GIVEN",
    "LANES",
    "LONGEST",
    "MAXIMUM",
    "MEMORY",
    "NEW",
    "NEXT",
    "NOISE",
    "NUMBERS",
    "ORDER",
    "POLYNOMIAL",
    "REFUSALS",
    "REST",
    "ROW",
    "SIZE",
    "SLOPE",
    "SATURATES",
    "STATUS",
    "STEPS",
    "STRIDE",
    "TIMED",
    "TRIES",
    "WHO",
    "H",
    "M",
    "T",
    "Y",
    "at",
    "memory",
    "rates",
    "reach",
    "roundoff",
]

NUMBERS = 16
ROW, T, H, NEW, STATUS, STEPS, REFUSALS, TRIES, LONGEST, GIVEN, WHO, MAXIMUM, FIRST = range(13)  # where in z
Y, REST, M, SLOPE, NEXT, BASE, NOISE, POLYNOMIAL = range(8)
# of a component: at the end of the step tried; what rounding took from its start; its size at the start; the
# polynomial's derivative at the end; what rounding takes from the end; the derivative there; what a rounding does to it

SIZE = ORDER = STRIDE = LANES = MEMORY = 0
TIMED = False  # whether the right-hand side depends on time
SATURATES = False  # whether it has exp, tanh or their like of the state
rates: Any = None  # rates(work, c, time, ORDER): the coefficients of order 1
reach: Any = None  # the same: in the place of the first, the longest step for what saturates
roundoff: Any = None  # the same: in their place, a bound of their rounding


def memory(size: int) -> int:
    """Doubles in z."""
    return NUMBERS + size * (POLYNOMIAL + HIGHEST + 1)


def at(part: Any, i: Any) -> Any:
    """Return where in z that part of component i is, or the first coefficient of its polynomial."""
    return NUMBERS + part * SIZE + i * (HIGHEST + 1 if part == POLYNOMIAL else 1)
