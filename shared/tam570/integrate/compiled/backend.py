"""Runs of the engine in compiled code: the same states in and out, a moment of the run at a time."""

import time
from collections.abc import Callable
from functools import lru_cache, partial
from types import ModuleType
from typing import Any

import numpy as np

from tam570.integrate import adaptive_loop, fixed_loop
from tam570.integrate.adaptive_loop import State
from tam570.integrate.arguments import Array
from tam570.integrate.compiled import loops, taylor, taylor_loop
from tam570.integrate.compiled.llvm import function
from tam570.integrate.compiled.recurrences import NotAnalytic, Recurrences, recurrences
from tam570.integrate.compiled.series import layout
from tam570.integrate.dop853_source import functions
from tam570.integrate.fixed_loop import FixedState
from tam570.integrate.formulas import Formulas
from tam570.integrate.trace import Graph

__all__ = ["READY", "analytic", "by_moments", "dop853", "fixed", "taylor_run"]

MOMENT = 0.05  # s in compiled code, after which Python may look for an interrupt
READY: set[Any] = set()  # what was compiled or loaded by this process


@lru_cache(maxsize=256)
def analytic(graph: Graph) -> tuple[Recurrences, tuple[float, ...]] | None:
    """The recurrences of a graph and their constants, if it has any."""
    try:
        return recurrences(graph)
    except NotAnalytic:
        return None


@lru_cache(maxsize=256)
def _taylor(found: Recurrences) -> Any:
    return function(repr(found), lambda: taylor.taylor_text(found), "advance", taylor.KINDS)


def taylor_run(graph: Graph, origin: float, times: Array, out: Array, rtol: float, state: State) -> State:
    """The state at the end, or where Taylor's method cannot go on; times since `origin`."""
    known = analytic(graph)
    if known is None:
        return state
    found, constants = known
    (advance, _), order, place = _taylor(found), taylor.order_for(rtol), layout(found, 1)
    size = len(state.y)
    z, work, c, clock = np.zeros(taylor_loop.memory(size)), np.zeros(place.doubles), np.array(constants), np.zeros(1)
    parts = z[taylor_loop.NUMBERS :].reshape(-1)[: 3 * size].reshape(3, size)
    parts[:] = state.y, state.r, state.m
    z[[taylor_loop.ROW, taylor_loop.T, taylor_loop.NEW, taylor_loop.LONGEST]] = state.row, state.t, state.t, state.h
    work[: size * place.stride].reshape(size, place.stride)[:, 0] = state.y
    arrays = [a.ctypes.data for a in (z, work, clock, c, times)]

    def some(budget: int) -> bool:
        advance(*arrays, len(times), out.ctypes.data, origin, rtol, order, budget)
        return bool(z[taylor_loop.STATUS] == taylor_loop.RUNNING)

    _by_moments(some)
    steps, refusals = (int(z[i]) for i in (taylor_loop.STEPS, taylor_loop.REFUSALS))
    y, r, m = (tuple(part.tolist()) for part in parts)
    return state._replace(
        row=int(z[taylor_loop.ROW]),
        t=float(z[taylor_loop.T]),
        h=float(z[taylor_loop.LONGEST]),
        y=y,
        r=r,
        m=m,
        steps=state.steps + steps,
        refusals=state.refusals + refusals,
    )


def _by_moments(some: Callable[[int], bool]) -> None:
    """Call until it says no, with so many steps at a time that an interrupt is heard."""
    budget = 1000
    while True:
        began = time.perf_counter()
        if not some(budget):
            return
        if time.perf_counter() - began < MOMENT:
            budget *= 2


def by_moments(run: Callable[[Any, int], Any], share: Callable[[Any], float], state: Any) -> Any:
    """The state at the end of run(state, budget), called again and again."""

    def some(budget: int) -> bool:
        nonlocal state
        state = run(state, budget)
        return share(state) < 1

    _by_moments(some)
    return state


@lru_cache(maxsize=256)
def dop853(formulas: Formulas) -> Callable[..., State]:
    """`advance` of adaptive_loop, compiled."""
    zeros = (0.0,) * formulas.size
    like = State(0, 0.0, 0.0, zeros, zeros, zeros, zeros, 0.0, 0, 0, 0, 0)
    generated = functions(formulas, forgiving=False)
    return _loop(adaptive_loop, generated, "advance", like, formulas.constants)


@lru_cache(maxsize=256)
def fixed(source: str, size: int, stages: int, constants: int) -> Callable[..., FixedState]:
    """`march` of fixed_loop, compiled."""
    like = FixedState(0, 0, (0.0,) * size, (0.0,) * size, (0.0,) * stages)
    return _loop(fixed_loop, source, "march", like, constants)


def _loop(loop: ModuleType, generated: str, entry: str, like: Any, constants: int) -> Callable[..., Any]:
    """A loop of the Python engine, compiled, that takes and gives what it does in Python."""
    key = repr((loop.__name__, generated, constants))
    made, owner = function(key, lambda: loops.loop_text(loop, generated, entry, like, constants), entry, loops.KINDS)

    def run(_: Any, origin: float, times: Array, out: Array, state: Any, c: Any, x: float, budget: int) -> Any:
        numbers, given = np.array(loops.flat(state)), np.array(c, dtype=float)
        made(*(a.ctypes.data for a in (numbers, given, times)), len(times), out.ctypes.data, origin, x, budget)
        return loops.unflat(iter(numbers.tolist()), state)

    return partial(run, owner)
