"""Fixed steps and samples: the loop around a generated leap. Plain enough for a compiler to take as it is."""

from collections.abc import Callable
from typing import NamedTuple

from tam570.values import Function, Numbers

__all__ = ["FixedState", "fixed_loop_with"]


class FixedState(NamedTuple):
    """Where a run is."""

    row: int  # the next sample
    done: int  # steps
    y: tuple[float, ...]
    r: tuple[float, ...]  # what rounding took from y
    k: tuple[float, ...]  # first guess of the next step's stages


def fixed_loop_with(leap: Function) -> Callable[..., FixedState]:
    """Return the loop over the steps of a run."""

    def march(
        origin: Numbers, times: Numbers, out: Numbers, state: Numbers, c: Numbers, h: Numbers, budget: Numbers
    ) -> Numbers:
        """Fill the rows of `out` until none is left or `budget` steps are spent.

        times : since `origin`; state : a `FixedState`, as returned. A sample inside a step is reached by a
        shorter step from the step's start that leaves the motion alone.
        """
        row, done, y, r, k = state
        while row < len(times) and budget > 0:
            budget -= 1
            t = done * h  # not summed up: no error of time grows
            n, rest, onward = leap(origin + t, h, y, r, k, c)
            while row < len(times) and times[row] <= t + h * (1.0 + 2.0**-40):
                sample = n
                if times[row] < t + h * (1.0 - 2.0**-40):  # a sample this close to the end of a step is its end
                    sample = leap(origin + t, times[row] - t, y, r, k, c)[0]
                for i in range(len(n)):
                    out[row, i] = sample[i]
                row += 1
            y, r, k, done = n, rest, onward, done + 1
        return FixedState(row, done, y, r, k)

    return march
