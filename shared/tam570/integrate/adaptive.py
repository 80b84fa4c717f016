"""Runs with adaptive step size, of order 8 or by Taylor series, in stretches that end where the rates may jump."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import NamedTuple, NoReturn

import numpy as np

from tam570.integrate.adaptive_loop import COARSE_CLOCK, FINEST, LARGEST, RUNNING, SETS_IN, STOPPED, State, is_blurred
from tam570.integrate.arguments import SMALLEST_RTOL, Array
from tam570.integrate.engine import Engine, Mistraced
from tam570.integrate.error_scale import NO_SCALE, SHARE, Rates, error_scale, grown_scale
from tam570.integrate.rates import TRIAL_ERRORS, check_start
from tam570.integrate.watch import (
    COMPILED,
    OUT_OF_REACH,
    PYTHON,
    Estimate,
    Look,
    WorthCompiling,
    blur,
    repays,
    watch_for_end,
)
from tam570.meter import count
from tam570.values import Numbers

STEP, CALLED_STEP = 60, 180  # calls of a short Python function as long as a step, of traced and called rates
AT_A_TIME = 500  # steps between two looks of `watch_for_end`, at most
OFTEN = 50  # the same of a called function, and between two tests whether it remembers earlier calls
WORTH_LANES = 16  # starts, from which on compilation of code for eight motions is worthwhile
AT_A_SWITCH = 6  # attempts that a switch costs; they count as refusals
FAR = 1e3  # in lengths of the run, time beyond which its round-off matters
ALLOWED = 100.0  # tolerances, allowed effect of the round-off of times on the state
KINKS = 30.0  # divisor of the tolerance if the rates may have kinks
AFTER_A_JUMP = 6  # consecutive steps with the largest growth that indicate a jump
FOREVER = 2**62  # steps
SOON = 1e-8  # duration of a ramp, as a fraction of the run
NEARBY = 16.0  # in shortest steps, distance at which rates near a failure are compared
SETTLED, MEASURED = 5, 200  # first steps, which may be too short; attempts that measure the shortest step
RAMP = 1e-3  # of the rate soon after the start; a smaller rate at the start counts as zero


class Control(NamedTuple):
    """What the caller requires of the steps.

    atol     : (k,); if empty, it follows from the start
    max_step : s; first_step : s; if None, it follows from the rates
    longest  : longest(y) -> s, limit of a step from y; only together with `project`
    project  : project(y) -> y, called after every step
    on_step  : on_step(StepInterpolant) -> whether the run continues, called after every step; only in Python
    """

    rtol: float
    atol: Sequence[float] = ()
    max_step: float = math.inf
    first_step: float | None = None
    project: Callable[[Array], Numbers] | None = None
    longest: Callable[[Array], float] | None = None
    on_step: Callable[..., bool] | None = None


class Solution(NamedTuple):
    """(n, k) states at the sample times, the last state, and the name of the engine."""

    rows: Array
    last: State
    engine: str


@dataclass
class Run:
    """A stretch of a run. since : times since `origin`; rows : (n, k), output; last : the current state.

    estimate : decides whether compiling repays for the run; None if that is decided
    """

    engine: Engine
    origin: float
    since: Array
    rows: Array
    control: Control
    estimate: Estimate | None = None
    last: State = field(init=False)

    @property
    def rtol(self) -> float:
        return self.control.rtol

    def share(self, state: State) -> float:
        """Return the fraction that is done; 1 if the run cannot continue."""
        return 1.0 if state.row == len(self.rows) or state.halt else state.t / float(self.since[-1])

    def watch(self, too_many: int) -> Look:
        """Return the look of `watch_for_end`, which gives the run up if `too_many` steps remain."""
        rhs, end = self.engine.functions["rhs"], float(self.since[-1])
        in_vain = OUT_OF_REACH if self.engine.is_traced else PYTHON
        return watch_for_end(rhs, self.engine.constants, self.origin, end, self.engine.sign, too_many, in_vain)


def integrate(engine: Engine, times: Array, start: Array, how: str, control: Control) -> Solution:
    """Return the states at `times`; how : "auto", "python" or "compiled".

    "auto" starts in Python. If the count of its steps shows that compiling repays, the run starts again in compiled
    code, so the states equal those of "python" or of "compiled" to the last bit.
    Raise ArithmeticError, with the time, if rates or state are no longer finite, or the equations become stiff.
    """
    check_clock(engine, times, start, control.rtol)
    engine.begin(control.rtol)
    in_python = control.project is not None or control.on_step is not None
    if how == "compiled" and (in_python or engine.graph is None):
        raise ValueError('method: "compiled" needs an rhs without branches or conversions, and no project; try "auto"')
    if how != "auto" or in_python or engine.graph is None:
        return _integrate(engine, times, start, how, control, None)
    estimate = Estimate(float(times[0]), float(times[-1]), len(engine.graph.operations))
    try:
        return _integrate(engine, times, start, "python", control, estimate)
    except WorthCompiling:
        try:
            return _integrate(engine, times, start, "compiled", control, None)
        except (ImportError, OSError, RuntimeError):  # llvmlite is broken: continue in Python
            return _integrate(engine, times, start, "python", control, None)


def check_clock(engine: Engine, times: Array, start: Array, rtol: float) -> None:
    """Raise ValueError if times are so far from zero that their round-off affects the rates."""
    begin, end = float(times[0]), float(times[-1])
    latest, span = max(abs(begin), abs(end)), end - begin
    if latest < FAR * span:
        return
    rounding, y, rhs = math.ulp(latest), tuple(start.tolist()), engine.functions["rhs"]
    clock = [begin + span * (k + 0.46) / 16 for k in range(16)]
    try:
        rates, later = (np.array([rhs(t + d, y, engine.constants) for t in clock]) for d in (0.0, rounding))
    except TRIAL_ERRORS:  # the start may be invalid at later times
        return
    sizes = np.maximum(np.abs(start), span * np.abs(rates).max(axis=0))
    changes = np.median(np.abs(later - rates), axis=0)
    if (span * changes > ALLOWED * rtol * sizes).any():
        raise ValueError(
            f"t: times near {latest:.3g} are rounded to {rounding:.1g} s, within which the rates change by "
            f"{changes.max():.1g}: more than rtol = {rtol:.1g} allows. Count time from the start of the run, in t and "
            "in rhs, or give a larger rtol"
        )


def _integrate(
    engine: Engine, times: Array, start: Array, how: str, control: Control, estimate: Estimate | None
) -> Solution:
    """Integrate stretch by stretch, each to the next time at which the rates may jump."""
    rows = np.empty((len(times), len(start)))
    rows[0] = start
    t, y, row, end = float(times[0]), start, 1, float(times[-1])
    a: Sequence[float] = ()
    steps = refusals = 0
    control = of_steps(engine, control)
    while True:
        stop = engine.next_break(t, float(times[0]), end)
        through = max(row, int(np.searchsorted(times, stop, side="right")))
        ends = [] if through > row and times[through - 1] == stop else [stop]
        run = start_run(engine, np.concatenate([[t], times[row:through], ends]), y, control, estimate)
        try:
            _run_stretch(run, how, a)
            if engine.is_traced and run.last.halt == RUNNING and stop < end:
                _check_rounding(engine, stop, run.last, control.rtol)
        except ArithmeticError:
            grown = _grown(run, end)
            if grown is None:
                raise
            run.last = run.last._replace(a=grown, halt=SETS_IN)
            if engine.switches:
                engine.switches.expected = -math.inf  # the refused steps predicted it
        last = run.last
        if last.halt == SETS_IN:
            stop = run.origin + last.t
        reached = min(last.row - 1, through - row)
        rows[row : row + reached] = run.rows[1 : 1 + reached]
        steps, refusals = steps + last.steps, refusals + last.refusals
        last = last._replace(steps=steps, refusals=refusals)
        if last.halt == STOPPED or last.row == len(run.rows) and stop >= end:
            break
        t, y, row, a = stop, np.array(last.y), row + reached, last.a
        control = control._replace(first_step=None)
    _check_history(engine, run.origin + last.t, np.array(last.y), float(times[0]), control.rtol)
    if control.project:
        rows[1:] = [control.project(state) for state in rows[1:]]
    return Solution(rows, last._replace(t=run.origin + last.t), "compiled" if how == "compiled" else "Python")


def _grown(run: Run, end: float) -> tuple[float, ...] | None:
    """Return larger tolerances if a force that sets in moves a component far beyond its scale; None otherwise."""
    last, control, engine, t = run.last, run.control, run.engine, run.origin + run.last.t
    if control.atol or not engine.formulas.timed:
        return None
    sizes = [abs(v) + a / (SHARE * control.rtol) for v, a in zip(last.y, last.a, strict=True)]
    try:
        grown = grown_scale(engine.functions["rhs"], t, end, last.y, sizes, [True] * len(sizes), engine.constants)
    except TRIAL_ERRORS:
        return None
    each = zip(grown, sizes, last.a, strict=True)
    return tuple(SHARE * control.rtol * new if new > size else a for new, size, a in each) if grown != sizes else None


def _check_rounding(engine: Engine, t: float, last: State, rtol: float) -> None:
    """Raise ArithmeticError if the rates, as in a pulse, move the state too much within the round-off of time."""
    rates = engine.functions["rhs"](t, last.y, engine.constants)
    size = max(abs(v) + a / rtol for v, a in zip(last.y, last.a, strict=True))
    if math.inf > math.ulp(t) * max(map(abs, rates)) > ALLOWED * max(rtol, FINEST) * size:
        raise blur(engine.sign * t, last.y)


def of_steps(engine: Engine, control: Control) -> Control:
    """Return the control of the steps: a smaller tolerance if the rates may have kinks, which estimates underrate."""
    return control._replace(rtol=max(control.rtol / KINKS, SMALLEST_RTOL)) if engine.may_have_kinks else control


def _check_history(engine: Engine, t: float, y: Array, begin: float, rtol: float) -> None:
    """Raise RhsError if a called right-hand side depends on its calls since the run began."""
    if engine.called_rates is not None:
        engine.called_rates.check_history(t, y, t - begin, KINKS * rtol)


def start_run(engine: Engine, times: Array, start: Array, control: Control, estimate: Estimate | None = None) -> Run:
    """Return a run with the start in its first row."""
    rows = np.empty((len(times), len(start)))
    rows[0] = start
    run = Run(engine, float(times[0]), times - times[0], rows, control, estimate)
    run.last = _unscaled_state(run, ())
    return run


def _run_stretch(run: Run, how: str, a: Sequence[float]) -> None:
    """Run to the end of the stretch, or raise ArithmeticError with the time. a : absolute tolerance, if set before."""
    control = run.control
    if how == "compiled":
        _run_compiled(run, a)
    else:
        run.last = start_state(run, a)
        if control.project is None and control.on_step is None:
            step_n(run, run.engine.functions["advance"], run.since.tolist(), run.watch(PYTHON), run.last, FOREVER)
        else:
            from tam570.integrate.events import step_by_step

            step_by_step(run)
    if run.last.halt not in (RUNNING, SETS_IN, STOPPED):
        _give_up(run, run.last)


def _give_up(run: Run, last: State) -> NoReturn:
    """Raise the error that explains why a run cannot continue."""
    engine, t = run.engine, run.origin + last.t
    if last.halt == COARSE_CLOCK:
        raise blur(engine.sign * t, last.y)
    where = f"at t = {engine.sign * t:.17g}"
    for time in (t + 1e-13 * max(abs(t), float(run.since[-1])), t):
        y = np.array(last.y) + (time - t) * np.array(last.f)
        try:
            g = np.asarray(engine.rates(time, y), dtype=float)
        except TRIAL_ERRORS as error:
            if str(error) in ("math domain error", "math range error") or isinstance(error, ArithmeticError):
                raise ArithmeticError(f"rhs or solution is not finite {where}: {error}") from error
            error.add_note(f"solve: rhs raises this just beyond t = {engine.sign * t:.17g}, y = {list(last.y)}")
            raise
        if not np.isfinite(g).all():
            raise ArithmeticError(f"rhs or solution is not finite {where}: rhs gives {g}")
        if engine.is_traced and not all(map(math.isfinite, engine.functions["rhs"](time, tuple(y), engine.constants))):
            raise Mistraced
    own_error = engine.called_rates.error if engine.called_rates else None
    if own_error is not None and not isinstance(own_error, ArithmeticError):
        own_error.add_note(f"solve: rhs raises this beyond t = {engine.sign * t:.17g}, y = {list(last.y)}")
        raise own_error
    if abs(t) > FAR * float(run.since[-1]):  # the time lacks the digits that a step needs
        raise blur(engine.sign * t, last.y)
    raise ArithmeticError(f"no step is short enough {where}: {_cause(run, last)}")


def _cause(run: Run, last: State) -> str:
    """Return the reason: near a jump the rates change little on either side, near a pole they change more and more."""
    rhs, c, t = run.engine.functions["rhs"], run.engine.constants, run.origin + last.t
    step, times = math.ldexp(max(abs(t), last.t), -50), (-2 * NEARBY, -NEARBY, NEARBY, 2 * NEARBY)
    rates = np.array([rhs(t + k * step, _euler(k * step, last.y, last.f), c) for k in times])
    earlier, jump, later = np.abs(np.diff(rates, axis=0)).max(axis=1)
    is_smooth, left = max(earlier, jump, later) < np.abs(rates).max() / 10, float(run.since[-1]) - last.t
    if run.engine.is_traced and is_smooth and left < NEARBY * step:
        raise Mistraced  # 0/0 at a time that only a traced run evaluates
    if not max(earlier, later) < jump / 10:
        return (
            f"the largest rate is {max(map(abs, last.f)):.3g}, and the solution or its rates become infinite, or have "
            "a pulse that is hardly longer than the rounding of time or state"
        )
    return (
        f"the rates jump by {jump:.3g}, which moves the solution by {jump * step:.1g} within the shortest step that "
        f"this time allows, {step:.1g} s. If it is a pulse, let the clock begin there, or make it longer; or give a "
        "larger rtol"
    )


def step_n(run: Run, advance: Numbers, since: Numbers, look: Look, state: State, budget: int) -> State:
    """Return the state after `budget` attempts of `advance`, or at the end; since : times as a list or array for it."""
    last = state.steps + state.refusals + budget
    at_a_time = AT_A_TIME if run.engine.is_traced else OFTEN
    while run.share(state) < 1 and (remaining := last - state.steps - state.refusals) > 0:
        some = min(remaining, at_a_time if run.estimate is None else run.estimate.due - run.estimate.steps)
        before = state.steps + state.refusals
        state = advance(run.origin, since, run.rows, state, run.engine.constants, run.rtol, run.control.max_step, some)
        run.last = state
        count((STEP if run.engine.is_traced else CALLED_STEP) * (state.steps + state.refusals - before))
        in_vain = state.refusals + (AT_A_SWITCH * run.engine.switches.passages if run.engine.switches else 0)
        by_rounding = is_blurred(state.measured, state.y, state.a, run.rtol)
        look(state.t, state.y, partial(_sizes, state, run.rtol), state.steps, in_vain, by_rounding)
        if (state.steps + state.refusals) // OFTEN > before // OFTEN:
            _check_history(run.engine, run.origin + state.t, np.array(state.y), run.origin, run.rtol)
        if run.estimate is not None:
            run.estimate.add(state.steps + state.refusals - before, run.origin + state.t)
    return state


def _sizes(state: State, rtol: float) -> list[float]:
    """Return the scales of the components, to estimate decay rates."""
    return [abs(v) + (size / rtol if size > NO_SCALE else 0.0) for v, size in zip(state.y, state.a, strict=True)]


def _run_compiled(run: Run, a: Sequence[float]) -> None:
    """Run by Taylor's method as far as possible; where it fails, continue with the method of order 8."""
    from tam570.integrate.compiled import backend

    engine, watch = run.engine, run.watch(COMPILED)
    run.last = _unscaled_state(run, a)
    run.last = backend.taylor_run(run, watch, run.last, is_fresh=not a)
    if not run.last.steps:
        run.last = backend.taylor_run(run, watch, start_state(run, run.last.a))
    if run.share(run.last) >= 1:
        return
    rates = engine.functions["rhs"](run.origin + run.last.t, run.last.y, engine.constants)
    by_steps = partial(step_n, run, backend.dop853(engine.formulas), run.since, watch)
    run.last = backend.by_moments(by_steps, run.share, run.last._replace(f=rates))


def _unscaled_state(run: Run, a: Sequence[float]) -> State:
    """Return the initial state for Taylor's method; components that start at zero have no tolerance yet."""
    y, control = tuple(run.rows[0].tolist()), run.control
    a = tuple(control.atol) or tuple(a) or tuple(SHARE * control.rtol * abs(v) for v in y)
    h = control.first_step or float(run.since[-1]) / 100
    nothing = (0.0,) * len(y)
    return State(1, 0.0, h, y, nothing, y, tuple(a), nothing, nothing, LARGEST, 0, 0, 0, RUNNING)


def start_state(run: Run, a: Sequence[float] = ()) -> State:
    """Return the initial state for `advance`. a : the absolute tolerance, if an earlier stretch set it."""
    engine, origin, span, control = run.engine, run.origin, float(run.since[-1]), run.control
    y, c, rhs = tuple(run.rows[0].tolist()), engine.constants, engine.functions["rhs"]
    f = rhs(origin, y, c)
    if not all(map(math.isfinite, f)):
        if a and engine.is_traced:
            raise Mistraced  # a run by calls may not evaluate this time
        if a:
            raise ArithmeticError(
                f"rhs or solution is not finite at t = {engine.sign * origin:.17g}: rhs gives {list(f)}"
            )
        check_start(engine.rates, origin, run.rows[0], engine.sign)
    g, sizes = f, a or [abs(v) for v in y]
    if min(sizes) <= NO_SCALE:  # as at rest, if only round-off or a ramp moves it
        y = tuple(0.0 if size <= NO_SCALE else v for size, v in zip(sizes, y, strict=True))
        g = rhs(origin, y, c)
        both = zip(g, rhs(origin + SOON * span, _euler(SOON * span, y, g), c), strict=True)
        g = tuple(0.0 if abs(rate) < RAMP * abs(later) else rate for rate, later in both)
    h, t = _first_step(rhs, origin, span, y, g, c), origin
    if h < SOON * span:  # the rates may jump at the very start
        t, states = origin + h, (y, _euler(h, y, g))  # due to time, or as the state leaves it
        onward, moved = max((_first_step(rhs, t, span, state, rhs(t, state, c), c), state) for state in states)
        h, beyond = max(h, onward), rhs(t, moved, c)
        both = zip(g, beyond, strict=True)  # what moves only at that instant is at rest
        g = tuple(0.0 if abs(later) < RAMP * abs(rate) else later for rate, later in both)
        y = tuple(later if rate else v for v, later, rate in zip(y, moved, g, strict=True))
    if not control.atol and min(a, default=0.0) <= NO_SCALE:
        doublings = int(math.log(span / h, 4)) + 1 if engine.formulas.timed else 0
        later = [t + h * 4.0**k for k in range(doublings)]  # times at which a force may set in
        sizes = error_scale(rhs, t, h, y, g, c, later)
        if min(sizes) <= NO_SCALE and engine.formulas.timed:  # a force that sets in at once, and ends before t + h
            sizes = grown_scale(rhs, t, origin + span, y, sizes, [size <= NO_SCALE for size in sizes], c)
        start, zeros = tuple(run.rows[0].tolist()), (0.0,) * len(y)
        is_lacking = min(sizes) <= NO_SCALE
        by_rates = [engine.is_traced and size > abs(v) for size, v in zip(sizes, start, strict=True)]
        noise = engine.functions["roundoff"](origin, h, start, f, zeros, c) if is_lacking or any(by_rates) else zeros
        if is_lacking:  # a Hertz contact, which no small change reveals
            n = engine.functions["step"](t, h, y, zeros, g, sizes, zeros, run.rtol, c)[0]
            moves = (abs(later - v) for later, v in zip(n, y, strict=True))
            sizes = tuple(
                max(size, move) if least < move < math.inf else size
                for size, least, move in zip(sizes, noise, moves, strict=True)
            )
        floors = (bound if is_moved else NO_SCALE for bound, is_moved in zip(noise, by_rates, strict=True))
        fresh = (max(SHARE * control.rtol * size, floor, NO_SCALE) for size, floor in zip(sizes, floors, strict=True))
        a = tuple(new if old <= NO_SCALE else old for new, old in zip(fresh, a or [0.0] * len(y), strict=True))
    h = control.first_step or h
    atol, nothing = tuple(control.atol) or tuple(a), (0.0,) * len(y)
    return State(1, 0.0, h, tuple(run.rows[0].tolist()), nothing, f, atol, nothing, nothing, LARGEST, 0, 0, 0, RUNNING)


def _euler(h: float, y: Sequence[float], f: Sequence[float]) -> tuple[float, ...]:
    return tuple(v + h * rate for v, rate in zip(y, f, strict=True))


def _first_step(
    rhs: Rates, origin: float, span: float, y: Sequence[float], f: Sequence[float], c: Sequence[float]
) -> float:
    """Return a step size, s, across which the derivative changes little, by reduction of a long one.

    A derivative of zero does not mislead this search.
    """
    h = span / 100 or span
    while h > max(1e-15 * span, 2.0**-50 * abs(origin)):
        onward = _euler(h, y, f)
        g = rhs(origin + h, onward, c)
        # A component that starts at zero with zero rate affects the others only from the second step on.
        if not (_restless(h, y, f, g, 0.1) or _restless(h, y, f, rhs(origin + 2 * h, _euler(h, onward, g), c), 0.3)):
            break
        h /= 4
    return h


def _restless(h: float, y: Numbers, f: Numbers, g: Numbers, part: float) -> bool:
    """Return whether the derivative changes by more than a fraction `part` of the state, or of itself, within h.

    Components that start at zero with zero rate have no scale to compare with; the error estimates deal with them.
    """
    for i in range(len(y)):
        size = max(abs(y[i]), h * abs(f[i]))
        if size > 0 and not h * abs(g[i] - f[i]) <= part * max(size, h * abs(g[i])):
            return True
    return False


def shortest_step(engine: Engine, times: Array, start: Array, control: Control) -> float:
    """Return the shortest step, s, of this method after its first steps, and near the times where rates may change.

    Raise ValueError if the rates jump, or the error of the run if its steps become far too short, as at a pole.
    """
    begin, end = float(times[0]), float(times[-1])
    t, y, shortest, allowed, settled = begin, start, end - begin, 0.0, SETTLED
    a: Sequence[float] = ()
    while t < end:
        stop = engine.next_break(t, begin, end)
        run = start_run(engine, np.array([t, stop]), y, control)
        state = start_state(run, a)
        run.last = state._replace(h=max(state.h, allowed))
        attempts = MEASURED * (10 if stop < end or engine.formulas.timed else 1)
        shortest, allowed = _measured(run, shortest, settled, attempts)
        t, y, a = t + run.last.t if run.last.halt == SETS_IN else stop, np.array(run.last.y), run.last.a
        settled = max(settled - run.last.steps, 0)
    return shortest


def _measured(run: Run, shortest: float, settled: int, attempts: int) -> tuple[float, float]:
    """Run for a number of attempts; return the shortest step, s, after `settled` steps, and the step that may follow.

    shortest : of earlier stretches. If the steps become far too short, make more attempts, until the run says why.
    """
    engine, state, span = run.engine, run.last, float(run.since[-1])
    last, growing, allowed = span, 0, state.h
    for step in range(10 * MEASURED):
        if state.row == 2 or state.halt or step >= attempts and span < COMPILED * shortest:
            break
        before = state
        state = step_n(run, engine.functions["advance"], [0.0, span], lambda *_: None, state, 1)
        at_switch = engine.switches is not None and engine.switches.is_near
        if state.halt not in (RUNNING, SETS_IN):
            _give_up(run, state)
        if state.t == before.t and not at_switch:  # refused
            continue
        length = state.t - before.t
        growing = growing + 1 if length > 0.9 * LARGEST * last and state.refusals else 0
        if (growing == AFTER_A_JUMP or at_switch) and state.row < 2:
            where = engine.sign * (run.origin + state.t)
            raise ValueError(
                "method: steps of one length do not pass the short pulse or "
                f'jump of rhs near t = {where:.6g}; try "auto"'
            )
        is_limited, is_cut = state.h < 0.9 * LARGEST * length, 2 * before.h >= span - before.t
        allowed = state.h if is_limited else max(state.h, before.h)
        if step > settled:
            shortest = min(shortest, allowed if is_cut else length)
        last = length
    return shortest, allowed


def ensemble(engine: Engine, times: Array, starts: Array, how: str, control: Control) -> Array:
    """Return (m, n, k) states from the (m, k) starts, eight motions at a time in compiled code if that repays.

    how : "auto", "python" or "compiled"
    """
    rows = np.empty((len(starts), len(times), starts.shape[1]))
    first = integrate(engine, times, starts[0], how, control)
    rows[0] = first.rows
    is_left = np.arange(len(starts)) > 0
    graph, begin, end = engine.graph, float(times[0]), float(times[-1])
    any_steps = (
        control.max_step == np.inf and control.first_step is None and engine.next_break(begin, begin, end) == end
    )
    if graph is not None and len(starts) >= WORTH_LANES and any_steps:
        steps = (first.last.steps + first.last.refusals) * len(starts)
        if first.engine == "compiled" or how == "auto" and repays(steps, len(graph.operations)):
            from tam570.integrate.compiled import backend

            is_left &= backend.taylor_runs(graph, times, rows, starts, of_steps(engine, control)) == 0
    for i in np.flatnonzero(is_left):
        rows[i] = integrate(engine, times, starts[i], how, control).rows
    return rows
