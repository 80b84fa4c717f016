"""Hidden inputs of hw12: random beads and wires, and plain ones that tell what random ones do not."""

import math

import numpy as np

from tam570_grader import given, in_turn, uneven

ANY = "a random bead and wire"
NEXT_TO_BOTTOM = 1e-5  # times 1/c: whoever takes the wire for level there leaves a term out


def bead(draw, weight=1):
    """A call at a random state on a flat or a steep place; without gravity if the weight is zero."""
    curvature, gravity = 10 ** draw.uniform(-1, 1), draw.uniform(1, 25)
    x = 10 ** draw.uniform(-2, 0.6) / curvature * draw.choice([-1, 1])
    v = draw.uniform(0.4, 2) * math.sqrt(gravity / curvature) * draw.choice([-1, 1])
    known = {"mass": 10 ** draw.uniform(-1, 1), "curvature": curvature, "gravity": gravity * weight}
    return given(x, v, **known).on(_weighed(ANY, weight))


def usual(draw):
    """Random ones and whole numbers; nothing is zero, for a right formula may be 0/0 there."""
    whole = given(1.0, 1.0, mass=1.0, curvature=1.0, gravity=1.0).on(ANY)
    return [*(bead(draw) for _ in range(15)), whole, whole.but(-1.0), whole.but(1.0, -1.0)]


def beads(draw):
    """At rest, at the bottom, or both; random ones; all of them without gravity too."""
    calls = usual(draw)
    x, v = map(abs, calls[0].args)
    places = {
        "a bead at rest": [(x, 0.0), (-x, 0.0)],
        "a bead at the bottom": [(0.0, v), (0.0, -v)],
        "a bead at rest at the bottom": [(0.0, 0.0)],
    }
    placed = [calls[0].but(*state).on(kind) for kind, states in places.items() for state in states]
    return [*placed, *calls, *(one.but(gravity=0.0).on(_weighed(one.kind, 0)) for one in (*placed, *calls[:3]))]


def places(draw):
    """For the function of the place alone; on steep wires, too."""
    steep = bead(draw)
    far = steep.but(steep.args[0] * 1e3, steep.args[1])
    return [*beads(draw), *next_to_bottom(draw), far.on("a steep place"), far.but(-far.args[0]).on("a steep place")]


def next_to_bottom(draw):
    call = bead(draw)
    small = NEXT_TO_BOTTOM / call.kwargs["curvature"]
    return [one for x in (small, -small) for one in _with_and_without_gravity(call.but(x), "a bead next to the bottom")]


def nearly_at_rest(draw):
    """Next to the bottom, and as slow: the energy is tiny, and not zero."""
    call = bead(draw)
    x, v = NEXT_TO_BOTTOM / call.kwargs["curvature"], NEXT_TO_BOTTOM * call.args[1]
    return [call.but(x, v).on("a bead next to the bottom")]


def _with_and_without_gravity(call, kind):
    return [call.but(gravity=g).on(_weighed(kind, g)) for g in (call.kwargs["gravity"], 0.0)]


def _weighed(kind, gravity):
    return kind if gravity else f"{kind}, without gravity"


def ride(draw, low, high, count, turns, kind, start=None, decade=0.7):
    """A motion of an amplitude of low to high, in units of 1/c, for `turns` over the rate of small motions.

    start : the place, of the amplitude, and the speed, of the largest; random by default
    """
    wire = {"curvature": 10 ** draw.uniform(-decade, decade), "gravity": draw.uniform(1, 25)}
    size, rate = draw.uniform(low, high) / wire["curvature"], math.sqrt(2 * wire["gravity"] * wire["curvature"])
    if start is None:
        angle = draw.uniform(0.5, 1.2) * draw.choice([-1, 1])
        start = math.sin(angle), math.cos(angle) * draw.choice([-1, 1])
    x = size * start[0]
    v = size * rate * start[1] / math.hypot(1, 2 * wire["curvature"] * x)
    return given(uneven(draw, turns / rate, count), x, v, **wire).on(kind)


def rides(*settings):
    return lambda draw: [ride(draw, *settings)]


# The oscillation of small amplitudes is off by 2e-3; an absolute tolerance of 1e-9 m is good to 1e-6.
close = rides(0.02, 0.025, 2, 5.0, "two times, the bead let go at rest, close to the bottom", (1.0, 0.0), 0.3)


def few_times(draw):
    """Three times, most of the run and its sharp turns between two; two times, let go at rest and at the bottom."""
    sharp = ride(draw, 4.3, 5.0, 2, 21.0, "a few times, far apart")
    first, last = sharp.args[0]
    between = last - 1.5 / math.sqrt(2 * sharp.kwargs["gravity"] * sharp.kwargs["curvature"])
    starts = {
        "the bead let go at rest": [(1.0, 0.0), (-1.0, 0.0)],
        "the bead let go at the bottom": [(0.0, 1.0), (0.0, -1.0)],
        "a bead at rest at the bottom, where it stays": [(0.0, 0.0)],
    }
    plain = [(f"two times, {kind}", start) for kind, known in starts.items() for start in known]
    return [sharp.but(np.array([first, between, last])), *(ride(draw, 0.4, 1.0, 2, 5.0, *one) for one in plain)]


def weightless(draw):
    """The same with gravity and without: motions that are kept from call to call are wrong then."""
    case = ride(draw, 0.4, 1.0, 100, 6.0, "an amplitude near 1/c")
    return [case, case.but(gravity=0.0).on("gravity 0"), *in_turn(draw, case.but(case.args[0][:5]))]


def periods(kind, low, high, count, decades=(-1, 1)):
    """Amplitudes in units of 1/c, by their powers of ten; decades of the curvature."""

    def one(draw):
        curvature, size = 10 ** draw.uniform(*decades), 10 ** draw.uniform(low, high)
        return given(size / curvature, curvature=curvature, gravity=draw.uniform(1, 25)).on(kind)

    return lambda draw: [one(draw) for _ in range(count)]


usual_periods = periods("an amplitude near 1/c", -0.7, -0.2, 8)
tiny_periods = periods("an amplitude of a hundred-thousandth of 1/c", -5, -5, 2, (0.5, 1))
small_periods = periods("an amplitude of some thousandths of 1/c", -3, -2, 3)
large_periods = periods("an amplitude of many 1/c", 1, 2, 3)
largest_period = periods("an amplitude of many 1/c", 2, 2, 1)
