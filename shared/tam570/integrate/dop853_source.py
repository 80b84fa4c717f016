"""The step of DOP853 written out for one right-hand side: Python source without loops, arrays or calls.

Names in the source: y state, k0 its derivative, e3_1 what stage 3's derivative of component 1 differs from that,
s the state at a stage, n the new state, r what rounding took from the state, m the largest magnitude so far, c the
constants of the scene.
"""

import math
from collections.abc import Callable
from functools import lru_cache
from types import CodeType
from typing import Any

from tam570.integrate.formulas import Formulas, by_call, names, tuple_of, unpacked
from tam570.integrate.tableau import FIFTH, LESS, NODES, ROWS, Row, interpolant

__all__ = ["array_functions", "compiled", "functions"]

KEPT = range(5, 12)  # the stages that the interpolant takes over from the step
PASSED_ON = 0.3  # of a step, after which the later stages see what rounding did to the earlier ones


def array_functions(formulas: Formulas) -> str:
    """Source of `step`, `raised`, `dense` and `at` for arrays: a member of an ensemble in each element."""
    parts = [_step(formulas, arrays=True), _raised(formulas, arrays=True), _dense(formulas), _at(formulas)]
    return "\n\n".join("\n    ".join(part) for part in parts) + "\n"


def functions(formulas: Formulas, sampled: bool = True, forgiving: bool = True) -> str:
    """Source of `rhs`, `euler`, `raised` and `step` for these formulas, and of `dense` and `at` if sampled.

    forgiving : Python raises an error on overflow, where compiled code goes on with infinity
    """
    nothing = tuple_of(["nan"] * formulas.size)
    inner = formulas if forgiving else by_call(formulas)
    parts = [_rhs(formulas), _raised(inner), _step(inner)]
    if forgiving:
        answers = (nothing, "m", "y, r, f, m, inf, 0.0, ()")
        parts = [_forgiving(part, answer) for part, answer in zip(parts, answers, strict=True)]
    parts += [_euler(formulas), *([_dense(inner), _at(formulas)] if sampled else [])]
    return "\n\n".join("\n    ".join(part) for part in parts) + "\n"


def _forgiving(function: list[str], answer: str) -> list[str]:
    """A function that answers thus to an overflow or the root of a negative number: the step was too long."""
    head, *body = function
    rescue = ["except (ArithmeticError, ValueError):", f"    return {answer}"]
    return [head, "try:", *(f"    {line}" for line in body), *rescue]


def _combination(row: Row, i: int) -> str:
    """The sum over the stages: of the row's sum times k0, and the differences from k0. These are small: so are the
    roundings of weights as large as 43, and what these lack themselves."""
    return " + ".join(f"{a!r} * e{j}_{i}" for j, a in row.items() if j)


def _stage(formulas: Formulas, number: int, row: Row, node: float) -> list[str]:
    """Lines that set e<number>: the derivative where the earlier stages point to, less that at the start."""
    lines = []
    for i in sorted(formulas.reads):
        sum_ = " + ".join(filter(None, (f"{node!r} * k0_{i}", _combination(row, i))))
        lines.append(f"s{i} = y{i} + h * ({sum_})" if i in formulas.moving else f"s{i} = y{i}")
    return [*lines, *_derivative(formulas, number, f"start + {node!r} * h", " - k0_")]


def _derivative(formulas: Formulas, number: int, time: str, less: str = "") -> list[str]:
    """Lines that set k<number>, or where it is less that of the start, e<number>."""
    clock = [f"t = {time}"] if formulas.timed else []
    letter = "e" if less else "k"
    rates = [f"{letter}{number}_{i} = {formulas.rates[i]}{less and less + str(i)}" for i in formulas.moving]
    return [*clock, *formulas.lines, *rates]


def _rhs(formulas: Formulas) -> list[str]:
    return ["def rhs(t, s, c):", *unpacked(formulas, s="s"), *formulas.lines, f"return {tuple_of(formulas.rates)}"]


def _euler(formulas: Formulas) -> list[str]:
    states = (f"y[{i}] + h * f[{i}]" for i in range(formulas.size))
    return ["def euler(h, y, f):", f"return {tuple_of(states)}"]


def _raised(formulas: Formulas, arrays: bool = False) -> list[str]:
    """Magnitudes no smaller than `weight` times what a change of the state by a few roundings does to h f.

    Tried half way through the step: at its start too many things may be exactly zero. What it does to one rate
    shifts that component, and so on the rates of others: chains of four are followed. Then the change is made
    larger, and `wider` times so at each refusal: a rate that is nothing but rounding is exactly zero for some changes,
    for all of one sign among them.
    """
    roundings = [(-1) ** i * 2.0**-52 * (1.37 + 0.41 * (i % 5)) for i in range(formulas.size)]  # no two cancel
    lines = ["def raised(start, h, y, f, m, c, weight, wider):", *unpacked(formulas, y="y", f="f", m="m")]
    lines += [f"s{i} = y{i} + 0.5 * h * f{i}" for i in sorted(formulas.reads)]
    lines += [*_derivative(formulas, 0, "start + 0.5 * h")]
    lines += [f"b{i} = s{i}" for i in sorted(formulas.reads)]
    lines += [f"k1_{i} = k0_{i}" for i in formulas.moving]
    lines += ["for roundings in (1.0, -1.0, 1.0, -1.0, 2.0, -3.0, 5.0):", "    more = roundings * wider"]
    for i in sorted(formulas.reads):
        shift = f" + {PASSED_ON} * h * (k1_{i} - k0_{i})" if i in formulas.moving else ""
        lines.append(f"    s{i} = b{i} * (1.0 + more * {roundings[i]!r}){shift}")
    lines += [f"    {line}" for line in _derivative(formulas, 1, "start + 0.5 * h")]
    for i in formulas.moving:
        lines.append(f"    x = abs(k1_{i} - k0_{i}) * h * weight / abs(more)")
        lines.append(f"    m{i} = maximum(m{i}, x)" if arrays else f"    m{i} = x if m{i} < x < inf else m{i}")
    return [*lines, f"return {tuple_of(names('m', formulas.size))}"]


def _step(formulas: Formulas, arrays: bool = False) -> list[str]:
    """One step: new state, its rounding, derivative, magnitudes, both estimates squared, stages kept."""
    lines = ["def step(start, h, y, r, f, m, c):", *unpacked(formulas, y="y", r="r", f="k0_", m="m")]
    for number in range(1, 12):
        lines += _stage(formulas, number, ROWS[number], NODES[number])
    for i in range(formulas.size):
        lines += _update(formulas, i)
    lines += [f"s{i} = n{i}" for i in sorted(formulas.reads)]
    lines += _derivative(formulas, 12, "start + h")
    still = set(range(formulas.size)) - set(formulas.moving)
    lines += [f"k12_{i} = 0.0" for i in still] + ["fifth = third = 0.0"]
    for i in formulas.moving:
        lines += _largest(i, arrays) + _estimate(i)
    results = (tuple_of(names(letter, formulas.size)) for letter in ("n", "r", "k12_", "m"))
    return [*lines, f"return {', '.join(results)}, fifth, third, {tuple_of(_kept(formulas))}"]


def _kept(formulas: Formulas) -> list[str]:
    return [f"e{j}_{i}" for j in KEPT for i in formulas.moving]


def _update(formulas: Formulas, i: int) -> list[str]:
    """Compensated sum (Kahan): what the addition loses is carried to the next step."""
    if i not in formulas.moving:
        return [f"n{i} = y{i}"]
    sums = [f"u{i} = {_combination(ROWS[12], i)}", f"d = r{i} + h * (k0_{i} + u{i})"]
    return [*sums, f"n{i} = y{i} + d", f"r{i} = d - (n{i} - y{i})"]


def _largest(i: int, arrays: bool) -> list[str]:
    if arrays:
        return [f"m{i} = maximum(m{i}, absolute(n{i}))"]
    return [f"if n{i} > m{i}: m{i} = n{i}", f"elif -n{i} > m{i}: m{i} = -n{i}"]


def _estimate(i: int) -> list[str]:
    return [
        f"x = h * ({_combination(FIFTH, i)}) / m{i}",
        "fifth += x * x",
        f"x = h * (u{i} + {_combination(LESS, i)}) / m{i}",
        "third += x * x",
    ]


def _dense(formulas: Formulas) -> list[str]:
    """Coefficients of the polynomial inside a step, component by component; the first three are of its ends alone."""
    rows, nodes, last = interpolant()
    lines = ["def dense(start, h, y, n, f, g, stages, c):"]
    lines += unpacked(formulas, y="y", n="n", f="k0_", g="k12_")
    lines += [f"{tuple_of(_kept(formulas))} = stages"]
    lines += [f"e12_{i} = k12_{i} - k0_{i}" for i in formulas.moving]
    for number in (13, 14, 15):
        lines += _stage(formulas, number, ROWS[number], NODES[number])
    for number, row, node in zip((16, 17, 18, 19), rows, nodes, strict=True):
        lines += _stage(formulas, number, row, node)
    for i in formulas.moving:
        lines += [f"q0_{i} = n{i} - y{i}", f"q1_{i} = h * k0_{i} - q0_{i}", f"x0 = -q1_{i}"]
        lines += [f"x{place} = h * e{j}_{i}" for place, j in enumerate((12, 16, 17, 18, 19), start=1)]
        lines.append(f"q2_{i} = 2.0 * x0 - x1")
        for term, weights in enumerate(last, start=3):
            lines.append(f"q{term}_{i} = " + " + ".join(f"{float(w)!r} * x{j}" for j, w in enumerate(weights)))
    coefficients = [f"q{term}_{i}" for i in formulas.moving for term in range(7)]
    return [*lines, f"return {tuple_of(coefficients)}"]


def _at(formulas: Formulas) -> list[str]:
    """Write the state at the fraction x of a step into row `row` of `out`."""
    coefficients = [f"q{term}_{i}" for i in formulas.moving for term in range(7)]
    lines = ["def at(out, row, x, y, q):", f"{tuple_of(coefficients)} = q", "z = 1.0 - x"]
    for i in range(formulas.size):
        value = f"x * q6_{i}"
        for term in range(5, -1, -1):
            value = f"{'z' if term % 2 else 'x'} * (q{term}_{i} + {value})"
        moved = f"y[{i}] + {value}" if i in formulas.moving else f"y[{i}]"
        lines.append(f"out[row, {i}] = {moved}")
    return lines


def compiled(formulas: Formulas, sampled: bool, given: Callable[..., Any] | None = None) -> dict[str, Any]:
    """The functions by name; `given` is what formulas of `call_of` call."""
    namespace: dict[str, Any] = {**vars(math), "given": given, "dense": None, "at": None}
    exec(_code(formulas, sampled), namespace)
    return namespace


@lru_cache(maxsize=256)
def _code(formulas: Formulas, sampled: bool) -> CodeType:
    return compile(functions(formulas, sampled), "<tam570 step>", "exec")
