"""Many starts of one system: eight motions at a time in compiled code where that repays, else one after the other."""

import numpy as np

from tam570.integrate.adaptive import Control, integrate
from tam570.integrate.arguments import Array
from tam570.integrate.compilation import repays
from tam570.integrate.engine import Engine

__all__ = ["states"]

WORTH_LANES = 16  # members: with fewer the code for eight motions is not worth its compilation


def states(engine: Engine, times: Array, starts: Array, how: str, control: Control) -> Array:
    """(m, n, k) states at `times` from the (m, k) starts; how: "auto", "python" or "compiled"."""
    rows = np.empty((len(starts), len(times), starts.shape[1]))
    first = integrate(engine, times, starts[0], how, control)
    rows[0] = first.rows
    is_left = np.arange(len(starts)) > 0
    graph = engine.graph
    if graph is not None and len(starts) >= WORTH_LANES and _is_smooth(engine, times, control):
        steps = (first.last.steps + first.last.refusals) * len(starts)
        if first.engine == "compiled" or how == "auto" and repays(steps, len(graph.operations)):
            from tam570.integrate.compiled import backend

            is_left &= backend.taylor_runs(graph, times, rows, starts, control) == 0
    for i in np.flatnonzero(is_left):
        rows[i] = integrate(engine, times, starts[i], how, control).rows
    return rows


def _is_smooth(engine: Engine, times: Array, control: Control) -> bool:
    """Return whether one stretch goes to the end, in steps of any length."""
    end = float(times[-1])
    plain = control.max_step == np.inf and control.first_step is None
    begin = float(times[0])
    return plain and engine.is_traced and engine.next_break(begin, begin, end) == end
