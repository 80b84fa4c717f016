"""Gauss-Legendre collocation of six stages, order 12, at a fixed step: source for one right-hand side.

Symplectic and symmetric for any Hamiltonian. The coefficients are split in two doubles: rounded to one, they make the
energy drift. Hairer, McLachlan, Razakarivony, Achieving Brouwer's law with implicit Runge-Kutta methods, BIT 2008.
"""

from decimal import Decimal, localcontext
from functools import cache

from tam570.integrate.formulas import Formulas, tuple_of, unpacked

__all__ = ["STAGES", "gauss_source", "gauss_tableau", "sum_and_error"]

STAGES = 6
DIGITS = 45

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
        for j, stage in enumerate(nodes):
            basis = [Decimal(1)]
            for node in nodes[:j] + nodes[j + 1 :]:
                basis = _times(basis, [-node / (stage - node), 1 / (stage - node)])
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
    return [*sum_and_error(f"y{i}", "d"), "rest += error", f"n{i} = n + rest", f"r{i} = rest - (n{i} - n)"]


def sum_and_error(y: str, d: str) -> list[str]:
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
