"""A composition of 17 leapfrogs, order 8, symmetric, at a fixed step: source for one right-hand side.

For a state (q, v) with q' a function of v and v' one of q. The constants are those of Kahan and Li,
Composition constants for raising the orders of unconventional schemes, 1997.
"""

from tam570.integrate.formulas import Formulas, tuple_of
from tam570.integrate.gauss_source import sum_and_error

__all__ = ["composition_source"]

_HALF = """0.13020248308889008087881763 0.56116298177510838456196441 -0.38947496264484728640807860
0.15884190655515560089621075 -0.39590389413323757733623154 0.18453964097831570709183254
0.25837438768632204729397911 0.29501172360931029887096624 -0.60550853383003451169892108"""
LEAPS = [float(leap) for leap in (*_HALF.split(), *_HALF.split()[-2::-1])]


def composition_source(drift: Formulas, kick: Formulas, constants: int) -> str:
    """Source of leap(start, h, y, r, k, c): drifts move q by v, kicks move v by q; sums are compensated."""
    half = len(drift.rates)
    size = half + len(kick.rates)
    step = [0.0, *LEAPS, 0.0]
    drifts = [(a + b) / 2 for a, b in zip(step, step[1:], strict=False)]
    pairs = tuple_of(f"({d!r}, {k!r})" for d, k in zip(drifts, [*LEAPS, 0.0], strict=True))
    names = [tuple_of(f"{letter}{i}" for i in range(size)) for letter in "sr"]
    lines = [f"{names[0]} = y", f"{names[1]} = r"]
    if constants:
        lines.append(f"{tuple_of(f'c{i}' for i in range(constants))} = c")
    lines.append(f"for d, k_ in {pairs}:")
    for fraction, formulas, first in (("d", drift, 0), ("k_", kick, half)):
        lines += [f"    {line}" for line in formulas.lines]
        for i, rate in enumerate(formulas.rates, start=first):
            lines.append(f"    d{i} = {fraction} * h * {rate}")
        for i in range(first, first + len(formulas.rates)):
            moved = [*sum_and_error(f"s{i}", f"d{i}"), f"rest = r{i} + error"]
            lines += [f"    {line}" for line in (*moved, f"s{i} = n + rest", f"r{i} = rest - (s{i} - n)")]
    lines.append(f"return {names[0]}, {names[1]}, k")
    return "\n    ".join(["def leap(start, h, y, r, k, c):", *lines]) + "\n"
