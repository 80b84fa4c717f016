"""Runs by Taylor's method of which only the start differs: memory and arguments are in place before they begin."""

import math
import struct
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tam570.integrate.adaptive import Run
from tam570.integrate.arguments import Array
from tam570.integrate.compiled import taylor, taylor_loop
from tam570.integrate.compiled.backend import Memory, Motion, address_of, memory_for, motion_of, seen, until_done
from tam570.integrate.error_scale import NO_SCALE, SHARE
from tam570.integrate.trace import Graph
from tam570.integrate.watch import Look
from tam570.values import Numbers

__all__ = ["taylor_repeated"]

STEPS = 1000  # in compiled code, after which Python looks for the first time whether the run is stiff


class Place(NamedTuple):
    """What one run at a time works in."""

    memory: Memory
    rows: Array  # to be filled
    numbers: "memoryview[float]"  # of the state


def taylor_repeated(graph: Graph, run: Run, watch: Callable[[], Look]) -> Callable[[Numbers], Array | None] | None:
    """states(y0) -> (n, k), or None where the method ends early or y0 is not k numbers; None without a series."""
    motion, size = motion_of(graph), len(run.rows[0])
    if motion is None:
        return None
    fresh = motion.numbers.pack(
        *_head(run),
        *[0.0] * (2 * size),
        *([a / (SHARE * run.rtol) if a > NO_SCALE else 0.0 for a in run.control.atol] or [0.0] * size),
    )
    start, first, used = struct.Struct(f"={size}d"), 8 * taylor_loop.NUMBERS, len(fresh)
    advance, status, free = motion.advance, taylor_loop.STATUS, list[Place]()

    def states(y0: Numbers) -> Array | None:
        if type(y0) is np.ndarray and y0.ndim != 1:  # its rows may be numbers, too
            return None
        mine = free.pop() if free else _place(motion, run)
        state = mine.memory.state
        state[:used] = fresh
        try:
            start.pack_into(state, first, *y0)
        except (struct.error, TypeError):  # `solve` says what is wrong
            return None
        advance(mine.memory.address)
        if mine.numbers[status] == taylor_loop.RUNNING:
            _carried_on(mine, advance, size, watch)
        if mine.numbers[status] != taylor_loop.DONE:
            return None  # what is not finite stays in the memory: it is left
        rows = mine.rows.copy()
        free.append(mine)
        return rows

    return states


def _place(motion: Motion, run: Run) -> Place:
    memory, rows = memory_for(motion, len(run.rows[0])), np.empty_like(run.rows)
    ends = address_of(run.since), len(run.since), address_of(rows), 0, 0
    rest = run.origin, run.rtol, taylor.order_for(run.rtol), STEPS
    taylor.CALL.pack_into(memory.call_arguments, 0, *memory.places, *ends, *rest)
    return Place(memory, rows, memory.state.cast("d"))


def _head(run: Run) -> list[float]:
    """Return the first numbers of the memory of a run that has not begun."""
    fresh_numbers = [0.0] * taylor_loop.NUMBERS
    fresh_numbers[taylor_loop.ROW], fresh_numbers[taylor_loop.STATUS] = 1.0, taylor_loop.FRESH
    fresh_numbers[taylor_loop.LONGEST] = run.since[-1] / 100
    fresh_numbers[taylor_loop.GIVEN] = 1.0 if run.control.atol else 0.0
    fresh_numbers[taylor_loop.MAXIMUM] = fresh_numbers[taylor_loop.FIRST] = math.inf
    return fresh_numbers


def _carried_on(mine: Place, advance: Numbers, size: int, watch: Callable[[], Look]) -> None:
    """To the end, with a look now and then; ArithmeticError where it is stiff."""
    look = watch()

    def some(budget: int) -> bool:
        look(*seen(mine.memory, size))
        taylor.BUDGET.pack_into(mine.memory.call_arguments, taylor.CALL.size - taylor.BUDGET.size, budget)
        advance(mine.memory.address)
        return mine.numbers[taylor_loop.STATUS] == taylor_loop.RUNNING

    until_done(some)
    taylor.BUDGET.pack_into(mine.memory.call_arguments, taylor.CALL.size - taylor.BUDGET.size, STEPS)
