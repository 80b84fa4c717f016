"""Times near which a traced right-hand side has features that a step could miss: shifted pulses, switches, kinks.

Long steps, and Taylor series, miss `exp(-((t - 5) / 0.02)**2)`, since far from 5 it vanishes with its derivatives. So a
step ends at each zero and extremum of a function of time that is the argument of another function.
"""

import math
from functools import lru_cache

import numpy as np

from tam570.integrate.trace import Graph, Symbol, on_arrays

TAME = {"sin", "cos", "log", "log2", "log10", "sqrt", "cbrt"}  # no narrower features than the argument
POINTS, MOST = 1000, 100_000  # of the grid on which functions of time are sampled: base number and limit
REFINED = 2.0**-20  # accuracy of a break, as a fraction of the grid spacing
A_TURN = 16  # grid points per period of a sine

Affine = tuple[float, float]  # rate and shift of rate * t + shift
Array = np.ndarray[tuple[int, ...], np.dtype[np.float64]]


@lru_cache(maxsize=256)
def breaks_of(graph: Graph, start: float, end: float) -> tuple[float, ...]:
    """Return such times between start and end, in order."""
    affine: dict[int, Affine] = {}
    timed: dict[int, Symbol] = {}
    arguments: dict[int, Symbol] = {}
    for symbol in graph.operations:
        operands = [a for a in symbol.arguments if isinstance(a, Symbol)]
        if symbol.name != "t" and not (operands and all(a.number in timed for a in operands)):
            continue
        timed[symbol.number] = symbol
        if line := _affine(symbol, affine):
            affine[symbol.number] = line
            continue
        is_over = symbol.name == "/" and symbol.arguments[0] is operands[0]
        is_multiple = len(operands) == 1 and (symbol.name == "*" or is_over)
        if symbol.name not in TAME and not is_multiple and symbol.name not in ("+", "-", "neg"):
            arguments |= {a.number: a for a in operands}
    lines = [line for number, line in affine.items() if number in arguments]
    zeros = [-shift / rate for rate, shift in lines if shift and rate]
    curved = [symbol for number, symbol in arguments.items() if number not in affine]
    if curved:
        zeros += _zeros_and_turns(list(timed.values()), curved, start, end, _fastest(list(timed.values()), affine))
    return tuple(sorted({time for time in zeros if start < time < end}))


def _affine(symbol: Symbol, affine: dict[int, Affine]) -> Affine | None:
    """Return rate and shift if the symbol is affine in time, else None."""
    if not symbol.arguments:
        return 1.0, 0.0
    lines = [affine.get(a.number) if isinstance(a, Symbol) else (0.0, a) for a in symbol.arguments]
    if None in lines or symbol.name not in ("+", "-", "*", "/", "neg"):
        return None
    (rate, shift), *others = [line for line in lines if line]
    if symbol.name == "neg":
        return -rate, -shift
    other, number = others[0]
    if symbol.name in "+-":
        sign = 1.0 if symbol.name == "+" else -1.0
        return rate + sign * other, shift + sign * number
    if symbol.name == "*" and (not rate or not other):
        return (rate * number, shift * number) if rate else (shift * other, shift * number)
    return (rate / number, shift / number) if symbol.name == "/" and not other and number else None


def _fastest(timed: list[Symbol], affine: dict[int, Affine]) -> float:
    """Return the largest angular frequency of the sines, rad/s; 0 if there are none."""
    waves = [s.arguments[0] for s in timed if s.name in ("sin", "cos", "tan")]
    return max((abs(affine[a.number][0]) for a in waves if isinstance(a, Symbol) and a.number in affine), default=0.0)


def _zeros_and_turns(
    timed: list[Symbol], curved: list[Symbol], start: float, end: float, fastest: float
) -> list[float]:
    """Return the zeros and extrema of the functions `curved` of time, bracketed on a grid and refined."""
    points = POINTS + A_TURN * fastest * (end - start) / (2 * math.pi)
    grid = np.linspace(start, end, int(min(points, MOST)))
    values = _values(timed, grid)
    times: list[float] = []
    for symbol in curved:
        u = values[symbol.number]
        slopes = np.diff(u)
        crossing = np.flatnonzero(u[:-1] * u[1:] < 0)
        turning = np.flatnonzero((slopes[:-1] != 0) & (slopes[:-1] * slopes[1:] <= 0))
        times += grid[1:-1][(u[1:-1] == 0.0) & (u[:-2] * u[2:] < 0)].tolist()
        times += [_refined(timed, symbol, grid[k], grid[k + 1], turns=False) for k in crossing]
        times += [_refined(timed, symbol, grid[k], grid[k + 2], turns=True) for k in turning]
    edge = REFINED * (grid[1] - grid[0])  # a zero at the start or end of the run needs no break
    return [time for time in times if start + edge < time < end - edge]


def _refined(timed: list[Symbol], symbol: Symbol, low: float, high: float, *, turns: bool) -> float:
    """Return the zero or the extremum between two times, to a fraction REFINED of their distance."""
    for _ in range(4):
        grid = np.linspace(low, high, 65)
        u = _values(timed, grid)[symbol.number]
        k = int(np.argmax(u if u[1] > u[0] else -u) if turns else np.argmax(u * u[0] <= 0))
        low, high = float(grid[max(k - 1, 0)]), float(grid[min(k + 1, 64)])
    return (low + high) / 2


def _values(timed: list[Symbol], t: Array) -> dict[int, Array]:
    """Return the values at t of each function of time, by the number of its symbol."""
    computed: dict[int, Array] = {}
    with np.errstate(all="ignore"):
        for symbol in timed:
            operands = [computed[a.number] if isinstance(a, Symbol) else a for a in symbol.arguments]
            computed[symbol.number] = on_arrays(symbol.name)(*operands) if operands else t
    return computed
