"""The loop over Taylor steps in Python, which `translate` turns into LLVM code: step size, test of each step, samples.

A step is the Taylor polynomial. It is tried first and tested afterwards: at its end the polynomial's derivative must
equal the right-hand side. That test needs only the first coefficients of the next step, and a coefficient that happens
to be zero cannot mislead it. Components that are zero and have no rate at the start get a scale as in `error_scale`.

The memory of one motion is `z`: NUMBERS scalars, then seven numbers per component, then the polynomial, order by order.
For a single motion the components are contiguous, as vectors padded with zeros up to PADDED. Several motions are
interleaved: each number is followed by that of the other LANES - 1. Vector code does what all motions do at every step,
loops over the lanes do the rest. The translator substitutes SIZE (components), ORDER (of the run), and ACROSS, ALONG
and LANES of `series.Layout`.
"""

from math import inf, log2

from tam570.integrate.compiled.series import HIGHEST
from tam570.integrate.error_scale import CALM, COARSE, NO_SCALE, PART, SHARE
from tam570.values import Numbers

NUMBERS = 16
_PLACES = "ROW T H NEW STATUS STEPS REFUSALS TRIES LONGEST SIZED WHO MAXIMUM FIRST ACCEPTED LIMIT"  # indices in z
PLACES = tuple(_PLACES.split(" "))
ROW, T, H, NEW, STATUS, STEPS, REFUSALS, TRIES, LONGEST, SIZED, WHO, MAXIMUM, FIRST, ACCEPTED, LIMIT = range(15)
Y, REST, M, SLOPE, NEXT, BASE, NOISE, POLYNOMIAL = range(8)
# of a component: Y at the end of the tried step, REST its compensation (Kahan) at the start, M its scale, SLOPE the
# polynomial's derivative at the end, NEXT the compensation there, BASE the rates at the start, NOISE a rounding bound

SIZE = PADDED = ORDER = ACROSS = ALONG = LANES = MEMORY = 0
TIMED = False  # whether the right-hand side depends on time
SATURATES = False  # whether it has exp, tanh or similar functions of the state
RUNNING, DONE, VANISHED, SINGULAR, LACKING, FRESH, IDLE = 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0
LEFT_OUT = 0.4  # allowed sum of the omitted terms, as a fraction of the tolerance
FINEST = 1e-14  # tolerance below which LEFT_OUT shrinks in proportion: omitted terms add up, rounding hardly
TOLERATED = 1.0  # allowed error of the derivative times the step, in units of (ORDER + 1) tolerances
ROUNDINGS = 8.0  # and in addition in units of its rounding bound, because the polynomial adds up as many terms
FARTHEST = 1e15  # s, longest step: beyond it high coefficients underflow
GROWTH = 6.0  # factor of the step size if the last coefficients are all zero
LONG, SHORT = 16.0, 1e-9  # longest and shortest duration for scales by coupling, in units of the first step
STILL = 0.1  # the duration if the coupling changes no other scale much, in the same units

# The arguments of the call, as arrays and numbers:
work: Numbers = None  # Taylor coefficients of the state
time: Numbers = None  # s, at the end of the tried step
times: Numbers = None  # s, of the samples, since `origin`
members: Numbers = None  # of several motions, a row for each: 1 if it has scales, later its final status; start; scales
origin: Numbers = None  # s
rtol: Numbers = None

# Functions that the translator writes:
coefficients: Numbers = None  # coefficients() writes those of the state in `work`, from its state and `time`
rates: Numbers = None  # rates() writes only those of order 1
reach: Numbers = None  # the same, but the first is the longest step for exponents
roundoff: Numbers = None  # the same, but writes bounds of their rounding errors
logarithm: Numbers = None  # log2 to a tenth, which suffices because the step is a root of its argument
power_of_2: Numbers = None  # 2**x to a hundredth
shifted: Numbers = None  # shifted(array, k) is array[k:]
components: Numbers = None  # components() iterates over the indices; for a single motion, vector by vector
each: Numbers = None  # each(k) is the index of number k of all motions
wide: Numbers = None  # wide(x) is x in all lanes
largest: Numbers = None  # largest(x) is the maximum over the components in a vector
summed: Numbers = None  # summed(x) is the sum over the components in a vector
largest_of_all: Numbers = None  # largest_of_all(x) is the maximum over the motions


def memory(size: int) -> int:
    """Return the number of doubles in z."""
    return NUMBERS + size * (POLYNOMIAL + HIGHEST + 1)


def at(part: Numbers, i: Numbers) -> Numbers:
    """Return the index in z of a part of component i; POLYNOMIAL + n is its coefficient of order n."""
    return (NUMBERS + part * PADDED + i) * LANES


def coefficient(i: Numbers, n: Numbers, lane: Numbers) -> Numbers:
    """Return the index in `work` of the coefficient of order n of component i."""
    return i * ACROSS + n * ALONG + lane


def lacking(z: Numbers, lane: Numbers) -> Numbers:
    """Return whether some component has no scale and no rate, so that its scale must follow from other components."""
    is_found = False
    for i in range(SIZE):
        if z[at(M, i)] <= NO_SCALE and work[coefficient(i, 1, lane)] == 0.0:
            is_found = True
    return is_found


def sized(z: Numbers, lane: Numbers, h: Numbers) -> Numbers:
    """Give a scale to components without scale and rate; return whether all have one, or time cannot give them one.

    h : s, estimate of the first step
    """
    for i in range(SIZE):
        z[at(BASE, i)] = work[coefficient(i, 1, lane)]
    duration, is_found = LONG * h, False
    while not is_found and duration > SHORT * h:
        is_found = spread(z, lane, duration)
        if is_found and duration == LONG * h:  # the coupling is weak: use a short duration
            is_found = False
            duration = 2.0 * STILL * h
        duration /= 2.0
    every = is_found or not TIMED
    for i in range(SIZE):
        work[coefficient(i, 0, lane)] = z[at(Y, i)]
        work[coefficient(i, 1, lane)] = z[at(BASE, i)]
        if is_found and z[at(M, i)] <= NO_SCALE and z[at(BASE, i)] == 0.0:
            z[at(M, i)] = z[at(SLOPE, i)]
            every = every and (not TIMED or z[at(M, i)] > NO_SCALE or moves(i, lane))
    return every


def moves(i: Numbers, lane: Numbers) -> Numbers:
    """Return whether any coefficient of component i beyond order 1 is nonzero."""
    is_found = False
    for n in range(2, ORDER + 1):
        is_found = is_found or abs(work[coefficient(i, n, lane)]) > NO_SCALE
    return is_found


def spread(z: Numbers, lane: Numbers, duration: Numbers) -> Numbers:
    """Estimate scales in SLOPE by how components change each other's rates within `duration`, s.

    Return whether the estimate is consistent: no component that has a scale changes by much more than it.
    """
    for i in range(SIZE):
        z[at(SLOPE, i)] = max(z[at(M, i)], abs(z[at(Y, i)]), duration * abs(z[at(BASE, i)]))
    more = SIZE + 1
    while more > 0:
        more -= 1
        changed(z, lane, PART)
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
    changed(z, lane, COARSE)
    for i in range(SIZE):
        size = duration / COARSE * abs(work[coefficient(i, 1, lane)] - z[at(BASE, i)])
        if z[at(SLOPE, i)] > NO_SCALE and not size <= CALM * z[at(SLOPE, i)]:
            return False
    return True


def changed(z: Numbers, lane: Numbers, part: Numbers) -> None:
    """Compute the rates with each component changed by a fraction `part` of its scale."""
    sign = 1.0
    for i in range(SIZE):
        work[coefficient(i, 0, lane)] = z[at(Y, i)] + part * z[at(SLOPE, i)] * sign
        sign = -0.85 * sign if abs(sign) > 0.45 else (1.0 if sign < 0.0 else -1.0)  # unequal, so that no two cancel
    rates()


def advance(z: Numbers, out: Numbers, budget: Numbers) -> None:
    """Step until the last sample, until `budget` steps were tried, or until no step is possible: see z[STATUS]."""
    pace = pace_of()
    if z[STATUS] == FRESH:
        start_motion(z, out)
    for i in components():
        work[coefficient(i, 0, 0)] = z[at(Y, i)]
    while z[STATUS] == RUNNING and budget > 0:
        budget -= 1
        time[0] = origin + z[NEW]
        if z[NEW] == times[len(times) - 1]:
            rates()
        else:
            coefficients()
        settle(z, out, pace)


def pace_of() -> Numbers:
    """Return log2 of the ratio of step to radius of convergence, and the reciprocals of the last four orders.

    Successive terms of the series shrink by q = step / radius, so the omitted terms sum to q / (1 - q) of the last one.
    That sum should be LEFT_OUT times the tolerance. q follows from the last term alone, to a hundredth.
    """
    q = power_of_2(log2(rtol) / ORDER)
    last = log2(rtol * min(1.0, rtol / FINEST) * LEFT_OUT * (1.0 - q) / q) / ORDER
    return last, 1.0 / ORDER, 1.0 / (ORDER - 1), 1.0 / (ORDER - 2), 1.0 / (ORDER - 3)


def start_motion(z: Numbers, out: Numbers) -> None:
    """Write the first row and, if there are none, the scales; z[STATUS] is SINGULAR if the start is not finite."""
    z[STATUS] = RUNNING
    for i in range(SIZE):
        out[0, i] = z[at(Y, i)]
        if z[SIZED] == 0.0:
            z[at(M, i)] = abs(z[at(Y, i)])
        if not abs(z[at(Y, i)]) < inf:
            z[STATUS] = SINGULAR


def advance_all(z: Numbers, out: Numbers, budget: Numbers) -> None:
    """Like `advance` for many motions, LANES at a time; a finished motion makes room for the next.

    The memory after all z contains the number of motions begun and the number of unfinished ones.
    """
    pace = pace_of()
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
                    begin(motion, shifted(out, who * len(times) * SIZE), who, lane)
                    z[next_member] += 1.0
                    is_new = True
            time[lane] = origin + motion[NEW]
        coefficients()
        limit = wide(inf)
        if SATURATES:
            reach()
            limit = work[coefficient(each(0), 1, 0)]
            rates()
        mark_accepted(z, refused(z), limit)
        for lane in range(LANES):
            motion = shifted(z, lane)
            if motion[ACCEPTED] > 0.0:
                sample(motion, shifted(out, int(motion[WHO]) * len(times) * SIZE))
        take_steps(z)
        z[each(LIMIT)] = longest(z, pace)
        if is_new:
            for lane in range(LANES):
                motion = shifted(z, lane)
                if motion[H] == 0.0 and motion[STATUS] == RUNNING:
                    scale_start(motion, lane, motion[LIMIT])
            z[each(LIMIT)] = longest(z, pace)
        attempt_all(z, limit)


def begin(z: Numbers, out: Numbers, who: Numbers, lane: Numbers) -> None:
    """Initialize a lane with the start of a member."""
    for k in range(NUMBERS + 7 * SIZE):
        z[k * LANES] = 0.0
    z[ROW] = 1.0
    z[WHO] = float(who)
    z[SIZED] = members[who, 0]
    z[MAXIMUM] = z[FIRST] = inf
    z[LONGEST] = times[len(times) - 1] / 100.0
    for i in range(SIZE):
        z[at(Y, i)] = members[who, 1 + i]
        z[at(M, i)] = members[who, 1 + SIZE + i]
        work[coefficient(i, 0, lane)] = z[at(Y, i)]
    start_motion(z, out)


def mark_accepted(z: Numbers, wrong: Numbers, limit: Numbers) -> None:
    """Set ACCEPTED of each motion to 1 if it accepts the step that it tried, else to 0."""
    h = z[each(H)]
    accepted = wide(1.0) if h > 0.0 else wide(0.0)
    accepted = accepted if z[each(STATUS)] == RUNNING else wide(0.0)
    accepted = wide(0.0) if wrong > 0.0 else accepted
    z[each(ACCEPTED)] = wide(0.0) if h > 2.0 * limit else accepted


def take_steps(z: Numbers) -> None:
    """Advance the motions that accepted their steps; count the refusals of the others."""
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


def attempt_all(z: Numbers, limit: Numbers) -> None:
    """Choose and try the next step of each motion."""
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
    extrapolate(z, h)


def settle(z: Numbers, out: Numbers, pace: Numbers) -> None:
    """Accept or refuse the tried step, then try the next; `work` contains the coefficients at the state in z."""
    limit = inf
    if SATURATES:
        reach()
        limit = work[coefficient(0, 1, 0)]
        rates()
    h = 0.0
    if z[H] > 0.0 and (z[H] > 2.0 * limit or refused(z) > 0.0):
        z[REFUSALS] += 1.0
        z[TRIES] += 1.0
        h = z[H] / 2.0 if z[TRIES] < 3.0 else z[H] / 8.0
    else:
        if z[H] > 0.0:
            take_step(z, out)
        if z[STATUS] == RUNNING:
            h = longest(z, pace)
            if z[STEPS] == 0.0:
                scale_start(z, 0, h)
                h = longest(z, pace)
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
        attempt(z, h)


def scale_start(z: Numbers, lane: Numbers, h: Numbers) -> None:
    """Give a scale to components that have none; h, s, estimates the first step. z[STATUS] is LACKING if that fails."""
    if z[SIZED] != 1.0 and lacking(z, lane) and not sized(z, lane, h if h < inf else z[LONGEST]):
        z[STATUS] = LACKING
    elif h < inf:
        for i in range(SIZE):  # a component that is small but changes fast
            if z[SIZED] == 0.0 or (z[SIZED] == 2.0 and z[at(M, i)] <= NO_SCALE):
                z[at(M, i)] = max(z[at(M, i)], h * abs(work[coefficient(i, 1, lane)]))


def refused(z: Numbers) -> Numbers:
    """Return 1 if the polynomial's derivative at the end differs from the rates by more than tolerance and rounding."""
    limit = TOLERATED * (ORDER + 1) * max(rtol, 2.0**-52)
    wrong = off(z, limit, 0.0)
    if largest_of_all(wrong) > 0.0:
        roundoff()
        for i in components():
            z[at(NOISE, i)] = work[coefficient(i, 1, 0)]
        rates()
        wrong = off(z, limit, ROUNDINGS)
    return wrong


def off(z: Numbers, limit: Numbers, roundings: Numbers) -> Numbers:
    """Return 1 if the error of any derivative times the step is NaN or larger than the limit plus rounding bounds."""
    h = z[each(H)]
    wrong = wide(0.0)
    for i in components():
        slope = z[at(SLOPE, i)]
        size = SHARE * z[at(M, i)] + max(abs(z[at(POLYNOMIAL, i)]), abs(z[at(Y, i)]))
        noise = roundings * z[at(NOISE, i)] if roundings > 0.0 else wide(0.0)
        allowed = limit * size + h * ((noise if noise < inf else wide(0.0)) + 2.0**-51 * abs(slope))
        wrong = wrong if h * abs(work[coefficient(i, 1, 0)] - slope) <= allowed else wide(1.0)
    return largest(wrong)


def sample(z: Numbers, out: Numbers) -> None:
    """Write the samples within the accepted step."""
    row = int(z[ROW])
    while row < len(times) and times[row] <= z[NEW]:
        x = times[row] - z[T]
        for i in range(SIZE):
            out[row, i] = z[at(Y, i)] if times[row] == z[NEW] else evaluate(z, i, x)
        row += 1
    z[ROW] = float(row)
    if row >= len(times):
        z[STATUS] = DONE


def take_step(z: Numbers, out: Numbers) -> None:
    """Advance by the accepted step: write its samples and scales of components that had none."""
    sample(z, out)
    for i in components():
        if z[SIZED] != 1.0:  # a component without scale gets its size after the accepted step
            z[at(M, i)] = abs(z[at(Y, i)]) if z[at(M, i)] <= NO_SCALE else z[at(M, i)]
        z[at(REST, i)] = z[at(NEXT, i)]
    z[T] = z[NEW]
    z[LONGEST] = z[H]
    z[STEPS] += 1.0
    z[TRIES] = 0.0


def evaluate(z: Numbers, i: Numbers, x: Numbers) -> Numbers:
    """Return component i at x, s after the start of the step."""
    value = 0.0
    for n in range(ORDER):
        value = value * x + z[at(POLYNOMIAL + ORDER - n, i)]
    return z[at(POLYNOMIAL, i)] + (z[at(REST, i)] + value * x)


def longest(z: Numbers, pace: Numbers) -> Numbers:
    """Return the step size by the last four coefficients of all components; pace : from `pace_of`.

    Return inf if all of them are zero, 0 if one is not finite.
    """
    nearest = wide(-inf)
    total = wide(0.0)
    for i in components():
        size = SHARE * z[at(M, i)] + abs(z[at(Y, i)])
        first = abs(work[coefficient(i, 1, 0)])  # the scale of a component that has none
        scale = 1.0 / size if size > NO_SCALE else (1.0 / first if first > NO_SCALE else wide(0.0))
        for before in (0, 1, 2, 3):
            part = abs(work[coefficient(i, ORDER - before, 0)]) * scale
            total = total + part
            nearest = max(nearest, logarithm(part) * pace[1 + before])
    parts = summed(total)
    h = power_of_2(pace[0] - largest(nearest))
    h = h if parts > 0.0 else inf
    return h if parts < inf else 0.0


def attempt(z: Numbers, h: Numbers) -> None:
    """Try a step of h, shortened to end at the last time."""
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
    extrapolate(z, h)


def extrapolate(z: Numbers, h: Numbers) -> None:
    """Evaluate the polynomial and its derivative at the end of a step of h, with a compensated sum."""
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
