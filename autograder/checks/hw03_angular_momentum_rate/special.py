"""Find which motions of P and C are special at every t, by the coefficients of products of polynomials."""

import numpy as np

from .reference import cross, derivative, difference

IDENTITY = 1e-12  # relative; coefficients of a motion, and so of its products, have rounding errors of 1e-16
FAR_OFF = 1e-6  # the same for a motion far from O: at 1e7 m from it, one metre has a rounding error of 1e-9
CERTAIN = 1e-9  # relative; a larger coefficient is certainly not zero
NOTHING = 1e-8  # of the largest; at a double zero, the minimum found is below the root of the rounding error
LONGEST = 100  # coefficients of a motion, at most
GRID, FINER = np.linspace(0, 1, 2001), np.linspace(0, 1, 17)[:, None]


def smallest(p):
    """Return the smallest magnitude of a vector of polynomials for 0 <= t <= 1, and its t; use finer grids at dips."""

    def magnitude(t):
        return np.linalg.norm(np.polynomial.polynomial.polyval(t, p), axis=0)

    padded = np.pad(magnitude(GRID), 1, constant_values=np.inf)
    dips = np.flatnonzero((padded[1:-1] < padded[2:]) & (padded[1:-1] <= padded[:-2]))
    low, high = GRID[np.maximum(dips - 1, 0)], GRID[np.minimum(dips + 1, len(GRID) - 1)]
    for _ in range(16):  # an eighth of the width each time: to 1e-17
        times = low + (high - low) * FINER
        middle = np.take_along_axis(times, np.argmin(magnitude(times), axis=0)[None], axis=0)[0]
        low, high = np.maximum(low, middle - (high - low) / 16), np.minimum(high, middle + (high - low) / 16)
    times = np.append([0.0, 1.0], (low + high) / 2)
    where = np.argmin(magnitude(times))
    return magnitude(times)[where], times[where]


def extent(p):
    """Return a bound on a vector of polynomials for 0 <= t <= 1."""
    return np.abs(p).sum()


def violation(definition, p, c):
    """Return the size of the product that vanishes if rate = moment; whether it is zero; whether it surely is not."""
    speed, is_b = derivative(c), definition == "b"
    factors = (speed, derivative(p)) if is_b else (difference(p, c), derivative(speed))  # v_C x v_P or r_{P/C} x a_C
    sizes = [np.abs(vector).max() or 1.0 for vector in factors]
    first, other = (vector / size for vector, size in zip(factors, sizes, strict=True))  # no product may overflow
    worst, scale = np.abs(cross(first, other)).max(), extent(first) * extent(other)
    rounded = scale if is_b else (extent(p) + extent(c)) / sizes[0] * extent(other)
    holds, fails = worst <= min(IDENTITY * rounded, FAR_OFF * scale), worst > max(CERTAIN * scale, IDENTITY * rounded)
    return worst / (scale or 1.0), holds, fails


def flaws(definition, p, c):
    """Yield the flaws of a motion for which this definition should hold and the other fail, each with a hint."""
    if max(len(p), len(c)) > LONGEST:
        yield f"the motion has more than {LONGEST} coefficients", ""
    apart, speed = difference(p, c), derivative(c)
    still, rounded = NOTHING * extent(speed), IDENTITY * (extent(p) + extent(c))
    for vector, limit, what in (
        (speed, still, "the velocity of C vanishes"),
        (derivative(speed), still, "the acceleration of C vanishes"),
        (apart, max(NOTHING * extent(apart), rounded), "P and C meet"),
    ):
        least, when = smallest(vector)
        if not least > limit:
            yield f"{what} at t = {when:.2g}", ""
    if not extent(apart[1:]) > max(CERTAIN * extent(speed), rounded):
        yield "P moves along with C: the vector between them does not change", ""
    other = {"b": "c", "c": "b"}[definition]
    (size, holds, _), (_, other_holds, other_fails) = (violation(first, p, c) for first in (definition, other))
    if not holds:
        swapped = f"By definition {other} they are equal" if other_holds else ""
        hint = swapped or "Which product must vanish, and at every t? Multiply the polynomials out"
        yield f"Rate and moment differ by {size:.2g} of their size", hint
    if not other_fails:
        yield f"Definition {other} has rate = moment, too, along the motion", ""


def order_hint(definition, p, c):
    """Return a hint for a motion that has no flaw with P and C exchanged, or coefficients reversed or transposed.

    While P rests, definition b holds for any motion of C: then only a highest coefficient of zero shows the reversal.
    """
    orders = {"Are P and C swapped? The motion of P comes first": (c, p)}
    if definition == "c" or np.any(p[:-1]) or not np.any(c[-1]):
        orders["The sum starts at j = 0: p[0] and c[0] are the positions at t = 0"] = (p[::-1], c[::-1])
    if len(p) == len(c) == 3:
        orders["Rows and columns are exchanged: row j has the components of the coefficient of t^j"] = (p.T, c.T)
    return next((message for message, pair in orders.items() if next(flaws(definition, *pair), None) is None), "")
