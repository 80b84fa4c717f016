"""Runs that return more than samples: events, dense output and a report."""

from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from numbers import Real
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from tam570.integrate import adaptive
from tam570.integrate.adaptive_loop import GENERATED, STOPPED, State, loop_with
from tam570.integrate.arguments import Array
from tam570.integrate.engine import Engine
from tam570.integrate.rates import bound
from tam570.integrate.watch import PYTHON
from tam570.values import Function, Numbers, Parameters


@dataclass(frozen=True)
class Report:
    """Statistics of a run.

    Parameters
    ----------
    engine : str
        "Python" or "compiled".
    untraced_reason : str
        Why the right-hand side was called unchanged instead of traced; empty if it was traced.
    unseen_reason : str
        Why switches of a called rhs cannot be detected: it is then evaluated at a thousand more points. Else empty.
    steps : int
    refusals : int
        Steps that were refused and repeated with a smaller step size.
    evaluations : int or None
        Evaluations of the right-hand side in these steps, twelve each; None in compiled code.
    atol : (k,) ndarray
        Absolute tolerance of each component; if you omitted it, it follows from the start.
    """

    engine: str
    untraced_reason: str
    unseen_reason: str
    steps: int
    refusals: int
    evaluations: int | None
    atol: Array


class Crossing(NamedTuple):
    """Zero crossings of an event function: times (c,) and states (c, k), in the order of the run."""

    t: Array
    states: Array


@dataclass(frozen=True)
class Motion:
    """A motion with its events, dense output and report.

    Parameters
    ----------
    t : (n,) ndarray
        The times passed to `solve`, up to a terminal event.
    states : (n, k) ndarray
    events : tuple of Crossing
        The zero crossings of each event function.
    at : callable or None
        at(time or times) returns (k,) or (n, k) states; None without `dense`.
    report : Report
    """

    t: Array
    states: Array
    events: tuple[Crossing, ...]
    at: Callable[[ArrayLike], Array] | None
    report: Report


NODES = (1.0 - np.cos(np.pi * np.arange(9) / 8)) / 2  # Chebyshev points of a step, to resolve an event function
BETWEEN = np.array([0.07, 0.3, 0.58, 0.87])  # test points for the interpolating polynomial through NODES
LOOKS = np.sort([*NODES, *BETWEEN])
UNTOLD = 1.0 * (BETWEEN[:, None] == LOOKS)  # matrix from values at LOOKS to errors of the polynomial
UNTOLD[:, np.isin(LOOKS, NODES)] = -np.vander(BETWEEN, 9) @ np.linalg.inv(np.vander(NODES))
UNLIKE, SHORTEST = 0.01, 2.0**-7  # relative error above which a part of a step is halved; shortest such part, of a step
NEXT = 2.0**-20  # of a step, distance from its ends of two more samples, to detect dips there
TOUCH = 1e-6  # of its size nearby, depth of a dip below zero; less may be round-off of a function that touches zero
Look = tuple[float, float]  # fraction of a step, value of an event function there


@dataclass(frozen=True)
class StepInterpolant:
    """A step from t to t + h in the engine's time. state : state(x) at the fraction x of the step."""

    t: float
    h: float
    state: Callable[[float], Array]

    @property
    def end(self) -> float:
        return self.t + self.h

    def up_to(self, t: float) -> "StepInterpolant":
        """Return the part of the step that ends at t."""
        part = min((t - self.t) / self.h, 1.0)
        return StepInterpolant(self.t, part * self.h, lambda x: self.state(part * x))


@dataclass(frozen=True)
class Event:
    """An event function. direction : of crossings, 0 for both; last : number of the one that ends the run, or 0."""

    value: Callable[[float, Array], float]
    direction: float
    last: int


@dataclass
class Watch:
    """Detects events along a run up to `end`, and records steps for dense output.

    signs : the last nonzero value of each event function; 0 if there was none, so a zero at the start does not count
    seen  : time, index of the event and state of each crossing
    """

    events: Sequence[Event]
    dense: bool
    end: float
    signs: list[float]
    seen: list[tuple[float, int, Array]]
    steps: list[StepInterpolant]

    def on_step(self, step: StepInterpolant) -> bool:
        """Record the events in a step; return whether the run continues."""
        if self.dense:
            self.steps.append(step)
        for x, which in self._crossings(step):
            self.seen.append((step.t + x * step.h, which, step.state(x)))
            if sum(event == which for _, event, _ in self.seen) == self.events[which].last:
                return False
        return True

    def _crossings(self, step: StepInterpolant) -> list[tuple[float, int]]:
        """Return (fraction of the step, index of the event) of each crossing in a step, in order."""
        crossings = []
        for which, event in enumerate(self.events):

            def level(x: float, value: Function = event.value) -> float:
                return value(step.t + x * step.h, step.state(x))  # type: ignore[no-any-return]

            low = 0.0
            for x, value in _looks(level):
                before = self.signs[which]
                at_end = value == 0 and x == 1 and step.end >= self.end  # a zero at the end of the run counts
                direction = -before if at_end else value
                if before and (at_end or value * before < 0) and direction * event.direction >= 0:
                    crossings.append((1.0 if at_end else _located(level, low, x, value > 0), which))
                self.signs[which] = value or before if value == value else 0.0  # NaN has no sign
                low = x
        return sorted(crossings, key=lambda crossing: crossing[0])


def _looks(level: Callable[[float], float]) -> list[Look]:
    """Return samples of an event function in a step, in order.

    They include samples beyond zero if the function crosses zero and returns between other samples.
    """
    looks = _resolved(level, 0.0, 1.0)
    ends = (NEXT, looks[0], looks[1]), (1.0 - NEXT, looks[-1], looks[-2])
    nearest = [(x, level(x)) for x, end, neighbour in ends if abs(end[1]) <= abs(neighbour[1])]
    points = sorted([*looks, *nearest])
    dips = (_dip(level, *three) for three in zip(points, points[1:], points[2:], strict=False))
    return sorted([*looks[1:], *filter(None, dips)])


def _resolved(level: Callable[[float], float], low: float, high: float) -> list[Look]:
    """Return samples between two fractions of a step, so dense that a polynomial reproduces the event function."""
    values = [(x, level(x)) for x in (low + (high - low) * LOOKS).tolist()]
    v = np.array(values)[:, 1]
    if high - low <= SHORTEST or not np.abs(UNTOLD @ v).max() > UNLIKE * np.abs(v).max():
        return values
    middle = (low + high) / 2
    return _resolved(level, low, middle) + _resolved(level, middle, high)[1:]


def _dip(level: Callable[[float], float], earlier: Look, least: Look, later: Look) -> Look | None:
    """Return a sample of opposite sign between three samples of equal sign, `least` closest to zero; None if none."""
    sign = 1.0 if least[1] > 0 else -1.0
    size = max(sign * earlier[1], sign * later[1])
    while 0.0 < sign * least[1] <= min(sign * earlier[1], sign * later[1]):
        if sign * least[1] > 2.0 * (max(sign * earlier[1], sign * later[1]) - sign * least[1]):
            return None  # too flat to reach zero
        wider = earlier if least[0] - earlier[0] > later[0] - least[0] else later
        x = (least[0] + wider[0]) / 2
        new = x, level(x)
        if sign * new[1] < sign * least[1]:
            earlier, least, later = (least, new, later) if wider is later else (earlier, new, least)
        elif wider is later:
            later = new
        else:
            earlier = new
        if sign * least[1] < -TOUCH * size:
            return least
        if later[0] - earlier[0] < NEXT:
            return None
    return None


def _located(level: Callable[[float], float], low: float, high: float, positive: bool) -> float:
    """Return the first fraction at which the event function has its new sign, by bisection to the last bit."""
    while True:
        middle = (low + high) / 2
        if not low < middle < high:
            return high
        value = level(middle)
        low, high = (low, middle) if value and (value > 0) == positive else (middle, high)


def _event(which: int, function: Function, parameters: Parameters | None, sign: float) -> Event:
    """Return an event with the attributes of `function` that solve_ivp supports; ValueError if they are invalid.

    sign : -1 if the engine's time is -t
    """
    name = f"events: event {which}"
    if not callable(function):
        raise ValueError(
            f"events: must be a function of (t, y, **parameters), got {type(function).__name__} as event {which}"
        )
    call = bound(function, parameters, "events")
    direction, terminal = getattr(function, "direction", 0.0), getattr(function, "terminal", False)
    if not isinstance(direction, Real) or direction != direction:
        raise ValueError(f"{name}: direction must be a number, got {direction!r}")
    last = 0 if terminal is None else terminal
    if not isinstance(last, float | int | np.number | np.bool_) or not last >= 0 or not float(last).is_integer():
        raise ValueError(f"{name}: terminal must be True, False or a whole number above zero, got {terminal!r}")

    def value(t: float, y: Array) -> float:
        level = call(sign * t, y)
        if type(level) is float:  # faster than the tests below
            return level
        if not isinstance(level, Real) and not (isinstance(level, np.ndarray | np.generic) and level.shape == ()):
            raise ValueError(f"{name} must return a number, got {level!r}")
        if isinstance(level, bool | np.bool_):  # a bool never changes sign
            raise ValueError(
                f"{name} must return a number that passes zero, got {level!r}: the difference of two sides"
            )
        return float(level)

    return Event(value, float(direction), int(last))


def motion(
    engine: Engine,
    times: Array,
    start: Array,
    control: adaptive.Control,
    events: Numbers,
    parameters: Parameters | None,
    dense: bool,
    how: str,
) -> Motion:
    """Return the motion with its events, and with dense output if `dense`.

    how : as in `adaptive.integrate`
    """
    if events is None and not dense:
        solution = adaptive.integrate(engine, times, start, how, control)
        return Motion(_signed(engine.sign, times), solution.rows, (), None, _report(engine, solution, control))
    functions = [] if events is None else [events] if callable(events) else list(events)
    listed = [_event(which, function, parameters, engine.sign) for which, function in enumerate(functions)]
    signs = [event.value(float(times[0]), start.copy()) for event in listed]
    watch = Watch(listed, dense, float(times[-1]), [sign if sign == sign else 0.0 for sign in signs], [], [])
    solution = adaptive.integrate(engine, times, start, "python", control._replace(on_step=watch.on_step))
    reached = watch.seen[-1][0] if solution.last.halt == STOPPED else float(times[-1])
    rows = times <= reached
    return Motion(
        _signed(engine.sign, times[rows]),
        solution.rows[rows],
        tuple(_crossing(engine.sign, which, watch, len(start)) for which in range(len(listed))),
        function_of_time([*watch.steps[:-1], watch.steps[-1].up_to(reached)], engine.sign) if dense else None,
        _report(engine, solution, control),
    )


def _crossing(sign: float, which: int, watch: Watch, size: int) -> Crossing:
    """Return the crossings of the event with index `which`."""
    times, states = ([x[index] for x in watch.seen if x[1] == which] for index in (0, 2))
    return Crossing(sign * np.array(times, dtype=float), np.array(states, dtype=float).reshape(len(states), size))


def _report(engine: Engine, solution: adaptive.Solution, control: adaptive.Control) -> Report:
    """Return the report of a run."""
    last, name = solution.last, solution.engine
    evaluations = 12 * (last.steps + last.refusals) if name == "Python" else None
    unseen = engine.switches.unseen_reason if engine.switches else ""
    return Report(name, engine.untraced_reason, unseen, last.steps, last.refusals, evaluations, np.array(last.a))


def _signed(sign: float, times: Array) -> Array:
    return times if sign > 0 else 0.0 - times


def function_of_time(steps: Sequence[StepInterpolant], sign: float) -> Callable[[ArrayLike], Array]:
    """Return at(times), which evaluates the interpolants of the steps; sign : -1 if the engine's time is -t."""
    ends = [step.end for step in steps]

    def state(time: float) -> Array:
        t = sign * time
        if not steps[0].t <= t <= ends[-1]:
            first, last = sorted((sign * steps[0].t, sign * ends[-1]))
            raise ValueError(f"t: the motion is known from {first:.12g} to {last:.12g}, not at {time:.12g}")
        step = steps[min(bisect_left(ends, t), len(steps) - 1)]
        return step.state((t - step.t) / step.h)

    def at(times: ArrayLike) -> Array:
        """Return (..., k) states at an array of times, or (k,) at one; raise ValueError outside the run."""
        listed = np.asarray(times, dtype=float)
        states = np.array([state(time) for time in listed.ravel().tolist()])
        return states.reshape(*listed.shape, len(steps[0].state(0.0)))

    return at


def step_by_step(run: adaptive.Run) -> None:
    """Run to the end; limit each step before it, and project the state or call `on_step` after it."""
    functions, control, state = run.engine.functions, run.control, run.last
    tried: list[Numbers] = [None]

    def step(*inputs: Numbers) -> Numbers:
        tried[0] = (*inputs[:3], inputs[4], functions["step"](*inputs))  # the last attempt is the accepted step
        return tried[0][-1]

    advance = loop_with(step, *(functions[name] for name in GENERATED[1:]))
    since, look = run.since.tolist(), run.watch(PYTHON)

    while run.share(state) < 1:
        steps_before = state.steps
        if control.longest:
            state = state._replace(h=min(state.h, control.longest(np.array(state.y))))
        state = adaptive.step_n(run, advance, since, look, state, 1)
        if state.steps == steps_before:
            continue
        if control.project:
            state = _projected(run, state, control.project)
        elif control.on_step and not control.on_step(_interpolant(functions, run.engine.constants, tried[0])):
            state = state._replace(halt=STOPPED)
        run.last = state


def _projected(run: adaptive.Run, state: State, project: Callable[[Array], Numbers]) -> State:
    """Return the state after projection, with the derivative there."""
    returned = project(np.array(state.y))
    if returned is None or np.shape(returned) != (len(state.y),):
        raise ValueError(f"project: must return a state of {len(state.y)} numbers, got {returned!r}")
    y = tuple(np.asarray(returned, dtype=float).tolist())
    f = run.engine.functions["rhs"](run.origin + state.t, y, run.engine.constants)
    return state._replace(y=y, r=(0.0,) * len(y), f=f)


def _interpolant(functions: dict[str, Numbers], c: Numbers, tried: tuple[Numbers, ...]) -> StepInterpolant:
    start, h, y, f, (n, _, g, _, _, stages) = tried
    q = functions["dense"](start, h, y, n, f, g, stages, c)

    def state(x: float) -> Array:
        if x == 1:
            return np.array(n)
        row = np.empty((1, len(y)))
        functions["at"](row, 0, x, y, q)
        return row.ravel()

    return StepInterpolant(start, h, state)
