"""The error, or an invariant, along a motion, from which a page draws a picture; stored with the result.

The curve is coarse, so that code that knows the hidden inputs can encode little of them in the shape of its errors:
at most BITS in a picture, and nothing about the times.
"""

import math

import numpy as np

from tam570.values import Json, Numbers

# plain data: quantity, unit, tolerance, scale ("log" or "linear"), values along the motion; keeps: another curve
Curve = Json

SLOTS = 16  # equal parts of the duration; the curve has the largest error in each
LEVELS = 2  # levels per decade of an error
STEPS = 7  # levels from zero to the largest drift of an invariant, on either side
FLOOR, CEILING = -1, 6  # decades relative to the tolerance; errors beyond are cut to these
LARGEST = 1e100  # drifts are cut to this size
# information in a curve: a level, or none, in each slot; two digits and the exponent of the largest drift
BITS = math.ceil(SLOTS * math.log2(max(LEVELS * (CEILING - FLOOR), 2 * STEPS) + 2) + math.log2(90 * 640))


def curve(  # noqa: PLR0913  the compared numbers, and their description
    t: Numbers, actual: Numbers, expected: Numbers, scale: Numbers, *, tolerance: float, quantity: str, unit: str
) -> Curve | None:
    """Return the error along the times t, None if there is too little to draw.

    The drift of an invariant (one number per time, expected to be constant) keeps its sign, which shows whether energy
    is lost or gained. If `t` has several motions, use the one with the largest error.
    """
    t, signed = np.asarray(t, float), np.asarray((actual - expected) / scale)
    if t.ndim != 1 or len(t) < 3 or signed.shape[:1] != t.shape or not np.isfinite(signed).all():
        return None
    rows = signed.reshape(len(t), -1)
    sizes = np.abs(rows).max(axis=1)
    motions = np.split(np.arange(len(t)), np.flatnonzero(np.diff(t) <= 0) + 1)  # in each of them time increases
    motion = next(indices for indices in motions if np.argmax(sizes) in indices)
    t, rows, sizes = t[motion], rows[motion], sizes[motion]
    if len(t) < 3:
        return None
    is_constant = rows.shape[1] == 1 and np.ptp(np.broadcast_to(expected, signed.shape)[motion]) == 0
    slot = np.minimum((SLOTS * (t - t[0]) / (t[-1] - t[0])).astype(int), SLOTS - 1)
    of_slots = (np.flatnonzero(slot == k) for k in range(SLOTS))
    largest = [int(indices[np.argmax(sizes[indices])]) if len(indices) else None for indices in of_slots]
    if is_constant:
        drift = rows[:, 0].clip(-LARGEST, LARGEST)
        step = float(f"{np.abs(drift).max():.2g}") / STEPS or 1.0
        values = [None if row is None else round(drift[row] / step) * step for row in largest]
    else:
        decades = np.log10(np.maximum(sizes, 1e-300) / tolerance).clip(FLOOR, CEILING)  # negative below the tolerance
        values = [None if row is None else round(LEVELS * decades[row]) / LEVELS for row in largest]
    scaled = "linear" if is_constant else "log"
    return {"quantity": quantity, "unit": unit, "tolerance": tolerance, "scale": scaled, "values": values}
