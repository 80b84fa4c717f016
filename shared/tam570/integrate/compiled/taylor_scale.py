"""Sizes for Taylor's method, as Python that is translated: of what is zero at the start.

As in `error_scale`, which this follows, what is zero and has a rate of zero takes the size that the others give it.
"""

from math import inf

from tam570.integrate.compiled.taylor_memory import BASE, ORDER, SIZE, SLOPE, TIMED, M, Y, at, coefficient, rates
from tam570.integrate.error_scale import CALM, COARSE, NO_SCALE, PART
from tam570.values import Numbers

__all__ = ["LONG", "lacking", "sized"]

LONG, SHORT = 16.0, 1e-9  # times the first step of a series: how long the others are given at most and at least
STILL = 0.1  # times it, where nothing turns over


def lacking(z: Numbers, work: Numbers, lane: Numbers) -> Numbers:
    """Return whether something is zero, and so is its rate: its scale follows from others, one after the other."""
    is_found = False
    for i in range(SIZE):
        if z[at(M, i)] <= NO_SCALE and work[coefficient(i, 1, lane)] == 0.0:
            is_found = True
    return is_found


def sized(z: Numbers, work: Numbers, time: Numbers, c: Numbers, lane: Numbers, h: Numbers) -> Numbers:
    """Return whether all that lacks a size has one now, or no later time can give it one; in steps of about h."""
    for i in range(SIZE):
        z[at(BASE, i)] = work[coefficient(i, 1, lane)]
    duration, is_found = LONG * h, False
    while not is_found and duration > SHORT * h:
        is_found = spread(z, work, time, c, lane, duration)
        if is_found and duration == LONG * h:  # nothing turns over
            is_found = False
            duration = 2.0 * STILL * h
        duration /= 2.0
    every = is_found or not TIMED
    for i in range(SIZE):
        work[coefficient(i, 0, lane)] = z[at(Y, i)]
        work[coefficient(i, 1, lane)] = z[at(BASE, i)]
        if is_found and z[at(M, i)] <= NO_SCALE and z[at(BASE, i)] == 0.0:
            z[at(M, i)] = z[at(SLOPE, i)]
            every = every and (not TIMED or z[at(M, i)] > NO_SCALE or moves(work, i, lane))
    return every


def moves(work: Numbers, i: Numbers, lane: Numbers) -> Numbers:
    """Return whether one of the further coefficients of component i is not zero."""
    is_found = False
    for n in range(2, ORDER + 1):
        is_found = is_found or abs(work[coefficient(i, n, lane)]) > NO_SCALE
    return is_found


def spread(z: Numbers, work: Numbers, time: Numbers, c: Numbers, lane: Numbers, duration: Numbers) -> Numbers:
    """Return what the sizes do to one another within so many s, in the place of SLOPE.

    Whether none is turned over by that.
    """
    for i in range(SIZE):
        z[at(SLOPE, i)] = max(z[at(M, i)], abs(z[at(Y, i)]), duration * abs(z[at(BASE, i)]))
    more = SIZE + 1
    while more > 0:
        more -= 1
        changed(z, work, time, c, lane, PART)
        news = False
        for i in range(SIZE):
            size = duration / PART * abs(work[coefficient(i, 1, lane)] - z[at(BASE, i)])
            if z[at(SLOPE, i)] > NO_SCALE:
                if CALM * z[at(SLOPE, i)] < size < inf:
                    return False
            elif NO_SCALE < size < inf:
                z[at(SLOPE, i)] = size
                news = True
        if not news:
            more = 0
    changed(z, work, time, c, lane, COARSE)
    for i in range(SIZE):
        size = duration / COARSE * abs(work[coefficient(i, 1, lane)] - z[at(BASE, i)])
        if z[at(SLOPE, i)] > NO_SCALE and not size <= CALM * z[at(SLOPE, i)]:
            return False
    return True


def changed(z: Numbers, work: Numbers, time: Numbers, c: Numbers, lane: Numbers, part: Numbers) -> Numbers:
    """Return the rates where each component is changed by a part of its size."""
    sign = 1.0
    for i in range(SIZE):
        work[coefficient(i, 0, lane)] = z[at(Y, i)] + part * z[at(SLOPE, i)] * sign
        sign = -0.85 * sign if abs(sign) > 0.45 else (1.0 if sign < 0.0 else -1.0)  # no two cancel
    rates(work, c, time, ORDER)
    return 0
