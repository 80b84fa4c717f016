"""A run of which more is kept than samples: each step is looked at as it is taken, in Python."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from tam570.integrate import adaptive
from tam570.integrate.adaptive_loop import STOPPED, State, loop_with
from tam570.integrate.arguments import Array
from tam570.integrate.engine import Engine
from tam570.integrate.motion import Crossing, Event, Motion, Piece, Report, crossings, events_of, function_of_time
from tam570.integrate.stiffness import PYTHON
from tam570.integrate.when_to_compile import Loop

__all__ = ["motion"]

Seen = tuple[float, int, Array]  # time, which event, state


def motion(
    engine: Engine,
    times: Array,
    start: Array,
    rtol: float,
    floor: Sequence[float],
    events: Any,
    parameters: Mapping[str, Any] | None,
    dense: bool,
    how: str,
) -> Motion:
    """The motion with its events, and as a function of time if it is to be `dense`; how: as in `adaptive.travelled`."""
    if events is None and not dense:
        rows, last, name = adaptive.travelled(engine, times, start, rtol, how, floor)
        return Motion(_signed(engine.sign, times), rows, (), None, _report(engine, last, name))
    return _watched(engine, times, start, rtol, floor, events_of(events, parameters, engine.sign), dense)


def _watched(
    engine: Engine,
    times: Array,
    start: Array,
    rtol: float,
    floor: Sequence[float],
    events: Sequence[Event],
    dense: bool,
) -> Motion:
    run = adaptive.begun(engine, times, start, rtol)
    pieces: list[Piece] = []
    seen: list[Seen] = []
    signs = [event.value(run.origin, start) for event in events]
    counts = [0] * len(events)

    def kept(piece: Piece) -> bool:
        """Whether the run goes on."""
        if dense:
            pieces.append(piece)
        for x, which in crossings(events, piece, signs):
            seen.append((piece.t + x * piece.h, which, piece.inside(x)))
            counts[which] += 1
            if counts[which] == events[which].stops:
                return False
        return True

    last = adaptive.finished(run, Loop(_step_by_step(run, kept), run.share), floor, "python")
    reached = seen[-1][0] if last.halt == STOPPED else times[-1]
    rows = times <= reached
    return Motion(
        _signed(engine.sign, times[rows]),
        run.rows[rows],
        tuple(_crossing(engine.sign, which, seen, len(start)) for which in range(len(events))),
        function_of_time(_up_to(pieces, float(reached)), engine.sign) if dense else None,
        _report(engine, last, "Python"),
    )


def _crossing(sign: float, which: int, seen: Sequence[Seen], size: int) -> Crossing:
    """The times at which one of the events was seen, and the states there."""
    found = [(sign * t, state) for t, one, state in seen if one == which]
    times, states = [t for t, _ in found], [state for _, state in found]
    return Crossing(np.array(times, dtype=float), np.array(states, dtype=float).reshape(len(found), size))


def _report(engine: Engine, last: State, name: str) -> Report:
    """How the run went that ended with this state."""
    evaluations = 12 * (last.steps + last.refusals) if name == "Python" else None
    return Report(name, engine.why, last.steps, last.refusals, evaluations)


def _signed(sign: float, times: Array) -> Array:
    return times if sign > 0 else 0.0 - times


def _up_to(pieces: list[Piece], reached: float) -> list[Piece]:
    """The last piece ends at a terminal event."""
    piece = pieces[-1]
    share = min((reached - piece.t) / piece.h, 1.0)
    cut = Piece(piece.t, share * piece.h, lambda x: piece.inside(share * x))
    return [*pieces[:-1], cut]


def _step_by_step(run: adaptive.Run, kept: Callable[[Piece], bool]) -> Callable[[State, int], State]:
    """The run, step by step, until `kept` says no."""
    made, since, look = run.engine.functions, run.since.tolist(), run.watch(PYTHON)
    tried: list[Any] = []  # of the last step: time, length, state and derivative at its start, and what came out

    def step(start: float, h: float, y: Any, r: Any, f: Any, m: Any, c: Any) -> Any:
        tried[:] = [start, h, y, f, made["step"](start, h, y, r, f, m, c)]
        return tried[-1]

    advance = loop_with(made["raised"], step, made["dense"], made["at"])

    def to_the_end(state: State, _budget: int) -> State:
        while run.share(state) < 1:
            taken = state.steps
            state = adaptive.advanced(run, advance, since, look, state, 1)
            if state.steps > taken and not kept(_piece(made, run.engine.constants, tried)):
                return state._replace(halt=STOPPED)
            if state.steps > taken and state.steps % adaptive.BETWEEN_LOOKS == 0:
                look(state.t, state.y, state.m, state.steps)
        return state

    return to_the_end


def _piece(made: dict[str, Any], c: Any, tried: list[Any]) -> Piece:
    start, h, y, f, (n, _, g, _, _, _, stages) = tried
    q = made["dense"](start, h, y, n, f, g, stages, c)

    def inside(x: float) -> Array:
        rows = np.empty((1, len(y)))
        if x == 1:
            return np.array(n)
        made["at"](rows, 0, x, y, q)
        state: Array = rows[0]
        return state

    return Piece(start, h, inside)
