"""Runs of the engine in compiled code: the same states in and out, a moment of the run at a time."""

import time
from collections.abc import Callable
from functools import lru_cache
from types import ModuleType
from typing import Any

import numpy as np

from tam570.integrate import adaptive_loop, fixed_loop
from tam570.integrate.adaptive_loop import State
from tam570.integrate.arguments import Array
from tam570.integrate.compiled import loops, taylor, taylor_loop
from tam570.integrate.compiled.coefficients import LANES
from tam570.integrate.compiled.llvm import function
from tam570.integrate.compiled.recurrences import NotAnalytic, Recurrences, recurrences
from tam570.integrate.compiled.series import layout
from tam570.integrate.dop853_source import functions
from tam570.integrate.fixed_loop import FixedState
from tam570.integrate.formulas import Formulas
from tam570.integrate.stiffness import Look
from tam570.integrate.trace import Graph

__all__ = ["READY", "analytic", "by_moments", "dop853", "fixed", "taylor_run", "taylor_runs"]

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
def _taylor(found: Recurrences, lanes: int = 1) -> Any:
    return function(repr((found, lanes)), lambda: taylor.taylor_text(found, lanes), "advance", taylor.KINDS)


@lru_cache(maxsize=256)
def _one_motion(found: Recurrences) -> tuple[Any, list[Any]]:
    """advance, and memory for it that is free; of several threads each takes its own."""
    return _taylor(found), []


def taylor_run(graph: Graph, origin: float, times: Array, out: Array, rtol: float, look: Look, state: State) -> State:
    """The state at the end, or where Taylor's method cannot go on; times since `origin`.

    A state whose m is not positive has no scale: it is found, or the state comes back as it was.
    look : called now and then
    """
    known = analytic(graph)
    if known is None:
        return state
    found, constants = known
    (advance, free), size = _one_motion(found), len(state.y)
    memory = free.pop() if free else _memory(taylor_loop.memory(size), layout(found, 1).doubles, 1, constants)
    z, _, _, c, given = memory
    if constants:
        c[:] = constants
    head = [state.row, state.t, 0, state.t, 0, 0, 0, 0, state.h, min(state.m) > 0.0, 0]
    used = taylor_loop.NUMBERS + 3 * size
    z[:used] = [*head, *[0] * (taylor_loop.NUMBERS - len(head)), *state.y, *state.r, *state.m]
    ends = times.ctypes.data, len(times), out.ctypes.data, None, 0, origin, rtol, taylor.order_for(rtol)

    def some(budget: int) -> bool:
        advance(*given, *ends, budget)
        running = bool(z[taylor_loop.STATUS] == taylor_loop.RUNNING)
        if running:
            y, _, m = z[taylor_loop.NUMBERS : used].reshape(3, size).tolist()
            look(float(z[taylor_loop.T]), y, m, int(z[taylor_loop.STEPS]))
        return running

    _by_moments(some)
    numbers = z[:used].tolist()
    row, t, _, _, status, steps, refusals, _, h = numbers[: taylor_loop.LONGEST + 1]
    if status == taylor_loop.DONE:  # after all others there may be numbers that are not finite in it
        free.append(memory)
    total = state.steps + int(steps), state.refusals + int(refusals)
    y, r, m = (tuple(numbers[k : k + size]) for k in range(taylor_loop.NUMBERS, used, size))
    return State(int(row), t, h, y, r, state.f, m, state.growth, state.refused, *total, state.halt)


def taylor_runs(graph: Graph, origin: float, times: Array, out: Array, rtol: float, starts: Array, floor: Any) -> Array:
    """Fill (m, n, k) `out` from the (m, k) starts; (m,) whether that was possible."""
    known = analytic(graph)
    if known is None:
        return np.zeros(len(starts), dtype=bool)
    found, constants = known
    advance, place, size = _taylor(found, LANES), layout(found, LANES), starts.shape[1]
    one = taylor_loop.memory(size)
    z, _, clock, _, given = _memory(LANES * one + 2, place.doubles, LANES, constants)
    z[taylor_loop.STATUS : LANES * one : one] = taylor_loop.IDLE
    z[-1], clock[:] = LANES, origin
    members = np.hstack(
        [np.full((len(starts), 1), times[-1] / 100), starts, np.maximum(np.abs(starts), floor if len(floor) else 0.0)]
    )
    ends = times.ctypes.data, len(times), out.ctypes.data, members.ctypes.data, len(starts)
    order = taylor.order_for(rtol)
    _by_moments(lambda budget: advance(*given, *ends, origin, rtol, order, budget) or bool(z[-1] > 0.0))
    return np.asarray(members[:, 0] == taylor_loop.DONE)


def _memory(one: int, work: int, lanes: int, constants: tuple[float, ...]) -> tuple[Any, ...]:
    """z, work, time and constants in one piece of memory, and the addresses of the four."""
    places = [0, one, one + work, one + work + lanes]
    whole = np.zeros(places[3] + len(constants))
    parts = [whole[a:b] for a, b in zip(places, [*places[1:], None], strict=True)]
    parts[3][:] = constants
    start = whole.ctypes.data
    return *parts, [start + 8 * place for place in places]


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
    return _loop(adaptive_loop, generated, "advance", like, formulas.constants, adaptive_loop.HANDED)


@lru_cache(maxsize=256)
def fixed(source: str, size: int, stages: int, constants: int) -> Callable[..., FixedState]:
    """`march` of fixed_loop, compiled."""
    like = FixedState(0, 0, (0.0,) * size, (0.0,) * size, (0.0,) * stages)
    return _loop(fixed_loop, source, "march", like, constants)


def _loop(
    loop: ModuleType, generated: str, entry: str, like: Any, constants: int, handed: tuple[str, ...] = ()
) -> Callable[..., Any]:
    """A loop of the Python engine, compiled, that takes and gives what it does in Python."""
    key = repr((loop.__name__, generated, constants))
    made = function(key, lambda: loops.loop_text(loop, generated, entry, like, constants, handed), entry, loops.KINDS)

    def run(origin: float, times: Array, out: Array, state: Any, c: Any, x: float, budget: int) -> Any:
        numbers, given = np.array(loops.flat(state)), np.array(c, dtype=float)
        made(*(a.ctypes.data for a in (numbers, given, times)), len(times), out.ctypes.data, origin, x, budget)
        return loops.unflat(iter(numbers.tolist()), state)

    return run
