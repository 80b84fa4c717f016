"""Hidden inputs of hw13: random cylinders and ramps, and plain ones that tell what random ones do not."""

import math
from functools import partial
from itertools import product

import numpy as np

from tam570_grader import Case, repeated_calls, uneven

from . import reference

ONES = {"mass": 1.0, "radius": 1.0, "offset": 0.5, "inertia": 0.5, "slope": math.pi / 6, "gravity": 1.0}
QUARTERS = {"phi = 0": 0, "phi a quarter turn": 1, "phi a quarter turn back": -1, "phi half a turn": 2}
SIGNS = {"at rest": 0.0, "phi_dot above 0": 1.0, "phi_dot below 0": -1.0}


def cylinder(rng, **fixed):
    mass, radius = rng.uniform(0.3, 5), rng.uniform(0.2, 3)
    return {
        "mass": mass,
        "radius": radius,
        "offset": radius * rng.uniform(0.3, 0.6),
        "inertia": mass * radius**2 * rng.uniform(0.2, 0.8),
        "slope": rng.uniform(0.15, 1.2),
        "gravity": rng.uniform(1, 20),
        **fixed,
    }


def usual(cylinder):
    """Size of rates, rad/s."""
    return math.sqrt((cylinder.get("gravity") or 5.0) / cylinder["radius"])


def rolling(count, label="any angle", **fixed):
    """Angles of several turns, both signs of the rate."""

    def drawn(rng):
        bodies = [cylinder(rng, **fixed) for _ in range(count)]
        rates = [rng.choice([-1, 1]) * rng.uniform(0.5, 2) * usual(c) for c in bodies]
        return [Case(rng.uniform(-9, 9), rate, **c).labelled(label) for rate, c in zip(rates, bodies, strict=True)]

    return drawn


centred = partial(rolling, label="G at the centre", offset=0.0)
flat = partial(rolling, label="level ground", slope=0.0)
weightless = partial(rolling, label="no gravity", gravity=0.0)


def plain(rng):
    """Quarter turns, at rest or not, on ramps down and up, G off the centre or not."""
    down = cylinder(rng)
    up = {**down, "slope": -down["slope"]}
    centred = cylinder(rng, offset=0.0)
    return _quarters({"a ramp": down, "a ramp upwards": up, "G at the centre": centred, "parameters of 1": ONES})


def level(rng):
    """The same on level ground and without gravity."""
    return _quarters({"level ground": cylinder(rng, slope=0.0), "no gravity": cylinder(rng, gravity=0.0)})


def _quarters(cylinders):
    return [
        Case(quarters * math.pi / 2, sign * usual(c), **c).labelled(f"{label}, {place}, {way}")
        for (label, c), (place, quarters), (way, sign) in product(cylinders.items(), QUARTERS.items(), SIGNS.items())
    ]


def at_rest(cases):
    """For functions of the angle alone, and to tell what is wrong at rest, too."""
    return lambda rng: [call for call in cases(rng) if call.args[1] == 0]


def diagrams(rng):
    """Any angle, many turns too; G at the centre, level ground, no gravity, and the plain cases at rest."""
    calls = [*rolling(6)(rng), *centred(2)(rng), *flat(2)(rng), *weightless(2)(rng)]
    far = [calls[0].replace(turns * calls[0].args[0]).labelled("an angle of many turns") for turns in (1e3, -1e3)]
    level_and_centred = rolling(1, "level ground, G at the centre", slope=0.0, offset=0.0)(rng)
    return [*calls, *far, *level_and_centred, *at_rest(plain)(rng), *at_rest(level)(rng)]


def _pulled(call):
    """Whether the ramp must pull the cylinder."""
    return reference.contact_force(*call.args, **call.kwargs)[1] <= 0


def slow(rng):
    """So slow that the weight presses the cylinder on the ramp."""
    calls = [call.replace(call.args[0], call.args[1] / 5) for call in rolling(8)(rng) + centred(8)(rng)]
    return [call for call in calls + plain(rng) if not _pulled(call)]


def pulled(rng):
    """G is high and fast; the plain cases, too."""
    fast = [call.replace(call.args[0] / 9 + math.pi, 4 * call.args[1]) for call in rolling(8)(rng)]
    return [call.labelled("a normal force below zero") for call in fast + list(filter(_pulled, plain(rng)))]


# Motions


def runs(rng, count):
    """Rolling down, fast enough to pass every top with energy to spare, and rocking in a hollow."""
    down = cylinder(rng, slope=rng.uniform(0.2, 0.5))
    start = rng.uniform(-2, 2), rng.uniform(3, 4) * usual(down)
    hollow = cylinder(rng, slope=rng.uniform(0.05, 0.15))
    rest = math.asin(hollow["radius"] * math.sin(hollow["slope"]) / hollow["offset"]) - hollow["slope"]
    rocking = rest + rng.choice([-1, 1]) * rng.uniform(0.5, 0.9), -rng.uniform(0.1, 0.3) * usual(hollow)
    return [
        Case(uneven(rng, 8 / usual(down), count), *start, **down).labelled("a cylinder that rolls down"),
        Case(uneven(rng, 8 / usual(hollow), count), *rocking, **hollow).labelled("a cylinder that rocks"),
    ]


def few_times(rng):
    """Not fewer than eight in a long run: odeint takes no more than 500 steps from one to the next unless told to."""
    starts = {
        "let go at rest at phi = 0": (cylinder(rng), 0.0),
        "up a ramp": (cylinder(rng, slope=-rng.uniform(0.2, 0.5)), 1.0),
        "G at the centre": (cylinder(rng, offset=0.0), -1.0),
        "a cylinder at rest, G at its lowest, where it stays": (cylinder(rng, slope=0.0), 0.0),
    }
    first, *others = [
        Case(uneven(rng, 2 / usual(c), 2), 0.0, rate * usual(c), **c).labelled(f"two times, {label}")
        for label, (c, rate) in starts.items()
    ]
    again = repeated_calls(rng, first, slope=first.kwargs["slope"] / 2, inertia=0.8 * first.kwargs["inertia"])
    return [*runs(rng, 8), _heavy_side(rng), first, *others, *again]


def _heavy_side(rng):
    """Between the first two times a heavy side comes down, quickly, and goes up again.

    This takes short steps there, and in all fewer than the 500 of odeint.
    """
    c = cylinder(rng, slope=0.0)
    c["offset"] = c["radius"] * rng.uniform(0.84, 0.86)
    c["inertia"] = c["mass"] * c["radius"] ** 2 * rng.uniform(0.055, 0.065)
    start = math.pi + rng.uniform(-0.2, 0.2), rng.choice([-1, 1]) * rng.uniform(0.5, 0.55) * usual(c)
    first, last = uneven(rng, 6 / usual(c), 2)
    return Case(np.array([first, last - 0.4 / usual(c), last]), *start, **c).labelled("a few times, a heavy side")


def near_lowest(rng):
    """Let go on level ground. By the linear equation these two are off by 3e-3 and 3e-4; BDF at 1e-9 by 9e-8."""
    calls = []
    for angle, turns in ((0.19, 6), (0.08, 15)):
        c = cylinder(rng, slope=0.0)
        t, start = uneven(rng, turns / usual(c), 2), rng.choice([-1, 1]) * angle
        calls.append(Case(t, start, 0.0, **c).labelled("two times, let go near its lowest place on level ground"))
    return calls


def small_rocking(rng):
    """A small start on level ground."""
    c, angle = cylinder(rng, slope=0.0), rng.uniform(1, 2) * 1e-3
    t = uneven(rng, 25 / reference.rocking_rate(**c), 60)
    return [Case(t, angle, 0.0, **c).labelled("small rocking on level ground")]


def many_turns(rng):
    """The start's energy takes G over every top at no less than 0.5 usual(c)."""
    calls = []
    for fixed, label in (({"gravity": 0.0}, "without gravity"), ({"slope": 0.0}, "on level ground")):
        c = cylinder(rng, **fixed)
        t = uneven(rng, 50 / usual(c), 150)
        calls.append(Case(t, rng.uniform(-2, 2), 3 * usual(c), **c).labelled(f"many turns {label}"))
    return calls
