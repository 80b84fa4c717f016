"""Many starts of one system: eight motions at a time in compiled code where that repays, else one after the other."""

import time

import numpy as np

from tam570.integrate.adaptive import Control, integrate
from tam570.integrate.arguments import Array
from tam570.integrate.compilation import seconds_until_compiled
from tam570.integrate.engine import Engine

__all__ = ["states"]

WORTH_LANES = 16  # members: with fewer the code for eight motions is not worth its compilation


def states(engine: Engine, times: Array, starts: Array, how: str, control: Control) -> Array:
    """(m, n, k) states at `times` from the (m, k) starts; how: "auto", "python" or "compiled"."""
    rows = np.empty((len(starts), len(times), starts.shape[1]))
    began = time.perf_counter()
    rows[0] = integrate(engine, times, starts[0], how, control).rows
    alone = (time.perf_counter() - began) * len(starts)
    is_left = np.arange(len(starts)) > 0
    graph = engine.graph
    repays = how == "auto" and graph is not None and alone > seconds_until_compiled(len(graph.operations))
    many = len(starts) >= WORTH_LANES and (repays or how == "compiled")
    if graph is not None and many and _is_smooth(engine, times, control):
        from tam570.integrate.compiled import backend

        is_left &= backend.taylor_runs(graph, times, rows, starts, control) == 0
    for i in np.flatnonzero(is_left):
        rows[i] = integrate(engine, times, starts[i], how, control).rows
    return rows


def _is_smooth(engine: Engine, times: Array, control: Control) -> bool:
    """Whether one stretch goes to the end, in steps of any length."""
    end = float(times[-1])
    plain = control.max_step == np.inf and control.first_step is None
    return plain and engine.is_traced and engine.next_break(float(times[0]), end, times) == end
