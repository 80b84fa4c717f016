"""Hidden inputs of hw13: random cylinders and ramps, and plain ones that tell what random ones do not."""

import math
from functools import partial
from itertools import product

import numpy as np

from tam570_grader import given, in_turn, uneven

from . import right

ONES = {"mass": 1.0, "radius": 1.0, "offset": 0.5, "inertia": 0.5, "slope": math.pi / 6, "gravity": 1.0}
QUARTERS = {"phi = 0": 0, "phi a quarter turn": 1, "phi a quarter turn back": -1, "phi half a turn": 2}
SIGNS = {"at rest": 0.0, "phi_dot above 0": 1.0, "phi_dot below 0": -1.0}


def cylinder(draw, **fixed):
    mass, radius = draw.uniform(0.3, 5), draw.uniform(0.2, 3)
    return {
        "mass": mass,
        "radius": radius,
        "offset": radius * draw.uniform(0.3, 0.6),
        "inertia": mass * radius**2 * draw.uniform(0.2, 0.8),
        "slope": draw.uniform(0.15, 1.2),
        "gravity": draw.uniform(1, 20),
        **fixed,
    }


def usual(cylinder):
    """Size of rates, rad/s."""
    return math.sqrt((cylinder.get("gravity") or 5.0) / cylinder["radius"])


def rolling(count, kind="any angle", **fixed):
    """Angles of several turns, both signs of the rate."""

    def drawn(draw):
        bodies = [cylinder(draw, **fixed) for _ in range(count)]
        rates = [draw.choice([-1, 1]) * draw.uniform(0.5, 2) * usual(c) for c in bodies]
        return [given(draw.uniform(-9, 9), rate, **c).on(kind) for rate, c in zip(rates, bodies, strict=True)]

    return drawn


centred = partial(rolling, kind="G at the centre", offset=0.0)
flat = partial(rolling, kind="level ground", slope=0.0)
weightless = partial(rolling, kind="no gravity", gravity=0.0)


def plain(draw):
    """Quarter turns, at rest or not, on ramps down and up, G off the centre or not."""
    down = cylinder(draw)
    up = {**down, "slope": -down["slope"]}
    centred = cylinder(draw, offset=0.0)
    return _quarters({"a ramp": down, "a ramp upwards": up, "G at the centre": centred, "parameters of 1": ONES})


def level(draw):
    """The same on level ground and without gravity."""
    return _quarters({"level ground": cylinder(draw, slope=0.0), "no gravity": cylinder(draw, gravity=0.0)})


def _quarters(cylinders):
    return [
        given(quarters * math.pi / 2, sign * usual(c), **c).on(f"{kind}, {place}, {way}")
        for (kind, c), (place, quarters), (way, sign) in product(cylinders.items(), QUARTERS.items(), SIGNS.items())
    ]


def at_rest(cases):
    """For functions of the angle alone, and to tell what is wrong at rest, too."""
    return lambda draw: [call for call in cases(draw) if call.args[1] == 0]


def diagrams(draw):
    """Any angle, many turns too; G at the centre, level ground, no gravity, and the plain cases at rest."""
    calls = [*rolling(6)(draw), *centred(2)(draw), *flat(2)(draw), *weightless(2)(draw)]
    far = [calls[0].but(turns * calls[0].args[0]).on("an angle of many turns") for turns in (1e3, -1e3)]
    level_and_centred = rolling(1, "level ground, G at the centre", slope=0.0, offset=0.0)(draw)
    return [*calls, *far, *level_and_centred, *at_rest(plain)(draw), *at_rest(level)(draw)]


def _pulled(call):
    """Whether the ramp must pull the cylinder."""
    return right.contact_force(*call.args, **call.kwargs)[1] <= 0


def slow(draw):
    """So slow that the weight presses the cylinder on the ramp."""
    calls = [call.but(call.args[0], call.args[1] / 5) for call in rolling(8)(draw) + centred(8)(draw)]
    return [call for call in calls + plain(draw) if not _pulled(call)]


def pulled(draw):
    """G is high and fast; the plain cases, too."""
    fast = [call.but(call.args[0] / 9 + math.pi, 4 * call.args[1]) for call in rolling(8)(draw)]
    return [call.on("a normal force below zero") for call in fast + list(filter(_pulled, plain(draw)))]


# Motions


def runs(draw, count):
    """Rolling down, fast enough to pass every top with energy to spare, and rocking in a hollow."""
    down = cylinder(draw, slope=draw.uniform(0.2, 0.5))
    start = draw.uniform(-2, 2), draw.uniform(3, 4) * usual(down)
    hollow = cylinder(draw, slope=draw.uniform(0.05, 0.15))
    rest = math.asin(hollow["radius"] * math.sin(hollow["slope"]) / hollow["offset"]) - hollow["slope"]
    rocking = rest + draw.choice([-1, 1]) * draw.uniform(0.5, 0.9), -draw.uniform(0.1, 0.3) * usual(hollow)
    return [
        given(uneven(draw, 8 / usual(down), count), *start, **down).on("a cylinder that rolls down"),
        given(uneven(draw, 8 / usual(hollow), count), *rocking, **hollow).on("a cylinder that rocks"),
    ]


def few_times(draw):
    """Not fewer than eight in a long run: odeint takes no more than 500 steps from one to the next unless told to."""
    starts = {
        "let go at rest at phi = 0": (cylinder(draw), 0.0),
        "up a ramp": (cylinder(draw, slope=-draw.uniform(0.2, 0.5)), 1.0),
        "G at the centre": (cylinder(draw, offset=0.0), -1.0),
        "a cylinder at rest, G at its lowest, where it stays": (cylinder(draw, slope=0.0), 0.0),
    }
    first, *others = [
        given(uneven(draw, 2 / usual(c), 2), 0.0, rate * usual(c), **c).on(f"two times, {kind}")
        for kind, (c, rate) in starts.items()
    ]
    again = in_turn(draw, first, slope=first.kwargs["slope"] / 2, inertia=0.8 * first.kwargs["inertia"])
    return [*runs(draw, 8), _heavy_side(draw), first, *others, *again]


def _heavy_side(draw):
    """Between the first two times a heavy side comes down, quickly, and goes up again.

    This takes short steps there, and in all fewer than the 500 of odeint.
    """
    c = cylinder(draw, slope=0.0)
    c["offset"] = c["radius"] * draw.uniform(0.84, 0.86)
    c["inertia"] = c["mass"] * c["radius"] ** 2 * draw.uniform(0.055, 0.065)
    start = math.pi + draw.uniform(-0.2, 0.2), draw.choice([-1, 1]) * draw.uniform(0.5, 0.55) * usual(c)
    first, last = uneven(draw, 6 / usual(c), 2)
    return given(np.array([first, last - 0.4 / usual(c), last]), *start, **c).on("a few times, a heavy side")


def near_lowest(draw):
    """Let go on level ground. By the linear equation these two are off by 3e-3 and 3e-4; BDF at 1e-9 by 9e-8."""
    calls = []
    for angle, turns in ((0.19, 6), (0.08, 15)):
        c = cylinder(draw, slope=0.0)
        t, start = uneven(draw, turns / usual(c), 2), draw.choice([-1, 1]) * angle
        calls.append(given(t, start, 0.0, **c).on("two times, let go near its lowest place on level ground"))
    return calls


def small_rocking(draw):
    """A small start on level ground."""
    c, angle = cylinder(draw, slope=0.0), draw.uniform(1, 2) * 1e-3
    t = uneven(draw, 25 / right.rocking_rate(**c), 60)
    return [given(t, angle, 0.0, **c).on("small rocking on level ground")]


def many_turns(draw):
    """The start's energy takes G over every top at no less than 0.5 usual(c)."""
    calls = []
    for fixed, kind in (({"gravity": 0.0}, "without gravity"), ({"slope": 0.0}, "on level ground")):
        c = cylinder(draw, **fixed)
        t = uneven(draw, 50 / usual(c), 150)
        calls.append(given(t, draw.uniform(-2, 2), 3 * usual(c), **c).on(f"many turns {kind}"))
    return calls
