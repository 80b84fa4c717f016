"""Methods that keep the structure of mechanics over long times, at a fixed step: source for one right-hand side.

gauss       : Gauss-Legendre collocation of six stages, order 12, symplectic and symmetric for any Hamiltonian. The
              coefficients are split in two doubles: rounded to one, they make the energy drift.
              Hairer, McLachlan, Razakarivony, Achieving Brouwer's law with implicit Runge-Kutta methods, BIT 2008.
composition : of 17 leapfrogs, order 8, symmetric, for a state (q, v) with q' a function of v and v' one of q.
              Kahan and Li, Composition constants for raising the orders of unconventional schemes, 1997.
"""

from decimal import Decimal, localcontext
from functools import cache

from tam570.integrate.source import Formulas, tuple_of, unpacked

__all__ = ["STAGES", "composition_source", "gauss_source", "gauss_tableau"]

STAGES = 6
DIGITS = 45

_HALF = """0.13020248308889008087881763 0.56116298177510838456196441 -0.38947496264484728640807860
0.15884190655515560089621075 -0.39590389413323757733623154 0.18453964097831570709183254
0.25837438768632204729397911 0.29501172360931029887096624 -0.60550853383003451169892108"""
LEAPS = [float(leap) for leap in (*_HALF.split(), *_HALF.split()[-2::-1])]

Polynomial = list[Decimal]  # coefficients, constant first
Pair = tuple[float, float]  # a double, and what it lacks


def _value(polynomial: Polynomial, x: Decimal) -> Decimal:
    return sum((c * x**power for power, c in enumerate(polynomial)), Decimal(0))


def _derivative(polynomial: Polynomial) -> Polynomial:
    return [power * c for power, c in enumerate(polynomial)][1:]


def _integral(polynomial: Polynomial) -> Polynomial:
    return [Decimal(0), *(c / (power + 1) for power, c in enumerate(polynomial))]


def _times(p: Polynomial, q: Polynomial) -> Polynomial:
    product = [Decimal(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            product[i + j] += a * b
    return product


def _nodes() -> list[Decimal]:
    """Zeros of the Legendre polynomial of degree 6 on (0, 1), the n-th derivative of (x^2 - x)^n: by Newton."""
    legendre = [Decimal(1)]
    for _ in range(STAGES):
        legendre = _times(legendre, [Decimal(0), Decimal(-1), Decimal(1)])
    for _ in range(STAGES):
        legendre = _derivative(legendre)
    slope = _derivative(legendre)
    nodes = [Decimal(x) for x in ("0.034", "0.169", "0.381", "0.619", "0.831", "0.966")]
    for _ in range(7):  # from three digits; each doubles them
        nodes = [x - _value(legendre, x) / _value(slope, x) for x in nodes]
    return nodes


@cache
def gauss_tableau() -> tuple[list[list[Pair]], list[Pair], list[float], list[list[float]]]:
    """Coefficients and weights, each split in two doubles; nodes; how the next step's stages follow from these."""
    with localcontext() as context:
        context.prec = DIGITS
        nodes = _nodes()
        lagrange = []
        for j, own in enumerate(nodes):
            basis = [Decimal(1)]
            for node in nodes[:j] + nodes[j + 1 :]:
                basis = _times(basis, [-node / (own - node), 1 / (own - node)])
            lagrange.append(basis)
        sums = [_integral(basis) for basis in lagrange]
        rows = [[_split(_value(s, node)) for s in sums] for node in nodes]
        weights = [_split(_value(s, Decimal(1))) for s in sums]
        onward = [[float(_value(basis, node + 1)) for basis in lagrange] for node in nodes]
        return rows, weights, [float(node) for node in nodes], onward


def _split(x: Decimal) -> Pair:
    return float(x), float(x - Decimal(float(x)))


def gauss_source(formulas: Formulas) -> str:
    """Source of leap(start, h, y, r, k, c): new state, its rounding, guess of the next stages' derivatives."""
    rows, weights, nodes, onward = gauss_tableau()
    size = formulas.size
    stages = tuple_of(f"k{j}_{i}" for j in range(STAGES) for i in range(size))
    lines = [*unpacked(formulas, y="y", r="r"), f"{stages} = k", "change = inf", "sweep = 0"]
    lines += ["while sweep < 60:", "    sweep += 1", "    before = change", "    change = 0.0"]
    for number, (row, node) in enumerate(zip(rows, nodes, strict=True)):
        lines += [f"    {line}" for line in _collocation(formulas, number, row, node)]
    # Rounding sets the end: a change that no longer shrinks is rounding.
    lines += ["    if change == 0.0 or (change >= before and sweep > 3):", "        break"]
    lines += ["if not change < 1e-9 * (1.0 + first):", "    y0 = nan"]  # it did not settle: the step is too long
    for i in range(size):
        low, high = (" + ".join(f"{w[part]!r} * k{j}_{i}" for j, w in enumerate(weights)) for part in (1, 0))
        lines += [f"d = h * ({high})", f"rest = h * ({low}) + r{i}", *_added(i)]
    guesses = (" + ".join(f"{w!r} * k{j}_{i}" for j, w in enumerate(row)) for row in onward for i in range(size))
    new = [tuple_of(f"{letter}{i}" for i in range(size)) for letter in "nr"]
    lines.append(f"return {new[0]}, {new[1]}, {tuple_of(guesses)}")
    return "\n    ".join(["def leap(start, h, y, r, k, c):", *lines]) + "\n"


def _added(i: int) -> list[str]:
    """y + d + rest in two doubles: were `rest` added to d first, its tail would go the same way at every step."""
    return [*_sum_and_error(f"y{i}", "d"), "rest += error", f"n{i} = n + rest", f"r{i} = rest - (n{i} - n)"]


def _sum_and_error(y: str, d: str) -> list[str]:
    """n = y + d and what it lacks, whichever is larger: where y passes zero, d - (n - y) errs, always one way."""
    return [f"n = {y} + {d}", f"part = n - {y}", f"error = ({y} - (n - part)) + ({d} - part)"]


def _collocation(formulas: Formulas, number: int, row: list[Pair], node: float) -> list[str]:
    """Lines that renew the derivatives of one stage (by the newest of the others: Gauss-Seidel)."""
    lines = [f"t = start + {node!r} * h"] if formulas.timed else []
    if number == 0:
        lines.append("first = 0.0")
    for i in sorted(formulas.reads):
        low, high = (" + ".join(f"{a[part]!r} * k{j}_{i}" for j, a in enumerate(row)) for part in (1, 0))
        lines.append(f"s{i} = y{i} + (h * ({high}) + (h * ({low}) + r{i}))")
    lines += formulas.lines
    for i, rate in enumerate(formulas.rates):
        lines += [f"x = {rate}", f"change += abs(x - k{number}_{i})", f"k{number}_{i} = x", "first += abs(x)"]
    return lines


def composition_source(drift: Formulas, kick: Formulas, constants: int) -> str:
    """Source of leap(start, h, y, r, k, c): drifts move q by v, kicks move v by q; sums are compensated."""
    half = len(drift.rates)
    size = half + len(kick.rates)
    whole = [0.0, *LEAPS, 0.0]
    drifts = [(a + b) / 2 for a, b in zip(whole, whole[1:], strict=False)]
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
            moved = [*_sum_and_error(f"s{i}", f"d{i}"), f"rest = r{i} + error"]
            lines += [f"    {line}" for line in (*moved, f"s{i} = n + rest", f"r{i} = rest - (s{i} - n)")]
    lines.append(f"return {names[0]}, {names[1]}, k")
    return "\n    ".join(["def leap(start, h, y, r, k, c):", *lines]) + "\n"
