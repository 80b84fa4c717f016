"""DOP853: its tableau, an interpolant built on the original one, and the generated step.

Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.5 and II.10 (code dop853.f).

The step is Python source without loops or arrays; it calls the rates. Names in it: y state, k0 its derivative, e3_1
difference between the derivative of component 1 at stage 3 and k0_1, s state at a stage, n new state, r compensation
(round-off lost from the state), a absolute tolerance, b round-off of the error estimates, c constants of the right-hand
side. An error of component i is measured in units of a_i + b_i + rtol max(|y_i|, |n_i|).
"""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache, lru_cache, partial
from math import sqrt
from types import CodeType

import numpy as np
from numpy.typing import NDArray

from tam570.bytecode import cached_code
from tam570.integrate.error_scale import NO_SCALE, PART
from tam570.integrate.formulas import UNIT_ROUNDOFF, Formulas, call_of, names, tuple_of, unpacked
from tam570.values import Function, Numbers

Row = dict[int, float]  # coefficients by the number of the earlier stage

# Row 12 contains the weights of the step; 13 to 15 are only for the interpolant.
_STAGES = """
1: 0 0.05260015195876773
2: 0 0.0197250569845379 1 0.0591751709536137
3: 0 0.02958758547680685 2 0.08876275643042054
4: 0 0.2413651341592667 2 -0.8845494793282861 3 0.924834003261792
5: 0 0.037037037037037035 3 0.17082860872947386 4 0.12546768756682242
6: 0 0.037109375 3 0.17025221101954405 4 0.06021653898045596 5 -0.017578125
7: 0 0.03709200011850479 3 0.17038392571223998 4 0.10726203044637328 5 -0.015319437748624402
   6 0.008273789163814023
8: 0 0.6241109587160757 3 -3.3608926294469414 4 -0.868219346841726 5 27.59209969944671
   6 20.154067550477894 7 -43.48988418106996
9: 0 0.47766253643826434 3 -2.4881146199716677 4 -0.590290826836843 5 21.230051448181193
   6 15.279233632882423 7 -33.28821096898486 8 -0.020331201708508627
10: 0 -0.9371424300859873 3 5.186372428844064 4 1.0914373489967295 5 -8.149787010746927
   6 -18.52006565999696 7 22.739487099350505 8 2.4936055526796523 9 -3.0467644718982196
11: 0 2.273310147516538 3 -10.53449546673725 4 -2.0008720582248625 5 -17.9589318631188 6 27.94888452941996
   7 -2.8589982771350235 8 -8.87285693353063 9 12.360567175794303 10 0.6433927460157636
12: 0 0.054293734116568765 5 4.450312892752409 6 1.8915178993145003 7 -5.801203960010585
   8 0.3111643669578199 9 -0.1521609496625161 10 0.20136540080403034 11 0.04471061572777259
13: 0 0.056167502283047954 6 0.25350021021662483 7 -0.2462390374708025 8 -0.12419142326381637
   9 0.15329179827876568 10 0.00820105229563469 11 0.007567897660545699 12 -0.008298
14: 0 0.03183464816350214 5 0.028300909672366776 6 0.053541988307438566 7 -0.05492374857139099
   10 -0.00010834732869724932 11 0.0003825710908356584 12 -0.00034046500868740456 13 0.1413124436746325
15: 0 -0.42889630158379194 5 -4.697621415361164 6 7.683421196062599 7 4.06898981839711
   8 0.3567271874552811 12 -0.0013990241651590145 13 2.9475147891527724 14 -9.15095847217987
"""

# Hairer's interpolant of order 7: the terms from theta^3 on.
_DENSE = """
0: 0 -8.428938276109013 5 0.5667149535193777 6 -3.0689499459498917 7 2.38466765651207 8 2.117034582445028
   9 -0.871391583777973 10 2.2404374302607883 11 0.6315787787694688 12 -0.08899033645133331
   13 18.148505520854727 14 -9.194632392478356 15 -4.436036387594894
1: 0 10.427508642579134 5 242.28349177525817 6 165.20045171727028 7 -374.5467547226902
   8 -22.113666853125306 9 7.733432668472264 10 -30.674084731089398 11 -9.332130526430229
   12 15.697238121770845 13 -31.139403219565178 14 -9.35292435884448 15 35.81684148639408
2: 0 19.985053242002433 5 -387.0373087493518 6 -189.17813819516758 7 527.8081592054236
   8 -11.57390253995963 9 6.8812326946963 10 -1.0006050966910838 11 0.7777137798053443
   12 -2.778205752353508 13 -60.19669523126412 14 84.32040550667716 15 11.99229113618279
3: 0 -25.69393346270375 5 -154.18974869023643 6 -231.5293791760455 7 357.6391179106141 8 93.40532418362432
   9 -37.45832313645163 10 104.0996495089623 11 29.8402934266605 12 -43.53345659001114
   13 96.32455395918828 14 -39.17726167561544 15 -149.72683625798564
"""

# The error estimates of order 5 and 3; to E3 the weights of the step are added.
_ESTIMATES = """
E5: 0 0.01312004499419488 5 -1.2251564463762044 6 -0.4957589496572502 7 1.6643771824549864
   8 -0.35032884874997366 9 0.3341791187130175 10 0.08192320648511571 11 -0.022355307863886294
E3: 0 -0.2440944881889764 8 -0.7338466882816118 11 -0.022058823529411766
"""


def _rows(text: str) -> list[Row]:
    rows: list[Row] = []
    words = iter(text.replace("\n", " ").split())
    for word in words:
        if word.endswith(":"):
            rows.append({})
        else:
            rows[-1][int(word)] = float(next(words))
    return rows


ROWS: list[Row] = [{}, *_rows(_STAGES)]
FIFTH, LESS = _rows(_ESTIMATES)

# Row sums to the last bit, which sums of the rounded coefficients are not.
_EARLY, _LATE = (6 - sqrt(6)) / 30, (6 + sqrt(6)) / 30
NODES = [0.0, 4 / 9 * _EARLY, 2 / 3 * _EARLY, _EARLY, _LATE, 1 / 3, 1 / 4, 4 / 13, 127 / 195, 3 / 5, 6 / 7, 1.0, 1.0]
NODES += [1 / 10, 1 / 5, 7 / 9]


def _dense_weights() -> NDArray[np.float64]:
    """Return (7, 16): Hairer's interpolant by stage; row i is for theta^(i // 2 + 1) (1 - theta)^((i + 1) // 2)."""
    weights = np.zeros((7, 16))
    for j, b in ROWS[12].items():
        weights[:3, j] = b, -b, 2 * b
    weights[1, 0] += 1
    weights[2, [0, 12]] -= 1
    for power, row in enumerate(_rows(_DENSE), start=3):
        weights[power, list(row)] = list(row.values())
    return weights


@cache
def interpolant() -> tuple[list[Row], list[float], NDArray[np.float64]]:
    """Return rows and nodes of four further stages, and (4, 6) weights of six data in the last terms of the polynomial.

    The original interpolant has errors up to a hundred times those of the steps. So it only gives the states for four
    more derivatives; a polynomial of degree 7 fits these and both ends with their derivatives, and its error is that of
    the step. The data are the change over the step, and h f at its end and at the four nodes, each minus h f at the
    start. The terms are those of `_dense_weights`; for plain powers of theta the weights, and so the round-off, would
    be five times as large.
    """
    legendre = np.polynomial.legendre.Legendre.basis(6)
    nodes = np.sort((1 + np.real(legendre.deriv(2).roots())) / 2)  # least remainder if both ends are double nodes
    p, q = np.array([1, 1, 2, 2, 3, 3, 4]), np.array([0, 1, 1, 2, 2, 3, 3])  # theta^p (1 - theta)^q
    basis = nodes[:, None] ** p * (1 - nodes[:, None]) ** q
    rows = [{j: float(a) for j, a in enumerate(row) if a} for row in basis @ _dense_weights()]
    x = np.concatenate([[0.0, 1.0], nodes])[:, None]
    slopes = p * x ** (p - 1) * (1 - x) ** q - q * x**p * (1 - x) ** np.maximum(q - 1, 0)
    weights = np.linalg.inv(np.vstack([q == 0, slopes]))
    return rows, [float(node) for node in nodes], np.delete(weights[3:], 1, axis=1)


KEPT = range(5, 12)  # stages of the step that the interpolant uses
AMPLIFIED = 0.5  # relative difference of derivatives at the end: 0.1 if smooth, 2 if h times a decay rate is 6
# For y' = z y / h, |z| from 6 to 3000, d that difference, S = |k0| + |e8|: inside the step the interpolant errs by
# about 0.1 to 1 h d^2 / S, by 9 if d nearly vanishes. d / S is at most |z|^4 / 2; if it is larger, a force sets in.
INSIDE, SETS_IN = 4.0, 1e16
REACH = 4.0  # change of an argument in a step: 1 - tanh(4) is 7e-4, exp(-4) 0.02, so a pulse is seen from twice as far
# The root sum squares of the weights of both estimates are less: errors N of the rates cause one of 8 h N.
ESTIMATE_ROUNDOFF = 8.0
MOST_CACHED = 16  # components, up to which the code of a step is cached on disk
SWEEPS = (1.0, 2.0, 3.0)  # passes of the bound: the error of a rate shifts other rates, in chains of four


def rates(formulas: Formulas, forgiving: bool = True) -> str:
    """Return source of `rhs`, `reach` and `bends`.

    forgiving : whether to catch errors such as overflow, for Python; compiled code continues with infinity
    """
    reach, bends = _reach(formulas), _bends(formulas)
    if forgiving:
        reach, bends = _forgiving(reach, "inf"), _forgiving(bends, "False")
    rhs = ["def rhs(t, s, c):", *unpacked(formulas, s="s"), *formulas.lines, f"return {tuple_of(formulas.rates)}"]
    return _source([rhs, reach, bends])


def rounding(formulas: Formulas, forgiving: bool = True) -> str:
    """Return source of `roundoff`."""
    roundoff = _roundoff(formulas)
    return _source([_forgiving(roundoff, "b") if forgiving else roundoff])


def stepping(formulas: Formulas, forgiving: bool = True) -> str:
    """Return source of `step`, `cross`, `passed`, `error_norms` and `lesser`."""
    step, cross, nothing = _step(formulas), _cross(formulas), tuple_of(["nan"] * formulas.size)
    parts = [_forgiving(step, "y, r, f, inf, 0.0, ()") if forgiving else step]
    parts += [_forgiving(cross, f"{nothing}, r, f") if forgiving else cross]
    parts += [["def passed(start, h, y, f, n, g, a, error, shortest, c):", "return inf"]]
    return _source([*parts, _error_norms(formulas), _lesser(formulas)])


def sampling(formulas: Formulas) -> str:
    """Return source of `dense` and `at`, for states inside a step."""
    return _source([_dense(formulas), _at(formulas)])


def _source(parts: list[list[str]]) -> str:
    return "\n\n".join("\n    ".join(part) for part in parts) + "\n"


def _forgiving(function: list[str], answer: str) -> list[str]:
    """Return a function that returns `answer` on overflow or a domain error: the step was too long."""
    signature, *body = function
    rescue = ["except (ArithmeticError, ValueError, LookupError):", f"    return {answer}"]
    return [signature, "try:", *(f"    {line}" for line in body), *rescue]


def _combination(row: Row, i: int) -> str:
    """Return the weighted sum of the stages' differences from k0, to which the caller adds the row sum times k0.

    The differences are small, and so is the round-off from weights as large as 43 and of these weights.
    """
    return " + ".join(f"{a!r} * e{j}_{i}" for j, a in row.items() if j)


def _stage(formulas: Formulas, number: int, row: Row, node: float) -> list[str]:
    """Return lines that set e<number>: the derivative at the state given by the earlier stages, minus k0."""
    lines = []
    for i in sorted(formulas.reads):
        sum_ = " + ".join(filter(None, (f"{node!r} * k0_{i}", _combination(row, i))))
        lines.append(f"s{i} = y{i} + h * ({sum_})" if i in formulas.moving else f"s{i} = y{i}")
    return [*lines, *_derivative(formulas, number, f"start + {node!r} * h", " - k0_")]


def _derivative(formulas: Formulas, number: int, time: str, less: str = "") -> list[str]:
    """Return lines that set k<number>, the derivative at s, or e<number> if `less` subtracts k0."""
    clock = [f"t = {time}"] if formulas.timed else []
    letter = "e" if less else "k"
    rates = [f"{letter}{number}_{i} = {formulas.rates[i]}{less and less + str(i)}" for i in formulas.moving]
    return [*clock, *formulas.lines, *rates]


def _roundoff(formulas: Formulas) -> list[str]:
    """Return source of `roundoff`, a bound of the round-off in the error estimates of a step of h.

    A running error bound (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 3.3): each operation adds
    its round-off to the error propagated from its arguments; time and state have errors of half a unit in the last
    place. The bound is evaluated half way through the step, since at the start too many quantities may be exactly zero.
    """
    bounds = formulas.bounds
    lines = ["def roundoff(start, h, y, f, b, c):", *unpacked(formulas, y="y", f="f", b="b")]
    lines += [f"s{i} = y{i} + 0.5 * h * f{i}" for i in sorted(formulas.reads)]
    lines += ["t = start + 0.5 * h", f"b_t = {UNIT_ROUNDOFF!r} * abs(t)", *bounds.values]
    lines += [f"b_s{i} = {UNIT_ROUNDOFF!r} * abs(s{i})" for i in sorted(formulas.reads)]
    lines += [f"x{i} = 0.0" for i in formulas.moving]
    if formulas.moving:
        lines += [f"for sweep in {SWEEPS!r}:", *(f"    {line}" for line in bounds.lines)]
    lines += [f"    x{i} = h * ({bounds.rates[i]})" for i in formulas.moving]
    for i in sorted(formulas.reads & set(formulas.moving)):
        lines.append(f"    b_s{i} = {UNIT_ROUNDOFF!r} * abs(s{i}) + x{i}")
    for i in formulas.moving:
        lines += [f"x{i} = {ESTIMATE_ROUNDOFF!r} * x{i}", f"b{i} = x{i} if x{i} < inf else 0.0"]
    return [*lines, f"return {tuple_of(names('b', formulas.size))}"]


def _reach(formulas: Formulas) -> list[str]:
    """Return source of `reach`: the step in which arguments x of exp, tanh etc. change by max(|x| / 2, REACH) at most.

    Far from zero these functions are constant up to round-off, so an error estimate cannot see what is ahead.
    """
    lines = ["def reach(start, h, y, f, c):"]
    if not formulas.exponents:
        return [*lines, "return inf"]
    reads, values = sorted(formulas.reads), formulas.bounds.values
    lines += [*unpacked(formulas, y="y", f="f"), *(f"s{i} = y{i}" for i in reads), "t = start", *values]
    lines += [f"x{k} = {argument}" for k, argument in enumerate(formulas.exponents)]
    lines += [f"d = {PART!r} * h", *(f"s{i} = y{i} + d * f{i}" for i in reads), "t = start + d", *values]
    lines.append("longest = inf")
    for k, argument in enumerate(formulas.exponents):
        lines += [f"w = abs({argument} - x{k})", f"x = d * max(0.5 * abs(x{k}), {REACH!r})"]
        lines += ["if x < longest * w:", "    longest = x / w"]
    return [*lines, "return longest"]


def _bends(formulas: Formulas) -> list[str]:
    """Return source of `bends`: whether an argument of abs etc. changes sign, at the middle or end of a step."""
    lines = ["def bends(start, h, y, f, n, g, c):"]
    if not formulas.bends:
        return [*lines, "return False"]
    reads, values = sorted(formulas.reads), formulas.bounds.values
    lines += [*unpacked(formulas, y="y", f="f", n="n", g="g"), *(f"s{i} = y{i}" for i in reads), "t = start", *values]
    lines += [f"x{k} = {argument}" for k, argument in enumerate(formulas.bends)]
    lines += [f"s{i} = 0.5 * (y{i} + n{i}) + 0.125 * h * (f{i} - g{i})" for i in reads]
    lines += ["t = start + 0.5 * h", *values, "least = 0.0"]
    lines += [f"least = min(least, {argument} * x{k})" for k, argument in enumerate(formulas.bends)]
    lines += [*(f"s{i} = n{i}" for i in reads), "t = start + h", *values]
    lines += [f"least = min(least, {argument} * x{k})" for k, argument in enumerate(formulas.bends)]
    return [*lines, "return least < 0.0"]


def _lesser(formulas: Formulas) -> list[str]:
    lines = ["def lesser(a, b):", *unpacked(replace(formulas, constants=0), a="a", b="b")]
    return [*lines, f"return {tuple_of(f'a{i} if a{i} < b{i} else b{i}' for i in range(formulas.size))}"]


def _step(formulas: Formulas) -> list[str]:
    """Return source of a step of h from (t, y): state, compensation, derivative, squared error estimates, stages.

    k_i = f(t + c_i h, y + h sum of a_ij k_j over j < i) for i = 0 ... 11, and n = y + h sum of b_i k_i, with `NODES` c
    and `ROWS` a and b (Hairer, Norsett, Wanner, II.1 and II.5). Written with e_i = k_i - k_0, as a row of a adds up to
    c_i: y + h (c_i k_0 + sum of a_ij e_j).

    step(start, h, y, r, f, a, b, rtol, c) takes y, r, f, a, b of k numbers each and returns n, r, f (k each), both
    estimates, and the stages that the interpolant uses.
    """
    lines = ["def step(start, h, y, r, f, a, b, rtol, c):", *unpacked(formulas, y="y", r="r", f="k0_", a="a", b="b")]
    for number in range(1, 12):
        lines += _stage(formulas, number, ROWS[number], NODES[number])
    lines += [f"u{i} = {_combination(ROWS[12], i)}" for i in formulas.moving]
    lines += [*_update(formulas, "(k0_{i} + u{i})"), *_estimates(formulas)]
    return [*lines, f"return {_new_state(formulas)}, fifth, third, {tuple_of(_kept(formulas))}"]


def _cross(formulas: Formulas) -> list[str]:
    """Return source of `cross`: an Euler step, which uses only rates before a jump, and the derivative at its end."""
    lines = ["def cross(start, h, y, r, f, c):", *unpacked(formulas, y="y", r="r", f="k0_")]
    return [*lines, *_update(formulas, "k0_{i}"), f"return {_new_state(formulas)}"]


def _new_state(formulas: Formulas) -> str:
    """Return source of the new state, its compensation and its derivative."""
    return ", ".join(tuple_of(names(letter, formulas.size)) for letter in ("n", "r", "k12_"))


def _error_norms(formulas: Formulas) -> list[str]:
    """Return source of `error_norms`: the squared estimates of a tried step for part of the tolerance and a new b."""
    lines = ["def error_norms(h, y, n, f, g, a, b, part, rtol, stages):"]
    lines += unpacked(replace(formulas, constants=0), y="y", n="n", f="k0_", g="k12_", a="a", b="b")
    lines += [f"{tuple_of(_kept(formulas))} = stages"]
    for i in formulas.moving:
        lines += [f"a{i} = part * a{i}", f"u{i} = {_combination(ROWS[12], i)}"]
    return [*lines, *_estimates(formulas), "return fifth, third"]


def _kept(formulas: Formulas) -> list[str]:
    return [f"e{j}_{i}" for j in KEPT for i in formulas.moving]


def _update(formulas: Formulas, rate: str) -> list[str]:
    """Return lines of a compensated sum (Kahan), which carries round-off to the next step, and the new derivative."""
    lines = []
    for i in range(formulas.size):
        if i in formulas.moving:
            lines += [f"d = r{i} + h * {rate.format(i=i)}", f"n{i} = y{i} + d", f"r{i} = d - (n{i} - y{i})"]
        else:
            lines += [f"n{i} = y{i}", f"k12_{i} = 0.0"]
    return [*lines, *(f"s{i} = n{i}" for i in sorted(formulas.reads)), *_derivative(formulas, 12, "start + h")]


def _estimates(formulas: Formulas) -> list[str]:
    """Return lines that set both squared error estimates; an unstable step has an error of 6 to 60 tolerances."""
    lines = ["fifth = third = 0.0", "is_unstable = False"]
    for i in formulas.moving:
        lines += _estimate(i)
    return [*lines, "if is_unstable:", "    fifth += 36.0 + 6.0 * sqrt(third)"]  # about half the step is tried next


def _estimate(i: int) -> list[str]:
    """Return lines that add component i to both error estimates.

    Stage 11 is at the end of the step, like the new state. If their derivatives differ, the step is outside the region
    of stability: the error of a decaying component may be small at the end of the step and large inside, where the
    interpolant amplifies it further.
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
        f"x = abs(k0_{i}) + abs(e8_{i})",
        f"inside = w * d * d > {INSIDE!r} * x and {SETS_IN!r} * x > d",
        f"if (w * d > 1.0 or inside) and a{i} > {NO_SCALE!r} and d > {AMPLIFIED!r} * (x + abs(k12_{i})):",
        "    is_unstable = True",
    ]


def _dense(formulas: Formulas) -> list[str]:
    """Return source of `dense`: coefficients of the interpolant by component, the first three from the ends alone."""
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
    """Return source of `at`, which writes the state at the fraction x of a step into row `row` of `out`."""
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
    """Return the functions by name; called_function : the right-hand side if it is called.

    Steps call `rhs`, so that all of one size share their code, which takes longer to compile than most rates.
    Functions that never limit a step are None.
    """
    namespace: dict[str, Numbers] = {**vars(math), "rhs": called_function, "dense": None, "at": None}
    if called_function is None:
        exec(_code(rates, formulas), namespace)
    for write in (stepping, sampling)[: 1 + sampled]:
        exec(_loop_code(write, formulas.size, formulas.timed), namespace)
    raw_rhs, nothing = namespace["rhs"], (math.nan,) * formulas.size

    def rhs(t: float, s: Numbers, c: Numbers) -> Numbers:
        try:
            return raw_rhs(t, s, c)
        except (ArithmeticError, ValueError, LookupError):
            return nothing

    def roundoff(*inputs: Numbers) -> Numbers:
        exec(_code(rounding, formulas), namespace)  # on demand, as most runs need none
        return namespace["roundoff"](*inputs)

    needed = {"passed": False, "reach": formulas.exponents, "bends": formulas.bends}
    unneeded = {name: None for name, is_needed in needed.items() if not is_needed}
    return {**namespace, "rhs": rhs, "roundoff": roundoff, **unneeded}


@lru_cache(maxsize=256)
def _code(write: Callable[[Formulas], str], formulas: Formulas) -> CodeType:
    return compile(write(formulas), "<tam570 step>", "exec")


@lru_cache(maxsize=256)
def _loop_code(write: Callable[[Formulas], str], size: int, timed: bool) -> CodeType:
    text = write(call_of(size, timed))
    compiled = partial(compile, text, "<tam570 step>", "exec")
    name = f"{write.__name__}{size}{'timed' if timed else ''}"
    return cached_code(__file__, name, text.encode(), compiled) if size <= MOST_CACHED else compiled()
