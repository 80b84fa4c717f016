"""How an error or an invariant goes along a motion: what a page's picture is drawn from, kept with the result.

It is coarse, so that code which knows the hidden inputs can write little of them into the shape of its own errors:
at most BITS of them into one picture, and nothing about the times.
"""

import math

import numpy as np
from numpy.typing import NDArray

from tam570.values import Json, Numbers

# plain data: quantity, unit, tolerance, scale ("log" or "linear"), values along the motion; keeps: another
Curve = Json
Array = NDArray[np.float64]

SLOTS = 16  # of the duration, the largest error in each
LEVELS = 2  # to a decade of an error
STEPS = 7  # to the largest drift of an invariant, to either side
FLOOR, CEILING = -1, 6  # decades below and above the limit that are told apart
LARGEST = 1e100  # of a drift, which is cut to this
# what a picture can tell: a level, or that it is empty, in each slot; and two digits and an exponent of the largest
BITS = math.ceil(SLOTS * math.log2(max(LEVELS * (CEILING - FLOOR), 2 * STEPS) + 2) + math.log2(90 * 640))


def curve(  # noqa: PLR0913  what is compared, and the words for it
    t: Numbers, actual: Numbers, expected: Numbers, scale: Numbers, *, tolerance: float, quantity: str, unit: str
) -> Curve | None:
    """Return the error along the times t, None if there is no course of it to draw.

    An invariant (one number at each time, expected to stay) keeps its sign: whether energy is lost or gained tells.
    Of several motions in a row, that with the largest error is taken.
    """
    t, signed = np.asarray(t, float), np.asarray((actual - expected) / scale)
    if t.ndim != 1 or len(t) < 3 or signed.shape[:1] != t.shape or not np.isfinite(signed).all():
        return None
    rows = signed.reshape(len(t), -1)
    sizes = np.abs(rows).max(axis=1)
    motion = _one_motion(t, int(np.argmax(sizes)))
    t, rows, sizes = t[motion], rows[motion], sizes[motion]
    if len(t) < 3:
        return None
    is_constant = rows.shape[1] == 1 and np.ptp(np.broadcast_to(expected, signed.shape)[motion]) == 0
    slots = _slots(t, sizes)
    values = _steps(rows[:, 0], slots) if is_constant else _levels(sizes, slots, tolerance)
    scaled = "linear" if is_constant else "log"
    return {"quantity": quantity, "unit": unit, "tolerance": tolerance, "scale": scaled, "values": values}


def _one_motion(t: Array, row: int) -> slice:
    """Return the rows around this one along which time goes on."""
    breaks = np.flatnonzero(np.diff(t) <= 0) + 1
    ends = np.concatenate([[0], breaks, [len(t)]])
    index = int(np.searchsorted(ends, row, side="right"))
    return slice(int(ends[index - 1]), int(ends[index]))


def _slots(t: Array, sizes: Array) -> list[int | None]:
    """In equal slots of the duration, the row with the largest error."""
    slot = np.minimum((SLOTS * (t - t[0]) / (t[-1] - t[0])).astype(int), SLOTS - 1)
    return [int(rows[np.argmax(sizes[rows])]) if len(rows := np.flatnonzero(slot == k)) else None for k in range(SLOTS)]


def _levels(sizes: Array, slots: list[int | None], tolerance: float) -> list[float | None]:
    """Decades above the limit, below it where negative."""
    decades = np.log10(np.maximum(sizes, 1e-300) / tolerance).clip(FLOOR, CEILING)
    return [None if row is None else round(LEVELS * decades[row]) / LEVELS for row in slots]


def _steps(drift: Array, slots: list[int | None]) -> list[float | None]:
    drift = drift.clip(-LARGEST, LARGEST)
    step = float(f"{np.abs(drift).max():.2g}") / STEPS or 1.0
    return [None if row is None else round(drift[row] / step) * step for row in slots]
