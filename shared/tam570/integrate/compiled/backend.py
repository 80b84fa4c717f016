"""Runs the engine's loops in compiled code, with the same states in and out, in slices that Ctrl-C can interrupt."""

import math
import struct
from collections.abc import Callable, Sequence
from functools import lru_cache
from types import ModuleType
from typing import NamedTuple

import numpy as np

from tam570.integrate import adaptive_loop, fixed_step
from tam570.integrate.adaptive import Control, Run
from tam570.integrate.adaptive_loop import State
from tam570.integrate.arguments import Array
from tam570.integrate.compiled import loops, taylor, taylor_loop
from tam570.integrate.compiled.ir import Operand
from tam570.integrate.compiled.llvm import function
from tam570.integrate.compiled.recurrences import NotAnalytic, Recurrences, recurrences
from tam570.integrate.compiled.series import LANES, exponents, layout, padded_size, series_module
from tam570.integrate.dop853 import rates, rounding, sampling, stepping
from tam570.integrate.error_scale import NO_SCALE, SHARE
from tam570.integrate.fixed_step import FixedState
from tam570.integrate.formulas import Formulas, by_call
from tam570.integrate.trace import Graph
from tam570.integrate.watch import Look
from tam570.values import Function, Numbers

FEWEST, MOST = 1000, 16000  # steps per call of compiled code; Python can handle an interrupt between calls
REPEATED = 1000  # steps of a repeated run before the first test for stiffness
LINE = 64  # bytes in a cache line
EFFORT = 1  # optimization level for a series: 2 doubles the compile time and yields no faster code
UNSET = (0,) * (taylor_loop.NUMBERS - 13)


@lru_cache(maxsize=256)
def analytic(graph: Graph) -> tuple[Recurrences, tuple[float, ...]] | None:
    """Return the recurrences of a graph and their constants; None if a function in it is not analytic."""
    try:
        return recurrences(graph)
    except NotAnalytic:
        return None


@lru_cache(maxsize=256)
def _taylor(laws: Recurrences, lanes: int = 1) -> Operand:
    effort = EFFORT if lanes == 1 else 2
    is_timed = any(series.rule == "time" for series in laws.series)
    loop = taylor.Loop(len(laws.rates), lanes, bool(exponents(laws)), is_timed)
    series = {repr((laws, lanes)): lambda: series_module(laws, lanes)}
    return function({**series, repr(loop): lambda: taylor.loop_module(loop)}, "advance", taylor.KINDS, effort)


class Memory(NamedTuple):
    """Parts of one block of memory for compiled code: call arguments, z, work, time and constants."""

    z: Array
    time: Array
    call_arguments: memoryview  # packed by `taylor.CALL`
    state: memoryview  # z, as bytes
    places: tuple[int, ...]  # addresses of z, work, time and constants
    address: int


class RepeatedRun(NamedTuple):
    """Buffers of a repeated run; concurrent runs use different ones."""

    memory: Memory
    rows: Array  # output
    numbers: "memoryview[float]"  # of the state


class CompiledMotion(NamedTuple):
    """Compiled code for runs from a single start, and its memory layout."""

    advance: Operand
    doubles: int  # size of `work`
    constants: tuple[float, ...]
    numbers: struct.Struct  # format of the state in z
    free: list[Memory]  # pool; each thread takes a different block


@lru_cache(maxsize=256)
def motion_of(graph: Graph) -> CompiledMotion | None:
    """Return the compiled code of a graph; None if it has no Taylor series."""
    analysed = analytic(graph)
    if analysed is None:
        return None
    laws, constants = analysed
    size = len(laws.rates)
    part = f"{size}d{8 * (padded_size(size) - size)}x"  # the components, padded to whole vectors
    numbers = struct.Struct(f"={taylor_loop.NUMBERS}d{3 * part}")
    return CompiledMotion(_taylor(laws), layout(laws, 1).doubles, constants, numbers, [])


def taylor_run(run: Run, look: Look, state: State, *, is_fresh: bool = False) -> State:
    """Return the state at the end of the stretch, or where Taylor's method fails; unchanged if there is no series.

    look     : called between slices of the run; it may raise
    is_fresh : whether the scales of the components come from the start
    """
    motion = motion_of(run.engine.graph) if run.engine.graph is not None else None
    if motion is None:
        return state
    control, size = run.control, len(state.y)
    memory = motion.free.pop() if motion.free else memory_for(motion, size)
    packed = _packed(motion, run, state, is_fresh)
    memory.state[: len(packed)] = packed

    def some(budget: int) -> bool:
        _pack_call(memory, run, run.rows, budget)
        motion.advance(memory.address)
        is_running = bool(memory.z[taylor_loop.STATUS] == taylor_loop.RUNNING)
        if is_running:
            look(*seen(memory, size))
        return is_running

    until_done(some)
    numbers = motion.numbers.unpack_from(memory.state)
    row, t, _, _, status, steps, refusals, _, h = numbers[: taylor_loop.LONGEST + 1]
    if status == taylor_loop.DONE:  # any other status may leave non-finite numbers in the memory
        motion.free.append(memory)
    y, r, m = (numbers[k : k + size] for k in range(taylor_loop.NUMBERS, len(numbers), size))
    a = state.a if control.atol else tuple(max(SHARE * run.rtol * size, NO_SCALE) for size in m)
    steps, refusals = state.steps + int(steps), state.refusals + int(refusals)
    return state._replace(row=int(row), t=t, h=h, y=y, r=r, a=a, steps=steps, refusals=refusals)


def _packed(motion: CompiledMotion, run: Run, state: State, is_fresh: bool) -> bytes:
    """Return the initial content of z for a run from this state."""
    control = run.control
    sizes = _scales(state.a, run.rtol)
    is_start = state.t == 0.0 and not state.steps and not control.atol
    has_sizes = 1.0 if control.atol or (min(sizes) > 0.0 and not is_start) else 2.0 if not is_start else 0.0
    status = taylor_loop.FRESH if is_fresh else taylor_loop.RUNNING
    first_numbers = (state.row, state.t, 0, state.t, status, 0, 0, 0, state.h, has_sizes)
    limits = 0, control.max_step, math.inf if control.first_step is None or state.steps else control.first_step
    return motion.numbers.pack(*first_numbers, *limits, *UNSET, *state.y, *state.r, *sizes)


def _scales(a: Sequence[float], rtol: float) -> list[float]:
    """Return the scales of the components from their absolute tolerances; 0 if there is none."""
    return [size / (SHARE * rtol) if size > NO_SCALE else 0.0 for size in a]


def _pack_call(memory: Memory, run: Run, rows: Array, budget: int) -> None:
    ends = address_of(run.since), len(run.since), address_of(rows), 0, 0
    rest = run.origin, run.rtol, taylor.order_for(run.rtol), budget
    taylor.CALL.pack_into(memory.call_arguments, 0, *memory.places, *ends, *rest)


def taylor_repeated(run: Run, watch: Callable[[], Look]) -> Callable[[Numbers], Array | None] | None:
    """Return a function states(y0) -> (n, k) for runs that differ only in the start; None without a series.

    `states` returns None if the method fails or if y0 is not k numbers. It reuses memory and arguments.
    """
    motion, size = motion_of(run.engine.graph) if run.engine.graph is not None else None, len(run.rows[0])
    if motion is None:
        return None
    fresh = _packed(motion, run, run.last, is_fresh=True)
    start, first, used = struct.Struct(f"={size}d"), 8 * taylor_loop.NUMBERS, len(fresh)
    advance, status, free = motion.advance, taylor_loop.STATUS, list[RepeatedRun]()

    def new_run() -> RepeatedRun:
        memory, rows = memory_for(motion, size), np.empty_like(run.rows)
        _pack_call(memory, run, rows, REPEATED)
        return RepeatedRun(memory, rows, memory.state.cast("d"))

    def states(y0: Numbers) -> Array | None:
        if type(y0) is np.ndarray and y0.ndim != 1:  # `pack_into` would accept rows of one number
            return None
        mine = free.pop() if free else new_run()
        state = mine.memory.state
        state[:used] = fresh
        try:
            start.pack_into(state, first, *y0)
        except (struct.error, TypeError):  # `solve` then reports the error
            return None
        advance(mine.memory.address)
        if mine.numbers[status] == taylor_loop.RUNNING:
            carry_on(mine)
        if mine.numbers[status] != taylor_loop.DONE:
            return None  # do not reuse this memory: it may contain non-finite numbers
        rows = mine.rows.copy()
        free.append(mine)
        return rows

    def carry_on(mine: RepeatedRun) -> None:
        """Continue to the end in slices; raise ArithmeticError if the equations are stiff."""
        look = watch()

        def some(budget: int) -> bool:
            look(*seen(mine.memory, size))
            _pack_call(mine.memory, run, mine.rows, budget)
            advance(mine.memory.address)
            return mine.numbers[status] == taylor_loop.RUNNING

        until_done(some)
        _pack_call(mine.memory, run, mine.rows, REPEATED)

    return states


def address_of(array: Array) -> int:
    """Return the address of the data; faster than `array.ctypes.data`."""
    address: int = array.__array_interface__["data"][0]
    return address


def seen(memory: Memory, size: int) -> tuple[float, list[float], Callable[[], list[float]], int, int]:
    """Return time, state, a function that returns its scales, accepted steps and refused steps."""
    padded = padded_size(size)
    parts = memory.z[taylor_loop.NUMBERS : taylor_loop.NUMBERS + 3 * padded].reshape(3, padded)
    y, _, m = parts[:, :size].tolist()
    numbers = memory.z[[taylor_loop.T, taylor_loop.STEPS, taylor_loop.REFUSALS]].tolist()
    return numbers[0], y, lambda: m, int(numbers[1]), int(numbers[2])


def taylor_runs(graph: Graph, times: Array, out: Array, starts: Array, control: Control) -> Array:
    """Solve from each of the (m, k) starts into (m, n, k) `out`; return (m,) whether each run succeeded."""
    origin, times, rtol = float(times[0]), times - times[0], control.rtol
    analysed = analytic(graph)
    if analysed is None:
        return np.zeros(len(starts), dtype=bool)
    laws, constants = analysed
    advance, memory_layout, size = _taylor(laws, LANES), layout(laws, LANES), starts.shape[1]
    per_lane = taylor_loop.memory(size)
    running = LANES * per_lane + 1  # index in z of the number of unfinished motions
    memory = _memory(LANES * (per_lane + 1), memory_layout.doubles, LANES, constants)
    z = memory.z
    z[LANES * taylor_loop.STATUS : LANES * (taylor_loop.STATUS + 1)] = taylor_loop.IDLE
    z[running], memory.time[:] = len(starts), origin
    scales = _scales(control.atol or (0.0,) * size, rtol)
    has_scales = np.full(len(starts), bool(control.atol))
    members = np.column_stack([has_scales, starts, np.tile(scales, (len(starts), 1))])
    ends = address_of(times), len(times), address_of(out), address_of(members), len(starts)
    order = taylor.order_for(rtol, LANES)

    def some(budget: int) -> bool:
        taylor.CALL.pack_into(memory.call_arguments, 0, *memory.places, *ends, origin, rtol, order, budget)
        advance(memory.address)
        return bool(z[running] > 0.0)

    until_done(some)
    return np.asarray(members[:, 0] == taylor_loop.DONE)


def memory_for(motion: CompiledMotion, size: int) -> Memory:
    """Allocate memory for a run with `size` components."""
    return _memory(taylor_loop.memory(padded_size(size)), motion.doubles, 1, motion.constants)


def _memory(per_lane: int, work: int, lanes: int, constants: tuple[float, ...]) -> Memory:
    first = -(-taylor.CALL.size // LINE) * LINE // 8
    places = [first, first + per_lane, first + per_lane + work, first + per_lane + work + lanes]
    buffer = np.zeros(places[3] + len(constants) + LINE // 8)
    block = buffer[-address_of(buffer) % LINE // 8 :]  # aligned, so that no vector spans two cache lines
    block[places[3] : places[3] + len(constants)] = constants
    z, time, start = block[first : places[1]], block[places[2] : places[3]], address_of(block)
    whole_bytes = block.data.cast("B")
    call_arguments, state = whole_bytes[: 8 * first], whole_bytes[8 * first : 8 * places[1]]
    return Memory(z, time, call_arguments, state, tuple(start + 8 * offset for offset in places), start)


def until_done(some: Callable[[int], bool]) -> None:
    """Call some(budget) until it returns False, with budgets small enough for a prompt reaction to interrupts."""
    budget = FEWEST
    while some(budget):
        budget = min(2 * budget, MOST)


def by_moments(run: Callable[[Operand, int], Operand], share: Callable[[Operand], float], state: Operand) -> Operand:
    """Call run(state, budget) until `share` of the state reaches 1; return the final state."""

    def some(budget: int) -> bool:
        nonlocal state
        state = run(state, budget)
        return share(state) < 1

    until_done(some)
    return state


@lru_cache(maxsize=256)
def dop853(formulas: Formulas) -> Callable[..., State]:
    """Compile `advance` of adaptive_loop with the formulas."""
    zeros = (0.0,) * formulas.size
    like = State(0, 0.0, 0.0, zeros, zeros, zeros, zeros, zeros, zeros, 0.0, 0, 0, 0, 0)
    call = by_call(formulas)
    generated = "".join(write(formulas, forgiving=False) for write in (rates, rounding))
    generated += stepping(call, forgiving=False) + sampling(call)
    return _loop(adaptive_loop, generated, "advance", like, formulas.constants, adaptive_loop.GENERATED)


@lru_cache(maxsize=256)
def fixed(source: str, size: int, stages: int, constants: int) -> Callable[..., FixedState]:
    """Compile `march` of fixed_step with the source of a step."""
    like = FixedState(0, 0, (0.0,) * size, (0.0,) * size, (0.0,) * stages)
    return _loop(fixed_step, source, "march", like, constants)


def _loop(
    loop: ModuleType, generated: str, entry: str, like: Operand, constants: int, handed: tuple[str, ...] = ()
) -> Function:
    """Compile a loop of the Python engine; arguments and result are the same as in Python."""
    key = repr((loop.__name__, generated, constants))
    modules = {key: lambda: loops.loop_text(loop, generated, entry, like, constants, handed)}
    march = function(modules, entry, loops.KINDS)

    def run(origin: float, times: Array, out: Array, state: Operand, c: Operand, x: float, *rest: float) -> Operand:
        numbers, call_arguments = np.array(loops.flat(state), dtype=float), np.array(c, dtype=float)
        longest, budget = rest if len(rest) == 2 else (math.inf, *rest)
        inputs = (a.ctypes.data for a in (numbers, call_arguments, times))
        march(*inputs, len(times), out.ctypes.data, origin, x, longest, budget)
        return loops.unflat(iter(numbers.tolist()), state)

    return run
