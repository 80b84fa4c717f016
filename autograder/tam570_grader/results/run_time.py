"""Run time against error of the integrators, from the benchmark, to compare a student's simulation with."""

import functools
import json
import math
from collections.abc import Sequence
from pathlib import Path

from tam570.values import Json

Speed = Json  # function, scene, seconds, error, machine: plain data


@functools.cache
def scenes() -> Json:
    """Return for each assignment a call, its right end state, and each method's curve of (seconds, error) pairs."""
    path = Path(__file__).with_name("run_time.json")
    table: Json = json.loads(path.read_text(encoding="utf-8"))
    return table


def time_to(error: float, curve: Sequence[Sequence[float]]) -> float | None:
    """Return the seconds to an error, interpolated in logarithms; None if the curve does not reach the error."""
    for (t1, e1), (t2, e2) in zip(curve, curve[1:], strict=False):
        if e1 > error >= e2:
            share = math.log(e1 / error) / math.log(e1 / e2)
            return float(t1 * (t2 / t1) ** share)
    return curve[0][0] if curve and curve[0][1] <= error else None
