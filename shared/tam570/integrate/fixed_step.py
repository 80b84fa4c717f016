"""Long runs at a fixed step by the methods that keep the structure of mechanics."""

import math
from functools import lru_cache, partial

import numpy as np

from tam570.integrate.adaptive import FOREVER, Control, shortest_step
from tam570.integrate.arguments import Array
from tam570.integrate.compilation import repays
from tam570.integrate.composition_source import composition_source
from tam570.integrate.engine import Engine
from tam570.integrate.fixed_loop import FixedState, fixed_loop_with
from tam570.integrate.formulas import halves
from tam570.integrate.gauss_source import STAGES, gauss_source
from tam570.values import Function, Numbers

__all__ = ["METHODS", "states"]

METHODS = {"gauss": 3.5, "composition": 0.5}  # step over the shortest that DOP853 takes at the same rtol

SWEEPS = {"gauss": 0.7, "composition": 0.1}  # over the lines of the source in a step, a twelfth: as `repays` counts


def states(method: str, engine: Engine, times: Array, start: Array, control: Control, step: float | None) -> Array:
    """(n, k) states at `times`, all steps of the same length."""
    rows = np.empty((len(times), len(start)))
    rows[0] = start
    origin, since = float(times[0]), times - times[0]
    listed, h = since.tolist(), _step(method, engine, times, start, control, step)
    source, constants = _source(method, engine, len(start))
    python = fixed_loop_with(_leap(source, engine))

    def march(function: Function, since: Numbers, state: Numbers, budget: int) -> Numbers:
        return function(origin, since, rows, state, constants, h, budget)

    def share(state: Numbers) -> float:
        return 1.0 if state.row == len(rows) else min(state.done * h / listed[-1], 0.999)

    state = _at_start(method, engine, origin, start)
    lines = source.count("\n")
    if engine.is_traced and repays(SWEEPS[method] * listed[-1] / h, lines):
        try:
            from tam570.integrate.compiled import backend

            compiled = backend.fixed(source, len(start), len(state.k), len(constants))
            backend.by_moments(partial(march, compiled, since), share, state)
        except (ImportError, OSError, RuntimeError):  # a broken llvmlite: nobody asked for it
            march(python, listed, state, FOREVER)
    else:
        march(python, listed, state, FOREVER)
    if not np.isfinite(rows).all():
        raise ArithmeticError(f"the stages do not settle at a step of {h:.3g} s: give a shorter `step`")
    return rows


def _step(method: str, engine: Engine, times: Array, start: Array, control: Control, step: float | None) -> float:
    """Return a step that divides the whole run, no longer than asked for."""
    if step is not None and not 0 < step < math.inf:
        raise ValueError(f"step: must be positive and finite, got {step!r}")
    span = float(times[-1] - times[0])
    longest = step or METHODS[method] * shortest_step(engine, times, start, control)
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


def _leap(source: str, engine: Engine) -> Numbers:
    namespace = {**vars(math), "given": engine.functions["given"]}
    exec(_code(source), namespace)
    return namespace["leap"]


def _at_start(method: str, engine: Engine, origin: float, start: Array) -> FixedState:
    """Row 1 is to come, no step is done; all stages start with the derivative at the start."""
    y = tuple(start.tolist())
    stages = engine.functions["rhs"](origin, y, engine.constants) * STAGES if method == "gauss" else (0.0,)
    return FixedState(1, 0, y, (0.0,) * len(y), stages)
