"""Runs of order 8 with automatic steps."""

import math
import sys
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from tam570.integrate.adaptive_loop import LACKS_SCALE, LARGEST, NOT_FINITE, RUNNING, TOO_SHORT, State, let_pass
from tam570.integrate.arguments import Array
from tam570.integrate.binding import check_start
from tam570.integrate.engine import Engine
from tam570.integrate.scale import magnitudes
from tam570.integrate.stiffness import COMPILED, PYTHON, Look, stiffness_watch
from tam570.integrate.tableau import NODES
from tam570.integrate.trace import Graph
from tam570.integrate.when_to_compile import Loop, carried_through, seconds_until_compiled

__all__ = [
    "BETWEEN_LOOKS",
    "TROUBLE",
    "Run",
    "advanced",
    "at_hand",
    "at_start",
    "begun",
    "finished",
    "scaled",
    "shortest_step",
    "states",
    "travelled",
]

BETWEEN_LOOKS = 500  # steps
AFTER_A_JUMP = 6  # steps in a row, each as much longer than the one before as it may be

BACKEND = "tam570.integrate.compiled.backend"  # which imports llvmlite, and is imported where it is wanted

TROUBLE = {
    NOT_FINITE: "rhs or solution is not finite at t = {t:.17g}",
    TOO_SHORT: "no step is short enough at t = {t:.17g}: the solution seems to become infinite there",
}


def states(
    engine: Engine,
    times: Array,
    start: Array,
    rtol: float,
    how: str,
    floor: Sequence[float] = (),
    project: Callable[[Array], Any] | None = None,
    longest: Callable[[Array], float] | None = None,
) -> Array:
    """(n, k) states at `times`; see `travelled`."""
    return travelled(engine, times, start, rtol, how, floor, project, longest)[0]


def travelled(
    engine: Engine,
    times: Array,
    start: Array,
    rtol: float,
    how: str,
    floor: Sequence[float] = (),
    project: Callable[[Array], Any] | None = None,
    longest: Callable[[Array], float] | None = None,
) -> tuple[Array, State, str]:
    """(n, k) states at `times`, the state at the end, and the name of what went there.

    how     : "auto", "python" or "compiled"
    floor   : (k,) sizes by which components are judged at least
    project : project(y) -> y after every step
    longest : longest(y) -> s, no step from y is longer; only together with project
    """
    run, names = begun(engine, times, start, rtol), ["Python"]
    if project is None and how != "python" and at_hand(engine.graph):
        state = _at_once(run, floor)
        if state.row == len(times):
            return run.rows, state, "compiled"
    in_python = partial(advanced, run, engine.functions["advance"], run.since.tolist(), run.watch(PYTHON))
    loop = Loop(in_python, run.share)
    if project:
        loop = Loop(_stepwise(run, in_python, project, longest), run.share)
    elif engine.graph is not None:
        loop = Loop(in_python, run.share, partial(_compiled, run, in_python, names), partial(_wait, engine.graph))
    last = finished(run, loop, floor, how)
    if project:
        run.rows[1:] = [project(row) for row in run.rows[1:]]
    return run.rows, last, names[-1]


def at_hand(graph: Graph | None) -> bool:
    """Whether this process has compiled it before."""
    backend = sys.modules.get(BACKEND)
    return backend is not None and graph in backend.READY


def _at_once(run: "Run", floor: Sequence[float]) -> State:
    """By Taylor's method alone: most short runs need nothing else."""
    graph, taylor_run = run.engine.graph, sys.modules[BACKEND].taylor_run
    first = at_start(run.engine, run.origin, float(run.since[-1]), run.rows[0], floor, plainly=True)
    watch = partial(run.watch, COMPILED)
    last: State = taylor_run(graph, run.origin, run.since, run.rows, run.rtol, watch, first)
    return last


def begun(engine: Engine, times: Array, start: Array, rtol: float) -> "Run":
    """A run whose first row is filled."""
    rows = np.empty((len(times), len(start)))
    rows[0] = start
    return Run(engine, float(times[0]), times - times[0], rows, rtol)


def finished(run: "Run", loop: Loop, floor: Sequence[float], how: str) -> State:
    """The state at the end. ArithmeticError, with the time, where there is none."""
    first = at_start(run.engine, run.origin, float(run.since[-1]), run.rows[0], floor, plainly=how == "compiled")
    last: State = carried_through(loop, first, how)
    if last.halt in TROUBLE:
        raise ArithmeticError(TROUBLE[last.halt].format(t=run.engine.sign * (run.origin + last.t)))
    return last


class Run(NamedTuple):
    """What is the same at every step. since : times since `origin`; rows : (n, k), to be filled."""

    engine: Engine
    origin: float
    since: Array
    rows: Array
    rtol: float

    def share(self, state: State) -> float:
        """The part that is done, 1 where it goes no further."""
        return 1.0 if state.row == len(self.rows) or state.halt > LACKS_SCALE else state.t / float(self.since[-1])

    def watch(self, too_many: int) -> Look:
        """Whether the run is to be given up, so many steps left being too many."""
        rhs, end = self.engine.functions["rhs"], float(self.since[-1])
        return stiffness_watch(rhs, self.engine.constants, self.origin, end, self.engine.sign, too_many)


def advanced(run: Run, advance: Any, since: Any, look: Look, state: State, budget: int) -> State:
    """The state after so many steps of `advance`; since : as its code wants them."""
    last = state.steps + state.refusals + budget
    while run.share(state) < 1 and (left := last - state.steps - state.refusals) > 0:
        some = min(left, BETWEEN_LOOKS)
        state = advance(run.origin, since, run.rows, state, run.engine.constants, run.rtol, some)
        if state.halt == LACKS_SCALE:
            state = scaled(run.engine, run.origin, state, run.rtol)
        elif some == BETWEEN_LOOKS:
            look(state.t, state.y, state.m, state.steps)
    return state


def _compiled(run: Run, in_python: Callable[[State, int], State], names: list[str], state: State) -> State:
    """By Taylor's method as far as it goes; where a derivative is lacking, that of order 8 goes on."""
    from tam570.integrate.compiled import backend

    graph, formulas = run.engine.graph, run.engine.formulas
    assert graph is not None
    names.append("compiled")
    by_series = partial(
        backend.taylor_run, graph, run.origin, run.since, run.rows, run.rtol, partial(run.watch, COMPILED)
    )
    state = by_series(state)
    backend.READY.add(graph)
    if not state.steps:
        state = by_series(at_start(run.engine, run.origin, float(run.since[-1]), np.array(state.y), state.m))
    if run.share(state) >= 1:
        return state
    f = run.engine.functions["rhs"](run.origin + state.t, state.y, run.engine.constants)

    def order_8(state: State) -> State:
        by_steps = partial(advanced, run, backend.dop853(formulas), run.since, run.watch(COMPILED))
        last: State = backend.by_moments(by_steps, run.share, state)
        return last

    wait = partial(seconds_until_compiled, len(graph.operations))
    last: State = carried_through(
        Loop(in_python, run.share, order_8, wait), state._replace(f=f), "auto" if state.steps else "compiled"
    )
    return last


def _wait(graph: Graph) -> float:
    """Seconds until the compiled loop could start; none where this process has run it before."""
    return 0.0 if at_hand(graph) else seconds_until_compiled(len(graph.operations))


def _stepwise(run: Run, step: Any, project: Callable[[Array], Any], longest: Any) -> Callable[..., Any]:
    """`step` to the end with every step limited before and projected after."""

    def projected(state: Any, _budget: int) -> Any:
        while run.share(state) < 1:
            state = step(_shortened(state, longest), 1)
            state = _projected(run.engine, state, run.origin, project)
        return state

    return projected


def _shortened(state: State, longest: Callable[[Array], float] | None) -> State:
    return state if longest is None else state._replace(h=min(state.h, longest(np.array(state.y))))


def _projected(engine: Engine, state: State, origin: float, project: Callable[[Array], Any]) -> State:
    """The state brought back to where it belongs, with the derivative there."""
    y = tuple(np.asarray(project(np.array(state.y)), dtype=float).tolist())
    f = engine.functions["rhs"](origin + state.t, y, engine.constants)
    return state._replace(y=y, r=(0.0,) * len(y), f=f)


def at_start(
    engine: Engine, origin: float, span: float, start: Array, floor: Sequence[float] = (), plainly: bool = False
) -> State:
    """The state that `advance` begins with.

    floor   : (k,) sizes by which components are judged at least
    plainly : leave the scales to Taylor's method: what starts at zero has a magnitude of zero
    """
    if plainly and engine.graph is not None:
        y = tuple(start.tolist())
        m = tuple(map(max, map(abs, y), floor)) if floor else tuple(map(abs, y))
        return State(1, 0.0, span / 100, y, (0.0,) * len(y), y, m, LARGEST, 0, 0, 0, RUNNING)
    y, c, rhs = tuple(start.tolist()), engine.constants, engine.functions["rhs"]
    f = rhs(origin, y, c)
    if not all(map(math.isfinite, f)):
        check_start(engine.rates, origin, start, engine.sign)
    first_step = engine.functions["first_step"]
    h, g = first_step(origin, span, y, f, c), f
    if h < 1e-8 * span:  # the rates may jump at the very start
        g = rhs(origin + h, y, c)
        h = max(h, first_step(origin + h, span, y, g, c))
    later = _doubling(origin, h, span) if engine.formulas.timed else ()
    m = magnitudes(rhs, origin, h, y, g, floor or [0.0] * len(y), c, later)
    return State(1, 0.0, h, y, (0.0,) * len(y), f, m, LARGEST, 0, 0, 0, RUNNING)


def _doubling(origin: float, h: float, span: float) -> list[float]:
    """Times ever later: a force may not be there yet."""
    return [origin + h * 4.0**k for k in range(int(math.log(span / h, 4)) + 1)]


def scaled(engine: Engine, origin: float, state: State, rtol: float) -> State:
    """The state with a scale for what a step found moving that had none: if the times of its stages show one, or if
    rounding is all that moves it."""
    t, h, (y, f, m), c = origin + state.t, state.h, (state.y, state.f, state.m), engine.constants
    later = [t + 10 * h * node for node in NODES[1:13]]  # the step was ten times as long
    found = magnitudes(engine.functions["rhs"], t, 10 * h, y, f, m, c, later)
    found = engine.functions["raised"](t, h, y, f, found, c, let_pass(rtol), max(2.0 * state.refused - 1.0, 1.0))
    return state._replace(m=found, halt=RUNNING)


def shortest_step(engine: Engine, times: Array, start: Array, rtol: float, floor: Sequence[float]) -> float:
    """The shortest of the steps that this method takes at `rtol` once it has found its pace; s.

    ValueError where the rates jump: steps grow as fast as they may, for long, where they were short for no reason.
    """
    origin, span = float(times[0]), float(times[-1] - times[0])
    rows, state, shortest = np.empty((2, len(start))), at_start(engine, origin, span, start, floor), span
    last, growing = span, 0
    for step in range(200):
        before = state
        state = engine.functions["advance"](origin, [0.0, span], rows, state, engine.constants, rtol, 1)
        if state.row == 2 or state.halt:
            break
        if state.t > before.t:  # taken, not refused
            taken = state.t - before.t
            growing = growing + 1 if taken > 0.9 * LARGEST * last and state.refusals else 0
            if growing == AFTER_A_JUMP:
                where = engine.sign * (origin + state.t)
                raise ValueError(
                    f'method: steps of one length do not pass the jump of rhs near t = {where:.6g}; try "auto"'
                )
            shortest, last = min(shortest, taken) if step > 5 else shortest, taken
    return shortest
