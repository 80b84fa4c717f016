"""Many starts of one system at once: each element of an array is a member, with a time and a step of its own."""

import time
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from tam570.integrate import adaptive
from tam570.integrate.adaptive_loop import (
    EXPONENT,
    JUMP,
    LACKS_SCALE,
    LARGEST,
    NOT_FINITE,
    PLAUSIBLE,
    SAFETY,
    SMALLEST,
    TOO_SHORT,
    UNKNOWN,
    State,
    let_pass,
)
from tam570.integrate.arguments import Array
from tam570.integrate.dop853_source import array_functions
from tam570.integrate.engine import Engine
from tam570.integrate.formulas import Formulas
from tam570.integrate.symbols import FUNCTIONS
from tam570.integrate.when_to_compile import seconds_until_compiled

__all__ = ["states"]

WORTH_ARRAYS = 16  # members: with fewer the calls of NumPy cost more than they save
GAIN = 3.0  # of the arrays over single runs in Python, with thousands of members


def states(engine: Engine, times: Array, starts: Array, rtol: float, how: str, floor: Sequence[float]) -> Array:
    """(m, n, k) states at `times` from the (m, k) starts; how: "auto", "python" or "compiled"."""
    began = time.perf_counter()
    first = adaptive.states(engine, times, starts[0], rtol, how, floor)
    alone = (time.perf_counter() - began) * len(starts)
    compiled = how == "compiled" or (how == "auto" and _compiling_repays(engine, alone))
    if engine.traced and not compiled and len(starts) >= WORTH_ARRAYS:
        return _Members(engine, times, starts, rtol, floor).walked()
    one_by_one = "compiled" if compiled else "python"
    rows = np.empty((len(starts), *first.shape))
    rows[:, 0], rows[0] = starts, first
    done = np.arange(len(starts)) == 0
    if compiled and engine.graph is not None and len(starts) >= WORTH_ARRAYS:
        from tam570.integrate.compiled import backend

        done = backend.taylor_runs(engine.graph, float(times[0]), times - times[0], rows, rtol, starts, floor)
    for i in np.flatnonzero(~done):
        rows[i] = adaptive.states(engine, times, starts[i], rtol, one_by_one, floor)
    return rows


def _compiling_repays(engine: Engine, seconds_alone: float) -> bool:
    if engine.graph is None:
        return False
    return seconds_alone / GAIN > seconds_until_compiled(len(engine.graph.operations))


@lru_cache(maxsize=64)
def _functions(formulas: Formulas) -> dict[str, Any]:
    numpy_name = {plain: name for name, plain in FUNCTIONS.items() if name.startswith("arc")}
    names = [name for name in FUNCTIONS.values() if hasattr(np, numpy_name.get(name, name))]
    namespace = {name: getattr(np, numpy_name.get(name, name)) for name in names}
    namespace |= {"pow": np.power, "maximum": np.maximum, "absolute": np.absolute}
    exec(compile(array_functions(formulas), "<tam570 arrays>", "exec"), namespace)
    return namespace


class _Members:
    """The members still under way; y, r, f, m are (k, members), all else is (members,)."""

    def __init__(self, engine: Engine, times: Array, starts: Array, rtol: float, floor: Sequence[float]) -> None:
        self.engine = engine
        self.functions, self.c, self.rtol = _functions(engine.formulas), engine.constants, rtol
        self.origin, self.since = float(times[0]), times - times[0]
        self.rows = np.empty((len(starts), len(times), starts.shape[1]))
        self.rows[:, 0] = starts
        each = [adaptive.at_start(engine, self.origin, float(self.since[-1]), start, floor) for start in starts]
        self.who, self.row = np.arange(len(starts)), np.ones(len(starts), dtype=int)
        self.t, self.h = np.zeros(len(starts)), np.array([state.h for state in each])
        self.y, self.r, self.f, self.m = (np.array([getattr(state, name) for state in each]).T for name in "yrfm")
        self.growth = np.full(len(starts), LARGEST)
        self.refused = np.zeros(len(starts))  # steps, one after the other

    def walked(self) -> Array:
        """Step until every member has reached the end."""
        while len(self.who):
            self._step()
            self._keep(self.row < len(self.since))
        return self.rows

    def _step(self) -> None:
        left = self.since[-1] - self.t
        self.h = np.maximum(self.h, self._shortest())
        last = self.h >= left
        new = np.where(last, self.since[-1], self.t + np.where(2 * self.h < left, self.h, left / 2))
        h = np.where(last, left, new - self.t)
        step, start = self.functions["step"], self.origin + self.t
        n, r, g, m, fifth, third, stages = step(start, h, self.y, self.r, self.f, self.m, self.c)
        error = np.where(fifth > 0, fifth / (self.rtol * np.sqrt(fifth + 0.01 * third)), fifth)
        error = np.where(error < 1, np.maximum(error, PLAUSIBLE / self.rtol * third**1.125), error)
        fine = error <= 1
        if not fine.all():
            fine |= self._passed(h, np.array(_rows(n, h)), error)
        self._sample(fine, new, h, np.array(n), _rows(g, h), stages)
        self.refused = np.where(fine, 0.0, self.refused + 1.0)
        factor = np.clip(SAFETY * np.where(error > 0, error, 1e-30) ** EXPONENT, SMALLEST, self.growth)
        self.h = h * np.where(np.isfinite(error), factor, 0.1)
        self.growth = np.where(fine, LARGEST, 1.0)
        self._forgive((self.refused > 1) | (self.refused > 0) & (fifth > 0.01 * third))
        self.t = np.where(fine, new, self.t)
        for name, value in (("y", n), ("r", r), ("f", g), ("m", m)):
            setattr(self, name, np.where(fine, _rows(value, h), getattr(self, name)))

    def _shortest(self) -> Any:
        return np.maximum(2.0**-50 * self.t, 1e-17 * self.since[-1])

    def _passed(self, h: Array, n: Array, error: Array) -> Any:
        """Which of the refused steps pass as jumps; what has no scale and moves gets one, as in `adaptive_loop`."""
        lacking: Any = ~(error <= 1) & ((self.m <= UNKNOWN) & (np.abs(n) > UNKNOWN)).any(axis=0)
        last = ~(error <= 1) & (self.h == self._shortest())
        finite: Any = np.isfinite(n).all(axis=0)
        passed = last & finite & (lacking | (error * self.rtol <= JUMP))
        for i in np.flatnonzero(last & ~passed)[:1]:
            kind = TOO_SHORT if finite[i] else NOT_FINITE
            raise ArithmeticError(adaptive.TROUBLE[kind].format(t=self.engine.sign * (self.origin + self.t[i])))
        for i in np.flatnonzero(lacking & ~passed):
            y, f, m = (tuple(values[:, i].tolist()) for values in (self.y, self.f, self.m))
            state = State(0, float(self.t[i]), float(h[i]) / 10, y, y, f, m, 0.0, 0, 0, 0, LACKS_SCALE)
            self.m[:, i] = adaptive.scaled(self.engine, self.origin, state, self.rtol).m
        return passed

    def _sample(self, fine: Any, new: Array, h: Array, n: Array, g: Array, stages: Any) -> None:
        """Fill the rows that the steps taken have reached."""
        due = np.flatnonzero(fine & (self.since[np.minimum(self.row, len(self.since) - 1)] <= new))
        if not len(due):
            return
        part = [s[due] if np.ndim(s) else s for s in stages]
        start, y, inside = self.origin + self.t[due], self.y[:, due], self.functions
        q = inside["dense"](start, h[due], y, n[:, due], self.f[:, due], g[:, due], part, self.c)
        flat = self.rows.reshape(-1, self.rows.shape[2])
        while len(due):
            at_end = self.since[self.row[due]] == new[due]
            x = np.where(at_end, 1.0, (self.since[self.row[due]] - self.t[due]) / h[due])
            inside["at"](flat, self.who[due] * len(self.since) + self.row[due], x, self.y[:, due], q)
            self.rows[self.who[due[at_end]], self.row[due[at_end]]] = n[:, due[at_end]].T
            self.row[due] += 1
            more = self.row[due] < len(self.since)
            more[more] = self.since[self.row[due[more]]] <= new[due[more]]
            due, q = due[more], [c[more] if np.ndim(c) else c for c in q]

    def _forgive(self, doubtful: Any) -> None:
        """Raise the magnitudes of members whose error may be but rounding, as in `adaptive_loop`."""
        i = np.flatnonzero(doubtful)
        if len(i):
            start, y, f, m, h = self.origin + self.t[i], self.y[:, i], self.f[:, i], self.m[:, i], self.h[i]
            weight, wider = let_pass(self.rtol), 2.0 * self.refused[i] - 1.0
            raised = self.functions["raised"](start, h, y, f, m, self.c, weight, wider)
            self.m[:, i] = _rows(raised, h)

    def _keep(self, going: Any) -> None:
        if going.all():
            return
        for name in ("who", "row", "t", "h", "growth", "refused"):
            setattr(self, name, getattr(self, name)[going])
        for name in ("y", "r", "f", "m"):
            setattr(self, name, getattr(self, name)[:, going])


def _rows(values: Any, like: Array) -> Array:
    """(k, members) of k arrays or numbers."""
    return np.array([np.broadcast_to(value, like.shape) for value in values])
