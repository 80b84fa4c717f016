"""The step of DOP853 written out for one right-hand side: Python source without loops, arrays or calls.

Names in the source: y state, k0 its derivative, e3_1 what stage 3's derivative of component 1 differs from that,
s the state at a stage, n the new state, r what rounding took from the state, a the absolute tolerance, b what rounding
does to the error estimates, c the constants of the scene. An error of component i is measured in units of
a_i + b_i + rtol max(|y_i|, |n_i|).
"""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from types import CodeType

from tam570.integrate.error_scale import NO_SCALE, PART
from tam570.integrate.formulas import Formulas, by_call, names, tuple_of, unpacked
from tam570.integrate.tableau import FIFTH, LESS, NODES, ROWS, Row, interpolant
from tam570.values import Function, Numbers

__all__ = ["ESTIMATE_ROUNDOFF", "REACH", "compiled", "functions", "sampling"]

KEPT = range(5, 12)  # the stages that the interpolant takes over from the step
UNIT_ROUNDOFF = 2.0**-53
AMPLIFIED = 0.5  # at the end of a smooth step both derivatives are one to a tenth; 2 at h = -6 over the rate of decay
REACH = 4.0  # tanh(4) is 1 to 7e-4, exp(-4) is 0.02: from twice that on a pulse is seen
ESTIMATE_ROUNDOFF = (
    8.0  # the weights of both estimates add up to less: a rate known to N makes an error of 8 h N of them
)
SWEEPS = (
    1.0,
    2.0,
    3.0,
)  # the rounding of one rate shifts that component, and so on the rates of others: chains of four


def functions(formulas: Formulas, forgiving: bool = True) -> str:
    """Source of `rhs`, `euler`, and of what `adaptive_loop.GENERATED` names but `dense` and `at`.

    forgiving : Python raises an error on overflow, where compiled code goes on with infinity
    """
    nothing = tuple_of(["nan"] * formulas.size)
    inner = formulas if forgiving else by_call(formulas)
    parts = [_rhs(formulas), _step(inner), *([_roundoff(formulas)] if formulas.rate_bounds else [])]
    if forgiving:
        answers = (nothing, "y, r, f, inf, 0.0, ()", "b")[: len(parts)]
        parts = [_forgiving(part, answer) for part, answer in zip(parts, answers, strict=True)]
    reach = _reach(formulas)
    parts += [_forgiving(reach, "inf") if forgiving and formulas.exponents else reach]
    parts += [["def passed(start, h, y, f, n, g, error, shortest, c):", "return inf"]]
    parts += [_euler(formulas), _error_norms(formulas), _jump(formulas), _lesser(formulas)]
    return _source(parts)


def sampling(formulas: Formulas, forgiving: bool = True) -> str:
    """Source of `dense` and `at`: states inside of a step."""
    return _source([_dense(formulas if forgiving else by_call(formulas)), _at(formulas)])


def _source(parts: list[list[str]]) -> str:
    return "\n\n".join("\n    ".join(part) for part in parts) + "\n"


def _forgiving(function: list[str], answer: str) -> list[str]:
    """Return a function that answers thus to an overflow or the root of a negative number: the step was too long."""
    signature, *body = function
    rescue = ["except (ArithmeticError, ValueError, LookupError):", f"    return {answer}"]
    return [signature, "try:", *(f"    {line}" for line in body), *rescue]


def _combination(row: Row, i: int) -> str:
    """Return the sum over the stages: of the row's sum times k0, and the differences from k0.

    These are small: so are the roundings of weights as large as 43, and what these lack themselves.
    """
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


def _roundoff(formulas: Formulas) -> list[str]:
    """Return what rounding does to the error estimates of a step of h.

    A running error bound (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 3.3): each operation adds
    its own rounding to the one that its arguments carry; time and state are known to half a unit in the last place.
    It is taken half way through the step: at its start too many things may be exactly zero.
    """
    lines = ["def roundoff(start, h, y, f, b, c):", *unpacked(formulas, y="y", f="f", b="b")]
    lines += [f"s{i} = y{i} + 0.5 * h * f{i}" for i in sorted(formulas.reads)]
    lines += ["t = start + 0.5 * h", f"b_t = {UNIT_ROUNDOFF!r} * abs(t)", *formulas.values]
    lines += [f"b_s{i} = {UNIT_ROUNDOFF!r} * abs(s{i})" for i in sorted(formulas.reads)]
    lines += [f"x{i} = 0.0" for i in formulas.moving]
    if formulas.moving:
        lines += [f"for sweep in {SWEEPS!r}:", *(f"    {line}" for line in formulas.bounds)]
    lines += [f"    x{i} = h * ({formulas.rate_bounds[i]})" for i in formulas.moving]
    for i in sorted(formulas.reads & set(formulas.moving)):
        lines.append(f"    b_s{i} = {UNIT_ROUNDOFF!r} * abs(s{i}) + x{i}")
    for i in formulas.moving:
        lines += [f"x{i} = {ESTIMATE_ROUNDOFF!r} * x{i}", f"b{i} = x{i} if x{i} < inf else 0.0"]
    return [*lines, f"return {tuple_of(names('b', formulas.size))}"]


def _reach(formulas: Formulas) -> list[str]:
    """Bound the step: no argument of exp, tanh and their like changes by more than half of itself, or REACH.

    Far from zero these functions are constant to rounding: an error estimate does not see what comes.
    """
    lines = ["def reach(start, h, y, f, c):"]
    if not formulas.exponents:
        return [*lines, "return inf"]
    reads = sorted(formulas.reads)
    lines += [*unpacked(formulas, y="y", f="f"), *(f"s{i} = y{i}" for i in reads), "t = start", *formulas.values]
    lines += [f"x{k} = {argument}" for k, argument in enumerate(formulas.exponents)]
    lines += [f"d = {PART!r} * h", *(f"s{i} = y{i} + d * f{i}" for i in reads), "t = start + d", *formulas.values]
    lines.append("longest = inf")
    for k, argument in enumerate(formulas.exponents):
        lines += [f"w = abs({argument} - x{k})", f"x = d * max(0.5 * abs(x{k}), {REACH!r})"]
        lines += ["if x < longest * w:", "    longest = x / w"]
    return [*lines, "return longest"]


def _lesser(formulas: Formulas) -> list[str]:
    lines = ["def lesser(a, b):", *unpacked(replace(formulas, constants=0), a="a", b="b")]
    return [*lines, f"return {tuple_of(f'a{i} if a{i} < b{i} else b{i}' for i in range(formulas.size))}"]


def _step(formulas: Formulas) -> list[str]:
    """One step: new state, its rounding, derivative, both error estimates squared, stages kept."""
    lines = ["def step(start, h, y, r, f, a, b, rtol, c):", *unpacked(formulas, y="y", r="r", f="k0_", a="a", b="b")]
    for number in range(1, 12):
        lines += _stage(formulas, number, ROWS[number], NODES[number])
    for i in range(formulas.size):
        lines += _update(formulas, i)
    lines += [f"s{i} = n{i}" for i in sorted(formulas.reads)]
    lines += _derivative(formulas, 12, "start + h")
    still = set(range(formulas.size)) - set(formulas.moving)
    lines += [f"k12_{i} = 0.0" for i in still] + ["fifth = third = 0.0"]
    for i in formulas.moving:
        lines += _estimate(i)
    results = (tuple_of(names(letter, formulas.size)) for letter in ("n", "r", "k12_"))
    return [*lines, f"return {', '.join(results)}, fifth, third, {tuple_of(_kept(formulas))}"]


def _error_norms(formulas: Formulas) -> list[str]:
    """Both error estimates of a step that was tried, squared, by a part of the tolerance and another rounding."""
    lines = ["def error_norms(h, y, n, f, g, a, b, part, rtol, stages):"]
    lines += unpacked(replace(formulas, constants=0), y="y", n="n", f="k0_", g="k12_", a="a", b="b")
    lines += [f"{tuple_of(_kept(formulas))} = stages", "fifth = third = 0.0"]
    for i in formulas.moving:
        lines += [f"a{i} = part * a{i}", f"u{i} = {_combination(ROWS[12], i)}", *_estimate(i)]
    return [*lines, "return fifth, third"]


def _jump(formulas: Formulas) -> list[str]:
    """Return how far a change of the rates moves the state within h, relative to it.

    What starts to move from zero aside.
    """
    lines = ["def jump(h, y, n, f, g, a, rtol):"]
    lines += unpacked(replace(formulas, constants=0), y="y", n="n", f="f", g="g", a="a")
    lines.append("largest = 0.0")
    for i in formulas.moving:
        lines += [f"w = a{i} / rtol + max(abs(y{i}), abs(n{i}))", f"x = h * abs(g{i} - f{i})"]
        lines += [f"if (y{i} != 0.0 or a{i} > {NO_SCALE!r}) and not x <= largest * w:", "    largest = x / w"]
    return [*lines, "return largest"]


def _kept(formulas: Formulas) -> list[str]:
    return [f"e{j}_{i}" for j in KEPT for i in formulas.moving]


def _update(formulas: Formulas, i: int) -> list[str]:
    """Compensated sum (Kahan): what the addition loses is carried to the next step."""
    if i not in formulas.moving:
        return [f"n{i} = y{i}"]
    sums = [f"u{i} = {_combination(ROWS[12], i)}", f"d = r{i} + h * (k0_{i} + u{i})"]
    return [*sums, f"n{i} = y{i} + d", f"r{i} = d - (n{i} - y{i})"]


def _estimate(i: int) -> list[str]:
    """Add component i to both estimates of the error.

    Stage 11 is at the end of the step, as the new state is. If their derivatives differ, the step is beyond the region
    of stability: the errors of what decays may be small enough at its end, and large inside.
    """
    return [
        f"m = abs(y{i})",
        f"x = abs(n{i})",
        "m = x if x > m else m",
        f"w = h / (a{i} + b{i} + rtol * m)",
        f"x = w * ({_combination(FIFTH, i)})",
        "fifth += x * x",
        f"x = w * (u{i} + {_combination(LESS, i)})",
        "third += x * x",
        f"d = abs(e11_{i} + k0_{i} - k12_{i})",
        f"if w * d > 1.0 and a{i} > {NO_SCALE!r} and d > {AMPLIFIED!r} * (abs(k0_{i}) + abs(k12_{i}) + abs(e8_{i})):",
        "    fifth += 36.0 + 6.0 * sqrt(third)",  # an error of 6 to 60: half the step is tried
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
        lines += [f"x{index} = h * e{j}_{i}" for index, j in enumerate((12, 16, 17, 18, 19), start=1)]
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


def compiled(formulas: Formulas, sampled: bool, called_function: Function | None = None) -> dict[str, Numbers]:
    """Return the functions by name; `given` is what formulas of `call_of` call."""
    namespace: dict[str, Numbers] = {**vars(math), "given": called_function, "dense": None, "at": None}
    for write in (functions, sampling)[: 1 + sampled]:
        exec(_code(write, formulas), namespace)
    return namespace


@lru_cache(maxsize=256)
def _code(write: Callable[[Formulas], str], formulas: Formulas) -> CodeType:
    return compile(write(formulas), "<tam570 step>", "exec")
