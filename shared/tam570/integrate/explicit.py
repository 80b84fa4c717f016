"""Runge-Kutta of order 8 with automatic steps: the generated step, driven by Python or, if it repays, compiled."""

import sys
import time
from dataclasses import dataclass
from functools import lru_cache
from types import FunctionType
from typing import Any

import numpy as np

from tam570.integrate import drive
from tam570.integrate.problem import Array, Rates, agrees, floats_function
from tam570.integrate.source import Formulas, call_of, compiled
from tam570.integrate.trace import traced

__all__ = ["Engine", "engine", "states"]

PROBE = 100  # steps before the clock is read
READY = 0.05  # s, to load what was compiled before
IMPORT = 0.4  # s, of numba


@dataclass(frozen=True)
class Engine:
    """The functions generated for a right-hand side, and the constants of its scene."""

    functions: dict[str, Any]
    constants: tuple[float, ...] = ()
    formulas: Formulas | None = None  # None where it could not be traced

    def __getattr__(self, name: str) -> Any:
        return self.functions[name]


def engine(rates: Rates, times: Array, start: Array) -> Engine:
    """Functions for the right-hand side as traced, if it can be and agrees; else for calls of it."""
    sampled = len(times) > 2
    try:
        formulas, constants = traced(rates, len(start))
        functions = _functions(formulas, sampled)
        if agrees(rates, functions["rhs"], constants, times, start):
            return Engine(functions, constants, formulas)
    except Exception:  # whatever a function says to symbols, it then gets numbers
        pass
    given = floats_function(rates, float(times[0]), start)
    return Engine(_with_loop(compiled(call_of(len(start)), sampled, given)))


@lru_cache(maxsize=256)
def _functions(formulas: Formulas, sampled: bool) -> dict[str, Any]:
    return _with_loop(compiled(formulas, sampled))


def _with_loop(functions: dict[str, Any]) -> dict[str, Any]:
    """The generated functions and, with these for its global names, the loop around them."""
    functions |= {name: value for name, value in vars(drive).items() if name.isupper() or name == "sqrt"}
    for loop in (drive.first_step, drive.advance):
        functions[loop.__name__] = FunctionType(loop.__code__, functions)
    return functions


def states(kit: Engine, times: Array, start: Array, rtol: float, *, compile_: bool | None = None) -> Array:
    """(n, k) states at `times`. compile_: True and False insist; None decides by what is left to do."""
    rows = np.empty((len(times), len(start)))
    rows[0] = start
    origin, since = float(times[0]), times - times[0]
    state = _at_start(kit, origin, float(since[-1]), start)
    if not compile_:
        state = _in_python(kit, origin, since, rows, state, rtol, forever=compile_ is False)
    if state[0] < len(times) and state[2] > 0:
        from tam570.integrate import machine

        assert kit.formulas is not None
        walk = machine.walker(kit.formulas)
        state = walk(origin, since, rows, state, kit.constants, rtol, np.iinfo(np.int64).max)
    if state[2] == 0.0:
        raise ArithmeticError(
            f"no step is short enough at t = {origin + state[1]:.17g}: rhs or solution not finite"
        )
    return rows


def _at_start(kit: Engine, origin: float, span: float, start: Array) -> tuple[Any, ...]:
    y = tuple(start.tolist())
    f = kit.rhs(origin, y, kit.constants)
    h = kit.first_step(origin, span, y, f, tuple(map(abs, y)), kit.constants)
    m = tuple(max(abs(x), h * abs(rate), 1e-300) for x, rate in zip(y, f, strict=True))  # never 0: it divides
    return 1, 0.0, h, y, (0.0,) * len(y), f, m


def _wait(formulas: Formulas) -> float:
    """Seconds until compiled code could start, on a machine of today; infinite without numba."""
    from tam570.integrate import machine

    if not machine.available():
        return float("inf")
    imported = 0.0 if "numba" in sys.modules else IMPORT
    return imported + (READY if machine.kept(formulas) else machine.seconds_to_compile(formulas))


def _in_python(
    kit: Engine, origin: float, since: Array, rows: Array, state: Any, rtol: float, *, forever: bool
) -> Any:
    """Steps in Python until the end, or until compiled code would get there sooner, compilation included."""
    list_of_times, budget = since.tolist(), PROBE
    wait = float("inf") if forever or kit.formulas is None else _wait(kit.formulas)
    began = time.perf_counter()
    while True:
        state = kit.advance(origin, list_of_times, rows, state, kit.constants, rtol, budget)
        row, reached, h, *_ = state
        if row == len(rows) or h == 0.0:
            return state
        left = (time.perf_counter() - began) * (list_of_times[-1] / reached - 1) if reached else 0.0
        if left > wait:
            return state
        budget *= 2
