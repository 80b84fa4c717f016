"""Reference states to 30 digits: Taylor series of order 40 in mpmath, from the traced right-hand side."""

import ast
import functools

import mpmath

from tam570.integrate.formulas import written
from tam570.integrate.trace import traced

DIGITS, ORDER = 38, 40


class Series:
    """A node of the formulas with its Taylor coefficients so far; `rule(k)` gives the next."""

    def __init__(self, rule):
        self.coefficients, self.rule = [], rule

    def upto(self, k):
        while len(self.coefficients) <= k:
            self.coefficients.append(self.rule(len(self.coefficients)))
        return self.coefficients


def _constant(value):
    return Series(lambda k: mpmath.mpf(value) if k == 0 else mpmath.mpf(0))


def _dot(a, b, k, first=0, last=0):
    """sum of a_j b_(k - j), j from `first` to k - `last`."""
    a, b = a.coefficients, b.coefficients
    return mpmath.fdot((a[j], b[k - j]) for j in range(first, k + 1 - last))


def _product(a, b):
    def rule(k):
        a.upto(k), b.upto(k)
        return _dot(a, b, k)

    return Series(rule)


def _quotient(a, b):
    def rule(k):
        a.upto(k), b.upto(k)
        rest = mpmath.fdot((q.coefficients[j], b.coefficients[k - j]) for j in range(k))
        return (a.coefficients[k] - rest) / b.coefficients[0]

    q = Series(rule)
    return q


def _root(a):
    def rule(k):
        a.upto(k)
        if k == 0:
            return mpmath.sqrt(a.coefficients[0])
        rest = mpmath.fdot((r.coefficients[j], r.coefficients[k - j]) for j in range(1, k))
        return (a.coefficients[k] - rest) / (2 * r.coefficients[0])

    r = Series(rule)
    return r


def _sine_and_cosine(a):
    def of(start, other, sign):
        def rule(k):
            a.upto(k)
            if k == 0:
                return start(a.coefficients[0])
            other[0].upto(k - 1)
            products = ((j * a.coefficients[j], other[0].coefficients[k - j]) for j in range(1, k + 1))
            return sign * mpmath.fdot(products) / k

        return Series(rule)

    cosine_later = []
    sine = of(mpmath.sin, cosine_later, 1)
    cosine = of(mpmath.cos, [sine], -1)
    cosine_later.append(cosine)
    return sine, cosine


def _exponential(a):
    def rule(k):
        a.upto(k)
        if k == 0:
            return mpmath.exp(a.coefficients[0])
        return mpmath.fdot((j * a.coefficients[j], e.coefficients[k - j]) for j in range(1, k + 1)) / k

    e = Series(rule)
    return e


def _added(a, b, sign):
    return Series(lambda k: a.upto(k)[k] + sign * b.upto(k)[k])


def _node(tree, names, pairs):
    """The series of an expression of the generated source."""
    if isinstance(tree, ast.Name):
        return names[tree.id]
    if isinstance(tree, ast.Constant):
        return _constant(tree.value)
    if isinstance(tree, ast.UnaryOp):
        inner = _node(tree.operand, names, pairs)
        return Series(lambda k: -inner.upto(k)[k])
    if isinstance(tree, ast.BinOp):
        a, b = _node(tree.left, names, pairs), _node(tree.right, names, pairs)
        if isinstance(tree.op, ast.Add | ast.Sub):
            return _added(a, b, 1 if isinstance(tree.op, ast.Add) else -1)
        return _product(a, b) if isinstance(tree.op, ast.Mult) else _quotient(a, b)
    return _called(tree.func.id, [_node(a, names, pairs) for a in tree.args], pairs, ast.dump(tree.args[0]))


def _called(name, arguments, pairs, key):
    if name in ("sin", "cos"):
        if key not in pairs:
            pairs[key] = _sine_and_cosine(arguments[0])
        return pairs[key][name == "cos"]
    if name == "exp":
        return _exponential(arguments[0])
    if name == "sqrt":
        return _root(arguments[0])
    if name == "hypot":
        return _root(_added(*(_product(a, a) for a in arguments), 1))
    raise NotImplementedError(name)


def _expansion(formulas, constants, state, t):
    """Taylor coefficients of the solution through `state`: (k, ORDER + 1)."""
    series = [Series(None) for _ in state]
    names = {f"s{i}": s for i, s in enumerate(series)} | {f"c{i}": _constant(c) for i, c in enumerate(constants)}
    names["t"] = Series(lambda k: t if k == 0 else mpmath.mpf(k == 1))
    pairs = {}
    for line in formulas.lines:
        target, expression = line.split(" = ", 1)
        names[target] = _node(ast.parse(expression, mode="eval").body, names, pairs)
    rates = [_node(ast.parse(rate, mode="eval").body, names, pairs) for rate in formulas.rates]
    for s, x, rate in zip(series, state, rates, strict=True):
        s.rule = lambda k, x=x, rate=rate: x if k == 0 else rate.upto(k - 1)[k - 1] / k
    return [s.upto(ORDER) for s in series]


def end_state(scene):
    """(k,) mpf, the state at the end of the scene; its numbers are taken as the doubles that they are."""
    rhs, start, parameters, end = scene
    formulas, constants = written(traced(functools.partial(rhs, **parameters), len(start)))
    with mpmath.workdps(DIGITS):
        state, t, end = [mpmath.mpf(x) for x in start], mpmath.mpf(0), mpmath.mpf(end)
        while t < end:
            expansion = _expansion(formulas, constants, state, t)
            size = max(max(abs(c) for c in s[:4]) for s in expansion)  # at rest the first are zero
            last = max(max(abs(s[ORDER]), abs(s[ORDER - 1])) for s in expansion) / size
            h = end - t if last == 0 else min((mpmath.mpf(10) ** -DIGITS / last) ** (mpmath.mpf(1) / ORDER), end - t)
            state = [mpmath.polyval(s[::-1], h) for s in expansion]
            t += h
        return state
