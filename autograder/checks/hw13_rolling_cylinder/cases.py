"""Hidden inputs of hw13: random cylinders and ramps, and plain ones for mistakes that random ones do not show."""

import math
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
    """Return the scale of rates, rad/s."""
    return math.sqrt((cylinder.get("gravity") or 5.0) / cylinder["radius"])


def rolling(rng, count, label="any angle", **fixed):
    """Return states, each some turns further than the last, with angles and rates of both signs."""
    bodies = [cylinder(rng, **fixed) for _ in range(count)]
    rates = [rng.choice([-1, 1]) * rng.uniform(0.5, 2) * usual(body) for body in bodies]
    angles = [rng.choice([-1, 1]) * rng.uniform(10 * i, 10 * i + 10) for i in range(count)]
    motions = zip(angles, rates, bodies, strict=True)
    return [Case(angle, rate, **body).labelled(label) for angle, rate, body in motions]


def centred(rng, count):
    return rolling(rng, count, "G at the centre", offset=0.0)


def flat(rng, count):
    return rolling(rng, count, "level ground", slope=0.0)


def weightless(rng, count):
    return rolling(rng, count, "no gravity", gravity=0.0)


def plain(rng):
    """Return quarter turns, those at rest first, on ramps down and up, G off the centre or not."""
    down, centred = cylinder(rng), cylinder(rng, offset=0.0)
    up = {**down, "slope": -down["slope"]}
    return _quarters({"a ramp": down, "a ramp upwards": up, "G at the centre": centred, "parameters of 1": ONES})


def level(rng):
    """Return the same on level ground and without gravity."""
    return _quarters({"level ground": cylinder(rng, slope=0.0), "no gravity": cylinder(rng, gravity=0.0)})


def _quarters(cylinders):
    cases = []
    for (i, (label, body)), (j, (where, quarters)) in product(
        enumerate(cylinders.items()), enumerate(QUARTERS.items())
    ):
        way, sign = list(SIGNS.items())[(i + j) % len(SIGNS)]
        case = Case(quarters * math.pi / 2, sign * usual(body), **body)
        cases.append(case.labelled(f"{label}, {where}, {way}"))
    return sorted(cases, key=lambda case: case.args[1] != 0)


def diagrams(rng):
    """Return any angle, also of many turns; G at the centre, level ground, no gravity, and the plain cases."""
    cases = [*rolling(rng, 3), *centred(rng, 1), *flat(rng, 1), *weightless(rng, 1)]
    far = cases[0].replace(-1e3 * cases[0].args[0]).labelled("an angle of many turns")
    level_and_centred = rolling(rng, 1, "level ground, G at the centre", slope=0.0, offset=0.0)
    return [*cases, far, *level_and_centred, *plain(rng)]


def _pulled(case):
    """Return whether the ramp must pull the cylinder."""
    return reference.contact_force(*case.args, **case.kwargs)[1] <= 0


def slow(rng):
    """Return states so slow that the weight presses the cylinder on the ramp."""
    cases = [case.replace(case.args[0], case.args[1] / 5) for case in rolling(rng, 3) + centred(rng, 2)]
    return [case for case in cases + plain(rng) if not _pulled(case)]


def pulled(rng):
    """Return states in which G is high and fast, also of the plain cases."""
    fast = [case.replace(math.pi + rng.uniform(-1, 1), 4 * case.args[1]) for case in rolling(rng, 3)]
    return [case.labelled("a normal force below zero") for case in fast + list(filter(_pulled, plain(rng)))]


# Motions


def runs(rng):
    """Return rolling down, fast enough to pass every top with energy to spare, and rocking in a hollow."""
    down = cylinder(rng, slope=rng.uniform(0.2, 0.5))
    start = rng.uniform(-2, 2), rng.uniform(3, 4) * usual(down)
    hollow = cylinder(rng, slope=rng.uniform(0.05, 0.15))
    rest = math.asin(hollow["radius"] * math.sin(hollow["slope"]) / hollow["offset"]) - hollow["slope"]
    rocking = rest + rng.choice([-1, 1]) * rng.uniform(0.5, 0.9), -rng.uniform(0.1, 0.3) * usual(hollow)
    return [
        Case(uneven(rng, 6 / usual(down), 25), *start, **down).labelled("a cylinder that rolls down"),
        Case(uneven(rng, 8 / usual(hollow), 25), *rocking, **hollow).labelled("a cylinder that rocks"),
    ]


def few_times(rng):
    """Return a start at rest at phi = 0, on a ramp and then without slope and gravity, where it stays; a heavy side.

    No long run has few times, because odeint makes at most 500 steps from one to the next by default.
    """
    body = cylinder(rng)
    first = Case(uneven(rng, 2 / usual(body), 3), 0.0, 0.0, **body).labelled("a few times, let go at rest at phi = 0")
    weightless = {"slope": 0.0, "gravity": 0.0, "inertia": 0.8 * body["inertia"]}
    return [first, *repeated_calls(rng, first, start=(0.5, -usual(body)), **weightless), _heavy_side(rng)]


def _heavy_side(rng):
    """Return a run in which a heavy side comes down quickly between the first two times, and goes up again.

    This needs short steps there, and in all fewer than the 500 of odeint.
    """
    c = cylinder(rng, slope=0.0)
    c["offset"] = c["radius"] * rng.uniform(0.84, 0.86)
    c["inertia"] = c["mass"] * c["radius"] ** 2 * rng.uniform(0.055, 0.065)
    start = math.pi + rng.uniform(-0.2, 0.2), rng.choice([-1, 1]) * rng.uniform(0.5, 0.55) * usual(c)
    first, last = uneven(rng, 6 / usual(c), 2)
    return Case(np.array([first, last - 0.4 / usual(c), last]), *start, **c).labelled("a few times, a heavy side")


def near_lowest(rng):
    """Return a start at rest on level ground. The linear equation has an error of 3e-3; BDF at 1e-9 of 9e-8."""
    body = cylinder(rng, slope=0.0)
    t, start = uneven(rng, 6 / usual(body), 2), rng.choice([-1, 1]) * 0.19
    return [Case(t, start, 0.0, **body).labelled("two times, let go near its lowest place on level ground")]


def small_rocking(rng):
    """Return a small start on level ground."""
    c, angle = cylinder(rng, slope=0.0), rng.uniform(1, 2) * 1e-3
    t = uneven(rng, 15 / reference.rocking_rate(**c), 12)
    return [Case(t, angle, 0.0, **c).labelled("small rocking on level ground")]


def many_turns(rng):
    """Return a start with the energy to take G over every top at no less than 0.5 usual(c)."""
    c = cylinder(rng, slope=0.0)
    t = uneven(rng, 20 / usual(c), 9)
    return [Case(t, rng.uniform(-2, 2), 3 * usual(c), **c).labelled("many turns on level ground")]
