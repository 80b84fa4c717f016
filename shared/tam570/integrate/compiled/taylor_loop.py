"""The loop over Taylor steps, as Python that is translated: step size, the test of each step, samples.

A step is the polynomial itself. It is tried first and judged afterwards: at its end the right-hand side must be the
polynomial's derivative. That test needs nothing but the next step's first coefficients, and no coefficient that
happens to be zero deceives it. What is zero at the start, and has a rate of zero, takes the size that the others give
it, as in `error_scale`.

The memory of one motion is `z`: NUMBERS first, then seven numbers a component, then the polynomial, order by order. One
motion alone has its components side by side, in vectors, with zeros up to PADDED. Several motions have each number side
by side, LANES of them: a vector serves what all do at every step, a loop over the lanes what few do. Names put in place
for one right-hand side: SIZE components, ORDER of the run, ACROSS, ALONG and LANES of `series.Layout`.
"""

from math import inf, log2

from tam570.integrate.compiled.series import HIGHEST
from tam570.integrate.error_scale import CALM, COARSE, NO_SCALE, PART, SHARE
from tam570.values import Numbers

NUMBERS = 16
_PLACES = "ROW T H NEW STATUS STEPS REFUSALS TRIES LONGEST SIZED WHO MAXIMUM FIRST ACCEPTED LIMIT"  # in z
PLACES = tuple(_PLACES.split(" "))
ROW, T, H, NEW, STATUS, STEPS, REFUSALS, TRIES, LONGEST, SIZED, WHO, MAXIMUM, FIRST, ACCEPTED, LIMIT = range(15)
Y, REST, M, SLOPE, NEXT, BASE, NOISE, POLYNOMIAL = range(8)
# of a component: at the end of the step tried; what rounding took from its start; its size at the start; the
# polynomial's derivative at the end; what rounding takes from the end; the derivative there; what a rounding does to it

SIZE = PADDED = ORDER = ACROSS = ALONG = LANES = MEMORY = 0
TIMED = False  # whether the right-hand side depends on time
SATURATES = False  # whether it has exp, tanh or their like of the state
RUNNING, DONE, VANISHED, SINGULAR, LACKING, FRESH, IDLE = 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0
LEFT_OUT = 0.4  # of the tolerance, by the terms that a step leaves out
FINEST = 1e-14  # tolerance of a step, below which they fall as its square: in long runs they add up, rounding does not
TOLERATED = 1.0  # the derivative may be off by so many times (ORDER + 1) of the tolerance in a step
ROUNDINGS = 8.0  # and by so many times the bound of its rounding: the polynomial adds up as many terms
FARTHEST = 1e15  # s, of a step: beyond that high coefficients are less than the least number
GROWTH = 6.0  # of the step where all coefficients in the window are zero
LONG, SHORT = 16.0, 1e-9  # times the first step of a series: how long the others are given at most and at least
STILL = 0.1  # times it, where nothing turns over

coefficients: Numbers = None
logarithm: Numbers = None  # to base 2, to a tenth: a root of it is wanted
power_of_2: Numbers = None  # to a hundredth
shifted: Numbers = None  # behind(array, k): from its k-th number on
rates: Numbers = None  # rates(work, c, time, ORDER): the coefficients of order 1
reach: Numbers = None  # the same: in the place of the first, the longest step for what saturates
roundoff: Numbers = None  # the same: in their place, a bound of their rounding


components: Numbers = None  # components(): their indices; of one motion alone as many at a time as fit in a vector
each: Numbers = None  # each(k): the index of number k of all motions
wide: Numbers = None  # wide(x): as many of it
largest: Numbers = None  # largest(x): of the components in a vector
summed: Numbers = None  # summed(x): of the components in a vector
largest_of_all: Numbers = None  # largest_of_all(x): of the motions


def memory(size: int) -> int:
    """Doubles in z."""
    return NUMBERS + size * (POLYNOMIAL + HIGHEST + 1)


def at(part: Numbers, i: Numbers) -> Numbers:
    """Return where in z that part of component i is, or the first coefficient of its polynomial."""
    return (NUMBERS + part * PADDED + i) * LANES


def coefficient(i: Numbers, n: Numbers, lane: Numbers) -> Numbers:
    """Return where in `work` the coefficient of order n of component i is."""
    return i * ACROSS + n * ALONG + lane


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
    """Write what the sizes do to one another within so many s, in place of SLOPE; return whether none turns over."""
    for i in range(SIZE):
        z[at(SLOPE, i)] = max(z[at(M, i)], abs(z[at(Y, i)]), duration * abs(z[at(BASE, i)]))
    more = SIZE + 1
    while more > 0:
        more -= 1
        changed(z, work, time, c, lane, PART)
        news = False
        for i in range(SIZE):
            size = duration / PART * abs(work[coefficient(i, 1, lane)] - z[at(BASE, i)])
            if max(CALM * z[at(SLOPE, i)], NO_SCALE) < size < inf:
                if max(z[at(M, i)], abs(z[at(Y, i)]), duration * abs(z[at(BASE, i)])) > NO_SCALE:
                    return False
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


def changed(z: Numbers, work: Numbers, time: Numbers, c: Numbers, lane: Numbers, part: Numbers) -> None:
    """Write the rates where each component is changed by a part of its size."""
    sign = 1.0
    for i in range(SIZE):
        work[coefficient(i, 0, lane)] = z[at(Y, i)] + part * z[at(SLOPE, i)] * sign
        sign = -0.85 * sign if abs(sign) > 0.45 else (1.0 if sign < 0.0 else -1.0)  # no two cancel
    rates(work, c, time, ORDER)


def advance(
    z: Numbers,
    work: Numbers,
    time: Numbers,
    c: Numbers,
    times: Numbers,
    out: Numbers,
    origin: Numbers,
    rtol: Numbers,
    budget: Numbers,
) -> None:
    """Step until the last sample, `budget` steps are tried, or no step is possible: z[STATUS] tells."""
    pace = pace_of(rtol)
    if z[STATUS] == FRESH:
        start_motion(z, out)
    for i in components():
        work[coefficient(i, 0, 0)] = z[at(Y, i)]
    while z[STATUS] == RUNNING and budget > 0:
        budget -= 1
        time[0] = origin + z[NEW]
        if z[NEW] == times[len(times) - 1]:
            rates(work, c, time, ORDER)
        else:
            coefficients(work, c, time, ORDER)
        settle(z, work, time, c, times, out, rtol, pace)


def pace_of(rtol: Numbers) -> Numbers:
    """Return log2 of the step over the distance to the singularity, and 1 over each of the last orders.

    The terms of a series fall by q = step / distance each: those left out sum to q / (1 - q) of the last, and are to be
    LEFT_OUT times the tolerance. q follows from the last term alone, to a hundredth.
    """
    q = power_of_2(log2(rtol) / ORDER)
    last = log2(rtol * min(1.0, rtol / FINEST) * LEFT_OUT * (1.0 - q) / q) / ORDER
    return last, 1.0 / ORDER, 1.0 / (ORDER - 1), 1.0 / (ORDER - 2), 1.0 / (ORDER - 3)


def start_motion(z: Numbers, out: Numbers) -> None:
    """Write the first row, and the magnitudes of a start that nobody has looked at."""
    z[STATUS] = RUNNING
    for i in range(SIZE):
        out[0, i] = z[at(Y, i)]
        if z[SIZED] == 0.0:
            z[at(M, i)] = abs(z[at(Y, i)])
        if not abs(z[at(Y, i)]) < inf:
            z[STATUS] = SINGULAR


def advance_all(
    z: Numbers,
    work: Numbers,
    time: Numbers,
    c: Numbers,
    times: Numbers,
    out: Numbers,
    members: Numbers,
    origin: Numbers,
    rtol: Numbers,
    budget: Numbers,
) -> None:
    """Step the same way for many motions, as many at a time as there are lanes.

    members : a row each: its status as it ends, and its start
    Memory behind all z: how many motions were begun, and how many have not ended.
    """
    pace = pace_of(rtol)
    next_member, running = LANES * MEMORY, LANES * MEMORY + 1
    while z[running] > 0.0 and budget > 0:
        budget -= 1
        is_new = False
        for lane in range(LANES):
            motion = shifted(z, lane)
            if motion[STATUS] != RUNNING:
                if motion[STATUS] != IDLE:
                    members[int(motion[WHO]), 0] = motion[STATUS]
                    motion[STATUS] = IDLE
                    z[running] -= 1.0
                if int(z[next_member]) < len(members):
                    who = int(z[next_member])
                    begin(motion, work, times, shifted(out, who * len(times) * SIZE), members, who, lane)
                    z[next_member] += 1.0
                    is_new = True
            time[lane] = origin + motion[NEW]
        coefficients(work, c, time, ORDER)
        limit = wide(inf)
        if SATURATES:
            reach(work, c, time, ORDER)
            limit = work[coefficient(each(0), 1, 0)]
            rates(work, c, time, ORDER)
        mark_accepted(z, refused(z, work, time, c, rtol), limit)
        for lane in range(LANES):
            motion = shifted(z, lane)
            if motion[ACCEPTED] > 0.0:
                sample(motion, times, shifted(out, int(motion[WHO]) * len(times) * SIZE))
        take_steps(z)
        z[each(LIMIT)] = longest(z, work, pace)
        if is_new:
            for lane in range(LANES):
                motion = shifted(z, lane)
                if motion[H] == 0.0 and motion[STATUS] == RUNNING:
                    scale_start(motion, work, time, c, lane, motion[LIMIT])
            z[each(LIMIT)] = longest(z, work, pace)
        attempt_all(z, work, times, limit)


def begin(
    z: Numbers, work: Numbers, times: Numbers, out: Numbers, members: Numbers, who: Numbers, lane: Numbers
) -> None:
    """Put a member's start where it belongs."""
    for k in range(NUMBERS + 7 * SIZE):
        z[k * LANES] = 0.0
    z[ROW] = 1.0
    z[WHO] = float(who)
    z[MAXIMUM] = z[FIRST] = inf
    z[LONGEST] = times[len(times) - 1] / 100.0
    for i in range(SIZE):
        z[at(Y, i)] = members[who, 1 + i]
        work[coefficient(i, 0, lane)] = z[at(Y, i)]
    start_motion(z, out)


def mark_accepted(z: Numbers, wrong: Numbers, limit: Numbers) -> None:
    """Note which of all motions accept the step that they tried."""
    h = z[each(H)]
    accepted = wide(1.0) if h > 0.0 else wide(0.0)
    accepted = accepted if z[each(STATUS)] == RUNNING else wide(0.0)
    accepted = wide(0.0) if wrong > 0.0 else accepted
    z[each(ACCEPTED)] = wide(0.0) if h > 2.0 * limit else accepted


def take_steps(z: Numbers) -> None:
    """Take the steps of all motions that accept theirs; count the refusals of the others."""
    accepted, h = z[each(ACCEPTED)], z[each(H)]
    for i in components():
        m = z[at(M, i)]
        unsized = wide(1.0) if m <= NO_SCALE else wide(0.0)
        unsized = wide(0.0) if z[each(SIZED)] == 1.0 else unsized
        z[at(M, i)] = abs(z[at(Y, i)]) if accepted * unsized > 0.0 else m
        z[at(REST, i)] = z[at(NEXT, i)] if accepted > 0.0 else z[at(REST, i)]
    z[each(T)] = z[each(NEW)] if accepted > 0.0 else z[each(T)]
    z[each(LONGEST)] = h if accepted > 0.0 else z[each(LONGEST)]
    z[each(STEPS)] = z[each(STEPS)] + accepted
    refusals = wide(1.0) - accepted if h > 0.0 else wide(0.0)
    z[each(REFUSALS)] = z[each(REFUSALS)] + refusals
    z[each(TRIES)] = (z[each(TRIES)] + 1.0) * refusals


def attempt_all(z: Numbers, work: Numbers, times: Numbers, limit: Numbers) -> None:
    """Try the next steps of all motions."""
    tries = z[each(TRIES)]
    h = z[each(LIMIT)]
    h = h if h < inf else GROWTH * z[each(LONGEST)]
    h = min(h, limit)
    shorter = z[each(H)] * (wide(0.5) if tries < 3.0 else wide(0.125))
    h = shorter if tries > 0.0 else h
    h = h if h <= FARTHEST else wide(0.0)
    status = wide(RUNNING) if h > 0.0 else wide(SINGULAR)
    t = z[each(T)]
    end = times[len(times) - 1]
    remaining = end - t
    new = t + (h if 2.0 * h < remaining else remaining / 2.0)
    new = new if h < remaining else wide(end)
    h = new - t
    vanishing = wide(VANISHED) if h <= 2.0**-50 * t else status
    vanishing = wide(VANISHED) if h < 1e-17 * end else vanishing
    status = vanishing if status == RUNNING else status
    before = z[each(STATUS)]
    z[each(STATUS)] = status if before == RUNNING else before
    z[each(H)] = h
    z[each(NEW)] = new
    for i in components():
        for n in range(ORDER + 1):
            was = z[at(POLYNOMIAL + n, i)]
            z[at(POLYNOMIAL + n, i)] = was if tries > 0.0 else work[coefficient(i, n, 0)]
    extrapolate(z, work, h)


def settle(
    z: Numbers, work: Numbers, time: Numbers, c: Numbers, times: Numbers, out: Numbers, rtol: Numbers, pace: Numbers
) -> None:
    """Judge the step that was tried, and try the next: `work` holds the coefficients at the state in z."""
    limit = inf
    if SATURATES:
        reach(work, c, time, ORDER)
        limit = work[coefficient(0, 1, 0)]
        rates(work, c, time, ORDER)
    h = 0.0
    if z[H] > 0.0 and (z[H] > 2.0 * limit or refused(z, work, time, c, rtol) > 0.0):
        z[REFUSALS] += 1.0
        z[TRIES] += 1.0
        h = z[H] / 2.0 if z[TRIES] < 3.0 else z[H] / 8.0
    else:
        if z[H] > 0.0:
            take_step(z, times, out)
        if z[STATUS] == RUNNING:
            h = longest(z, work, pace)
            if z[STEPS] == 0.0:
                scale_start(z, work, time, c, 0, h)
                h = longest(z, work, pace)
            if not h < inf:
                h = GROWTH * z[LONGEST]
            if z[STEPS] == 0.0:
                h = min(h, z[FIRST])
            h = min(h, z[MAXIMUM])
            h = min(h, limit)
            for n in range(ORDER + 1):
                for i in components():
                    z[at(POLYNOMIAL + n, i)] = work[coefficient(i, n, 0)]
            if not 0.0 < h <= FARTHEST:
                z[STATUS] = SINGULAR
    if z[STATUS] == RUNNING:
        attempt(z, work, times, h)


def scale_start(z: Numbers, work: Numbers, time: Numbers, c: Numbers, lane: Numbers, h: Numbers) -> None:
    """Give a size to what has none at the start, in a first step of about h; z[STATUS] tells where none follows."""
    if z[SIZED] != 1.0 and lacking(z, work, lane) and not sized(z, work, time, c, lane, h if h < inf else z[LONGEST]):
        z[STATUS] = LACKING
    elif h < inf:
        for i in range(SIZE):  # what is small yet and moves fast
            if z[SIZED] == 0.0 or (z[SIZED] == 2.0 and z[at(M, i)] <= NO_SCALE):
                z[at(M, i)] = max(z[at(M, i)], h * abs(work[coefficient(i, 1, lane)]))


def refused(z: Numbers, work: Numbers, time: Numbers, c: Numbers, rtol: Numbers) -> Numbers:
    """Return 1 where the derivative at the end of the step is not the polynomial's; what is but rounding passes."""
    limit = TOLERATED * (ORDER + 1) * max(rtol, 2.0**-52)
    wrong = off(z, work, limit, 0.0)
    if largest_of_all(wrong) > 0.0:
        roundoff(work, c, time, ORDER)
        for i in components():
            z[at(NOISE, i)] = work[coefficient(i, 1, 0)]
        rates(work, c, time, ORDER)
        wrong = off(z, work, limit, ROUNDINGS)
    return wrong


def off(z: Numbers, work: Numbers, limit: Numbers, roundings: Numbers) -> Numbers:
    """Return 1 where an error of a derivative times the step is more than is allowed, or not a number."""
    h = z[each(H)]
    wrong = wide(0.0)
    for i in components():
        slope = z[at(SLOPE, i)]
        size = SHARE * z[at(M, i)] + max(abs(z[at(POLYNOMIAL, i)]), abs(z[at(Y, i)]))
        noise = roundings * z[at(NOISE, i)] if roundings > 0.0 else wide(0.0)
        allowed = limit * size + h * ((noise if noise < inf else wide(0.0)) + 2.0**-51 * abs(slope))
        wrong = wrong if h * abs(work[coefficient(i, 1, 0)] - slope) <= allowed else wide(1.0)
    return largest(wrong)


def sample(z: Numbers, times: Numbers, out: Numbers) -> None:
    """Write the samples in the step, which proved right."""
    row = int(z[ROW])
    while row < len(times) and times[row] <= z[NEW]:
        x = times[row] - z[T]
        for i in range(SIZE):
            out[row, i] = z[at(Y, i)] if times[row] == z[NEW] else evaluate(z, i, x)
        row += 1
    z[ROW] = float(row)
    if row >= len(times):
        z[STATUS] = DONE


def take_step(z: Numbers, times: Numbers, out: Numbers) -> None:
    """Write the samples in the step; what had no scale has one now."""
    sample(z, times, out)
    for i in components():
        if z[SIZED] != 1.0:  # what has no size yet moves: by as much within a step that proved right
            z[at(M, i)] = abs(z[at(Y, i)]) if z[at(M, i)] <= NO_SCALE else z[at(M, i)]
        z[at(REST, i)] = z[at(NEXT, i)]
    z[T] = z[NEW]
    z[LONGEST] = z[H]
    z[STEPS] += 1.0
    z[TRIES] = 0.0


def evaluate(z: Numbers, i: Numbers, x: Numbers) -> Numbers:
    """Component i at x, s after the start of the step."""
    value = 0.0
    for n in range(ORDER):
        value = value * x + z[at(POLYNOMIAL + ORDER - n, i)]
    return z[at(POLYNOMIAL, i)] + (z[at(REST, i)] + value * x)


def longest(z: Numbers, work: Numbers, pace: Numbers) -> Numbers:
    """Return the step from the last coefficients, the whole state together.

    Infinite where all are zero, 0 if none will do.

    pace : as by `pace_of`
    """
    nearest = wide(-inf)
    total = wide(0.0)
    for i in components():
        size = SHARE * z[at(M, i)] + abs(z[at(Y, i)])
        first = abs(work[coefficient(i, 1, 0)])  # where it has no size it is its scale
        scale = 1.0 / size if size > NO_SCALE else (1.0 / first if first > NO_SCALE else wide(0.0))
        for before in (0, 1, 2, 3):
            part = abs(work[coefficient(i, ORDER - before, 0)]) * scale
            total = total + part
            nearest = max(nearest, logarithm(part) * pace[1 + before])
    parts = summed(total)
    h = power_of_2(pace[0] - largest(nearest))
    h = h if parts > 0.0 else inf
    return h if parts < inf else 0.0


def attempt(z: Numbers, work: Numbers, times: Numbers, h: Numbers) -> None:
    """Try a step of about h."""
    t = z[T]
    end = times[len(times) - 1]
    remaining = end - t
    new = end
    if h < remaining:
        new = t + (h if 2.0 * h < remaining else remaining / 2.0)
    h = new - t
    if h <= 2.0**-50 * t or h < 1e-17 * end:
        z[STATUS] = VANISHED
        for i in components():
            z[at(Y, i)] = z[at(POLYNOMIAL, i)]
        return
    z[H] = h
    z[NEW] = new
    extrapolate(z, work, h)


def extrapolate(z: Numbers, work: Numbers, h: Numbers) -> None:
    """Write the state and the polynomial's derivative at the end of a step of h."""
    for i in components():
        value = wide(0.0)
        slope = wide(0.0)
        for n in range(ORDER):
            slope = slope * h + value
            value = value * h + z[at(POLYNOMIAL + ORDER - n, i)]
        slope = slope * h + value
        z[at(SLOPE, i)] = slope
        y = z[at(POLYNOMIAL, i)]
        change = value * h + z[at(REST, i)]
        total = y + change
        part = total - y
        z[at(Y, i)] = total
        work[coefficient(i, 0, 0)] = total
        z[at(NEXT, i)] = (y - (total - part)) + (change - part)
