"""The memory of one motion by Taylor's method, `z`, as the translated loop knows it.

NUMBERS first, then seven numbers a component, then the polynomial, order by order. One motion alone has its components
side by side, in vectors, with zeros up to PADDED. Names put in place for one right-hand side: SIZE components, ORDER of
the run, ACROSS, ALONG and LANES of `series.Layout`.
"""

from tam570.integrate.compiled.coefficients import HIGHEST
from tam570.values import Numbers

__all__ = [
    "ACROSS",
    "ALONG",
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
    "PADDED",
    "POLYNOMIAL",
    "REFUSALS",
    "REST",
    "ROW",
    "SIZE",
    "SLOPE",
    "SATURATES",
    "STATUS",
    "STEPS",
    "TIMED",
    "TRIES",
    "WHO",
    "H",
    "M",
    "T",
    "Y",
    "at",
    "coefficient",
    "components",
    "largest",
    "memory",
    "padded",
    "rates",
    "reach",
    "roundoff",
    "summed",
    "wide",
    "width",
]

NUMBERS = 16
ROW, T, H, NEW, STATUS, STEPS, REFUSALS, TRIES, LONGEST, GIVEN, WHO, MAXIMUM, FIRST = range(13)  # where in z
Y, REST, M, SLOPE, NEXT, BASE, NOISE, POLYNOMIAL = range(8)
# of a component: at the end of the step tried; what rounding took from its start; its size at the start; the
# polynomial's derivative at the end; what rounding takes from the end; the derivative there; what a rounding does to it

SIZE = PADDED = ORDER = ACROSS = ALONG = LANES = MEMORY = 0
TIMED = False  # whether the right-hand side depends on time
SATURATES = False  # whether it has exp, tanh or their like of the state
rates: Numbers = None  # rates(work, c, time, ORDER): the coefficients of order 1
reach: Numbers = None  # the same: in the place of the first, the longest step for what saturates
roundoff: Numbers = None  # the same: in their place, a bound of their rounding


components: Numbers = (
    None  # components(): their indices, as many at a time as fit in a vector if there is one motion alone
)
wide: Numbers = None  # wide(x): as many of it
largest: Numbers = None  # largest(x): of a vector
summed: Numbers = None  # summed(x): of a vector


def width(size: int) -> int:
    """Components in a vector of one motion."""
    return 1 if size == 1 else 2 if size == 2 else 4 if size <= 4 else 8


def padded(size: int) -> int:
    """Components with what fills up the last vector."""
    return -(-size // width(size)) * width(size)


def memory(size: int) -> int:
    """Doubles in z."""
    return NUMBERS + size * (POLYNOMIAL + HIGHEST + 1)


def at(part: Numbers, i: Numbers) -> Numbers:
    """Return where in z that part of component i is, or the first coefficient of its polynomial."""
    return NUMBERS + part * PADDED + i


def coefficient(i: Numbers, n: Numbers, lane: Numbers) -> Numbers:
    """Return where in `work` the coefficient of order n of component i is."""
    return i * ACROSS + n * ALONG + lane
