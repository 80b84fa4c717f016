"""Hidden inputs of hw12: random beads and wires, and plain ones that tell what random ones do not."""

import math

import numpy as np

from tam570_grader import given, in_turn, uneven

ANY = "a random bead and wire"
NEXT_TO_BOTTOM = 1e-5  # times 1/c: whoever takes the wire for level there leaves a term out
SYMBOLS = {"mass": "m", "curvature": "c", "gravity": "g"}


def beads(draw):
    """Calls at random states on flat and on steep places, some without gravity."""
    calls = []
    for weight in [1] * 15 + [0] * 3:
        curvature, gravity = 10 ** draw.uniform(-1, 1), draw.uniform(1, 25)
        x = 10 ** draw.uniform(-2, 0.6) / curvature * draw.choice([-1, 1])
        v = draw.uniform(0.4, 2) * math.sqrt(gravity / curvature) * draw.choice([-1, 1])
        bead = {"mass": 10 ** draw.uniform(-1, 1), "curvature": curvature, "gravity": gravity * weight}
        calls.append(given(x, v, **bead).on(_weighed(ANY, bead["gravity"])))
    return calls + _plain(calls[0])


def _plain(call):
    """This x or v, the other zero, or both zero, without gravity too; and whole numbers."""
    x, v = map(abs, call.args)
    places = {
        "a bead at the bottom": [(0.0, v), (0.0, -v)],
        "a bead at rest": [(x, 0.0), (-x, 0.0)],
        "a bead at rest at the bottom": [(0.0, 0.0)],
    }
    whole = {"mass": 1.0, "curvature": 1.0, "gravity": 1.0}
    return [
        *(
            call.but(*state, gravity=g).on(_weighed(kind, g))
            for kind, states in places.items()
            for state in states
            for g in (call.kwargs["gravity"], 0.0)
        ),
        *(given(*state, **whole).on(ANY) for state in ((1.0, 1.0), (-1.0, 1.0), (1.0, -1.0))),
    ]


def next_to_bottom(call):
    """Calls like this one next to the bottom, with gravity and without."""
    small, v = NEXT_TO_BOTTOM / call.kwargs["curvature"], call.args[1]
    return [
        call.but(x, v, gravity=g).on(_weighed("a bead next to the bottom", g))
        for x in (small, -small)
        for g in (call.kwargs["gravity"], 0.0)
    ]


def nearly_at_rest(call):
    """Next to the bottom, and as slow: the energy is tiny, and not zero."""
    x, v = NEXT_TO_BOTTOM / call.kwargs["curvature"], NEXT_TO_BOTTOM * call.args[1]
    return call.but(x, v).on("a bead next to the bottom")


def _weighed(kind, gravity):
    return kind if gravity else f"{kind}, without gravity"


def forces(draw):
    calls = beads(draw)
    return calls + next_to_bottom(calls[0])


def energies(draw):
    calls = forces(draw)
    return [*calls, nearly_at_rest(calls[0])]


def massless(calls):
    return [given(*call.args, **_wire(call)).on(call.kind) for call in calls]


def symbols(calls, *but):
    """The same values for symbols."""
    known = [
        {"x": call.args[0], "v": call.args[1], **{SYMBOLS[k]: a for k, a in call.kwargs.items()}} for call in calls
    ]
    values = [{name: value for name, value in one.items() if name not in but} for one in known]
    return [given(**one).on(call.kind) for one, call in zip(values, calls, strict=True)]


def _wire(call):
    return {name: call.kwargs[name] for name in ("curvature", "gravity")}


def ride(draw, low, high, count, turns, kind):
    """A motion of an amplitude of low to high, in units of 1/c, for `turns` over the rate of small motions."""
    wire, size, rate = _wired(draw, low, high)
    angle = draw.uniform(0.5, 1.2) * draw.choice([-1, 1])
    speed = size * rate * math.cos(angle) * draw.choice([-1, 1])
    x = size * math.sin(angle)
    v = speed / math.hypot(1, 2 * wire["curvature"] * x)
    return given(uneven(draw, turns / rate, count), x, v, **wire).on(kind)


def wide(draw):
    return [ride(draw, 0.4, 1.0, 1000, 15.0, "an amplitude near 1/c")]


def steep(draw):
    return [ride(draw, 5.0, 8.0, 60, 60.0, "an amplitude of several 1/c")]


def many_periods(draw):
    return [ride(draw, 0.4, 1.0, 300, 180.0, "many periods")]


def _wired(draw, low, high, decade=0.7):
    """A wire, an amplitude and the rate of small motions."""
    wire = {"curvature": 10 ** draw.uniform(-decade, decade), "gravity": draw.uniform(1, 25)}
    return wire, draw.uniform(low, high) / wire["curvature"], math.sqrt(2 * wire["gravity"] * wire["curvature"])


def few_times(draw):
    """Three times, most of the run and its sharp turns between two; two times, let go at rest and at the bottom."""
    sharp = ride(draw, 4.3, 5.0, 2, 21.0, "a few times, far apart")
    first, last = sharp.args[0]
    between = last - 1.5 / math.sqrt(2 * sharp.kwargs["gravity"] * sharp.kwargs["curvature"])
    cases = [sharp.but(np.array([first, between, last]))]
    for kind, low, high in (("at rest", 0.4, 1.0), ("at the bottom", 0.4, 1.0)):
        for sign in (1, -1):
            wire, size, rate = _wired(draw, low, high)
            start = (0.0, sign * size * rate) if kind == "at the bottom" else (sign * size, 0.0)
            cases.append(given(uneven(draw, 5.0 / rate, 2), *start, **wire).on(f"two times, the bead let go {kind}"))
    return [*cases, _at_rest(draw)]


def close(draw):
    """The oscillation of small amplitudes is off by 2e-3; an absolute tolerance of 1e-9 m is good to 1e-6."""
    wire, size, rate = _wired(draw, 0.02, 0.025, decade=0.3)
    kind = "two times, the bead let go at rest, close to the bottom"
    return given(uneven(draw, 5.0 / rate, 2), size, 0.0, **wire).on(kind)


def _at_rest(draw):
    wire = {"curvature": draw.uniform(0.5, 2), "gravity": draw.uniform(1, 25)}
    return given(uneven(draw, 5.0, 2), 0.0, 0.0, **wire).on("a bead at rest at the bottom, where it stays")


def weightless(draw):
    """The same with gravity and without: motions that are kept from call to call are wrong then."""
    case = ride(draw, 0.4, 1.0, 100, 6.0, "an amplitude near 1/c")
    return [case, case.but(gravity=0.0).on("gravity 0"), *in_turn(draw, case.but(case.args[0][:5]))]


def periods(draw, steepness, kind, decades=(-1, 1)):
    """Amplitudes in units of 1/c; decades of the curvature."""
    curvatures, gravities = 10 ** draw.uniform(*decades, len(steepness)), draw.uniform(1, 25, len(steepness))
    return [
        given(size / curvature, curvature=curvature, gravity=gravity).on(kind)
        for size, curvature, gravity in zip(steepness, curvatures, gravities, strict=True)
    ]


def usual_periods(draw):
    return periods(draw, draw.uniform(0.2, 0.6, 8), "an amplitude near 1/c")
