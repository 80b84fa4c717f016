"""Two methods with a fixed step size for long runs, which preserve the structure of mechanics.

"gauss": Gauss-Legendre collocation with six stages, order 12, symplectic and symmetric for any Hamiltonian. Each
coefficient is the sum of two doubles; rounded to one, they make the energy drift. Hairer, McLachlan, Razakarivony,
Achieving Brouwer's law with implicit Runge-Kutta methods, BIT 2008.
"composition": 17 leapfrog steps, order 8, symmetric, for a state (q, v) where q' depends only on v and v' only on q.
Constants of Kahan and Li, Composition constants for raising the orders of unconventional schemes, 1997.
"""

import math
from collections.abc import Callable
from decimal import Decimal, localcontext
from functools import cache, lru_cache, partial
from math import inf
from typing import NamedTuple

import numpy as np

from tam570.integrate.adaptive import FOREVER, Control, shortest_step
from tam570.integrate.arguments import Array
from tam570.integrate.engine import Engine
from tam570.integrate.formulas import Formulas, halves, names, tuple_of, unpacked
from tam570.integrate.watch import COMPILED, repays
from tam570.values import Function, Numbers

METHODS = {"gauss": 3.5, "composition": 0.5}  # step size in units of the shortest step of DOP853 at the same rtol
SWEEPS = {"gauss": 0.7, "composition": 0.1}  # passes through the source per step, over the 12 stages of `repays`
LOOK_AHEAD = 10.0  # steps, in which adaptive steps may show why a step has no finite end
DIGITS = 45  # decimal digits of the tableau before it is split
NODES = """0.033765242898423986093849222753002695432617131144 0.169395306766867743169300202490047326496775717802
0.380690406958401545684749139159644032290694684930"""  # zeros of Legendre's polynomial on (0, 1), first half
LEAPS = """0.13020248308889008087881763 0.56116298177510838456196441 -0.38947496264484728640807860
0.15884190655515560089621075 -0.39590389413323757733623154 0.18453964097831570709183254
0.25837438768632204729397911 0.29501172360931029887096624 -0.60550853383003451169892108"""  # the first half, and middle

Pair = tuple[float, float]  # a number rounded to a double, and the remainder


class FixedState(NamedTuple):
    """State of a run."""

    row: int  # the next sample
    done: int  # number of steps
    y: tuple[float, ...]
    r: tuple[float, ...]  # compensation: round-off lost from y (Kahan)
    k: tuple[float, ...]  # initial guess for the stages of the next step
    halt: int = 0  # 1 if the next step has no finite end


def fixed_loop_with(leap: Function) -> Callable[..., FixedState]:
    """Return the loop over the steps of a run."""

    def march(
        origin: Numbers, times: Numbers, out: Numbers, state: Numbers, c: Numbers, h: Numbers, budget: Numbers
    ) -> Numbers:
        """Fill the rows of `out` until none is left, `budget` steps are done, or a step has no finite end.

        times : since `origin`; state : a `FixedState`, as returned. A sample inside a step is computed by an
        extra, shorter step from the start of the step.
        """
        row, done, y, r, k, halt = state
        while row < len(times) and budget > 0 and halt == 0:
            budget -= 1
            t = done * h  # not a running sum, whose round-off would grow
            n, rest, onward = leap(origin + t, h, y, r, k, c)
            size = 0.0
            for i in range(len(n)):
                size += abs(n[i])
            halt = 0 if size < inf else 1
            while halt == 0 and row < len(times) and times[row] <= t + h * (1.0 + 2.0**-40):
                sample = n
                if times[row] < t + h * (1.0 - 2.0**-40):  # else the sample is at the end, up to round-off
                    sample = leap(origin + t, times[row] - t, y, r, k, c)[0]
                for i in range(len(n)):
                    out[row, i] = sample[i]
                row += 1
            if halt == 0:
                y, r, k, done = n, rest, onward, done + 1
        return FixedState(row, done, y, r, k, halt)

    return march


def composition_source(drift: Formulas, kick: Formulas, constants: int) -> str:
    """Return source of leap(start, h, y, r, k, c): drifts change q, kicks change v, with compensated sums."""
    half = len(drift.rates)
    leaps = [float(leap) for leap in (*LEAPS.split(), *LEAPS.split()[-2::-1])]
    drifts = [(a + b) / 2 for a, b in zip([0.0, *leaps], [*leaps, 0.0], strict=True)]
    pairs = tuple_of(f"({d!r}, {k!r})" for d, k in zip(drifts, [*leaps, 0.0], strict=True))
    s, r, c = tuple_of(names("s", 2 * half)), tuple_of(names("r", 2 * half)), names("c", constants)
    lines = [f"{s} = y", f"{r} = r", *([f"{tuple_of(c)} = c"] if constants else []), f"for d, k_ in {pairs}:"]
    for fraction, formulas, first in (("d", drift, 0), ("k_", kick, half)):
        lines += [f"    {line}" for line in formulas.lines]
        for i, rate in enumerate(formulas.rates, start=first):
            lines.append(f"    d{i} = {fraction} * h * {rate}")
        for i in range(first, first + len(formulas.rates)):
            moved = [*sum_and_error(f"s{i}", f"d{i}"), f"rest = r{i} + error"]
            lines += [f"    {line}" for line in (*moved, f"s{i} = n + rest", f"r{i} = rest - (s{i} - n)")]
    lines.append(f"return {s}, {r}, k")
    return "\n    ".join(["def leap(start, h, y, r, k, c):", *lines]) + "\n"


@cache
def gauss_tableau() -> tuple[list[list[Pair]], list[Pair], list[float], list[list[float]]]:
    """Return coefficients and weights, each split in two doubles; nodes; matrix that predicts the next stages."""
    polyval: Function = np.polynomial.polynomial.polyval
    with localcontext() as context:
        context.prec = DIGITS
        half = [Decimal(x) for x in NODES.split()]
        nodes = [*half, *(1 - x for x in reversed(half))]
        lagrange = []
        for j, stage in enumerate(nodes):
            basis: Numbers = [Decimal(1)]
            for node in nodes[:j] + nodes[j + 1 :]:
                basis = np.convolve(basis, [-node / (stage - node), 1 / (stage - node)])
            lagrange.append(basis)
        sums = [[Decimal(0), *(c / (power + 1) for power, c in enumerate(basis))] for basis in lagrange]
        rows = [[_split(polyval(node, s)) for s in sums] for node in nodes]
        weights = [_split(polyval(Decimal(1), s)) for s in sums]
        onward = [[float(polyval(node + 1, basis)) for basis in lagrange] for node in nodes]
        return rows, weights, [float(node) for node in nodes], onward


def _split(x: Decimal) -> Pair:
    return float(x), float(x - Decimal(float(x)))


def gauss_source(formulas: Formulas) -> str:
    """Return source of leap(start, h, y, r, k, c): new state, compensation, guess for the next stages' derivatives."""
    rows, weights, nodes, onward = gauss_tableau()
    size = formulas.size
    stages = tuple_of(f"k{j}_{i}" for j in range(len(nodes)) for i in range(size))
    lines = [*unpacked(formulas, y="y", r="r"), f"{stages} = k", "change = inf", "sweep = 0"]
    lines += ["while sweep < 60:", "    sweep += 1", "    before = change", "    change = 0.0"]
    for number, (row, node) in enumerate(zip(rows, nodes, strict=True)):
        lines += [f"    {line}" for line in _collocation(formulas, number, row, node)]
    # Iterate until the change stops shrinking, since it is then round-off.
    lines += ["    if change == 0.0 or (change >= before and sweep > 3):", "        break"]
    lines += ["if not change < 1e-9 * (1.0 + first):", "    y0 = nan"]  # no convergence: the step is too long
    for i in range(size):
        low, high = (" + ".join(f"{w[part]!r} * k{j}_{i}" for j, w in enumerate(weights)) for part in (1, 0))
        lines += [f"d = h * ({high})", f"rest = h * ({low}) + r{i}", *sum_and_error(f"y{i}", "d")]
        # Adding `rest` to d first would give round-off of the same sign at every step.
        lines += ["rest += error", f"n{i} = n + rest", f"r{i} = rest - (n{i} - n)"]
    guesses = (" + ".join(f"{w!r} * k{j}_{i}" for j, w in enumerate(row)) for row in onward for i in range(size))
    lines.append(f"return {tuple_of(names('n', size))}, {tuple_of(names('r', size))}, {tuple_of(guesses)}")
    return "\n    ".join(["def leap(start, h, y, r, k, c):", *lines]) + "\n"


def sum_and_error(y: str, d: str) -> list[str]:
    """Return lines for n = y + d and its round-off; d - (n - y) would have a systematic error where y passes zero."""
    return [f"n = {y} + {d}", f"part = n - {y}", f"error = ({y} - (n - part)) + ({d} - part)"]


def _collocation(formulas: Formulas, number: int, row: list[Pair], node: float) -> list[str]:
    """Return lines that update the derivatives of a stage from the latest ones of all stages (Gauss-Seidel)."""
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


def states(method: str, engine: Engine, times: Array, start: Array, control: Control, step: float | None) -> Array:
    """Return (n, k) states at `times`; ArithmeticError, with the reason, if a step has no finite end."""
    engine.begin(control.rtol)
    rows = np.full((len(times), len(start)), math.nan)
    rows[0] = start
    origin, since = float(times[0]), times - times[0]
    listed, h = since.tolist(), _step(method, engine, times, start, control, step)
    source, constants = _source(method, engine, len(start))
    namespace = {**vars(math), "rhs": engine.called_rates}
    exec(_code(source), namespace)
    python = fixed_loop_with(namespace["leap"])

    def run(march: Function, since: Numbers, state: Numbers, budget: int) -> Numbers:
        return march(origin, since, rows, state, constants, h, budget)

    def share(state: Numbers) -> float:
        return 1.0 if state.row == len(rows) or state.halt else min(state.done * h / listed[-1], 0.999)

    y = tuple(start.tolist())
    stages = engine.functions["rhs"](origin, y, engine.constants) * len(gauss_tableau()[2])
    state = FixedState(1, 0, y, (0.0,) * len(y), stages if method == "gauss" else (0.0,))
    lines = source.count("\n")
    if engine.is_traced and repays(SWEEPS[method] * listed[-1] / h, lines):
        try:
            from tam570.integrate.compiled import backend

            compiled = backend.fixed(source, len(start), len(state.k), len(constants))
            last = backend.by_moments(partial(run, compiled, since), share, state)
        except (ImportError, OSError, RuntimeError):  # llvmlite is broken: continue in Python
            last = run(python, listed, state, FOREVER)
    else:
        last = run(python, listed, state, FOREVER)
    if last.halt or not np.isfinite(rows).all():
        t = origin + last.done * h
        shortest_step(engine, np.array([t, t + LOOK_AHEAD * h]), np.array(last.y), control)  # it raises a better reason
        raise ArithmeticError(f"steps of {h:.3g} s are too long near t = {engine.sign * t:.6g}: give a shorter `step`")
    return rows


def _step(method: str, engine: Engine, times: Array, start: Array, control: Control, step: float | None) -> float:
    """Return a step size, s, that divides the run: at most `step`, by default what the tolerance allows."""
    if step is not None and not 0 < step < math.inf:
        raise ValueError(f"step: must be positive and finite, got {step!r}")
    span = float(times[-1] - times[0])
    longest = step or METHODS[method] * shortest_step(engine, times, start, control)
    if step is None and span > COMPILED * longest:
        raise ValueError(
            f"method: {span / longest:.1g} steps of one length, {longest:.1g} s, are too many; "
            'try "auto", or give a longer `step`'
        )
    return span / math.ceil(span / longest)


def _source(method: str, engine: Engine, size: int) -> tuple[str, tuple[float, ...]]:
    if method == "gauss":
        return gauss_source(engine.formulas), engine.constants
    if engine.graph is None or size % 2:
        raise ValueError('method: "composition" needs a state (q, v) and a plain rhs without branches; try "gauss"')
    drift, kick, constants = halves(engine.graph)
    half = size // 2
    if drift.timed or kick.timed or min(drift.reads, default=half) < half or max(kick.reads, default=0) >= half:
        raise ValueError('method: "composition" needs q\' from v alone and v\' from q alone; try "gauss"')
    return composition_source(drift, kick, len(constants)), constants


@lru_cache(maxsize=64)
def _code(source: str) -> Numbers:
    return compile(source, "<tam570 leap>", "exec")
