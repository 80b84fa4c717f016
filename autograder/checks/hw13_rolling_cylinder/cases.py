"""Hidden inputs of hw13: random cylinders and ramps, and plain ones that tell what random ones do not."""

import math
from functools import partial

import numpy as np

from tam570_grader import given, in_turn, once, uneven

from . import right

BODY = ("mass", "radius", "offset", "inertia")
QUARTERS = {
    "phi = 0": 0.0,
    "phi a quarter turn": math.pi / 2,
    "phi a quarter turn back": -math.pi / 2,
    "phi half a turn": math.pi,
}


def cylinder(draw, **fixed):
    mass, radius = draw.uniform(0.3, 5), draw.uniform(0.2, 3)
    drawn = {
        "mass": mass,
        "radius": radius,
        "offset": radius * draw.uniform(0.3, 0.6),
        "inertia": mass * radius**2 * draw.uniform(0.2, 0.8),
        "slope": draw.uniform(0.15, 1.2),
        "gravity": draw.uniform(1, 20),
    }
    return {**drawn, **fixed}


def usual(cylinder):
    """Size of rates, rad/s."""
    return math.sqrt((cylinder.get("gravity") or 5.0) / cylinder["radius"])


def rolling(count, **fixed):
    """Angles of several turns, both signs of the rate."""

    def drawn(draw):
        bodies = [cylinder(draw, **fixed) for _ in range(count)]
        return named([(draw.uniform(-9, 9), draw.choice([-1, 1]) * draw.uniform(0.5, 2) * usual(c), c) for c in bodies])

    return drawn


def plain(draw):
    """Quarter turns, at rest or not, on ramps down and up, G off the centre or not."""
    down = cylinder(draw)
    ones = {"mass": 1.0, "radius": 1.0, "offset": 0.5, "inertia": 0.5, "slope": math.pi / 6, "gravity": 1.0}
    return _quarters([down, {**down, "slope": -down["slope"]}, cylinder(draw, offset=0.0), ones])


def level(draw):
    """The same on level ground and without gravity."""
    return _quarters([cylinder(draw, slope=0.0), cylinder(draw, gravity=0.0)])


def _quarters(cylinders):
    angles = QUARTERS.values()
    return named([(angle, sign * usual(c), c) for c in cylinders for angle in angles for sign in (0.0, 1.0, -1.0)])


def named(motions):
    return [call.on(kind_of(call)) for call in (given(phi, rate, **c) for phi, rate, c in motions)]


def kind_of(call):
    """What is special comes first."""
    known = call.kwargs
    special = {
        "G at the centre": known["offset"] == 0,
        "no gravity": known.get("gravity") == 0,
        "level ground": known.get("slope") == 0,
        "a ramp upwards": known.get("slope", 0.0) < 0,
    }
    angle = next((name for name, angle in QUARTERS.items() if angle == call.args[0]), "any angle")
    signs = {0: "at rest", 1: "phi_dot above 0", -1: "phi_dot below 0"}
    return ", ".join(
        [says for says, it in special.items() if it] + [angle] + [signs[np.sign(r)] for r in call.args[1:]]
    )


def of(*names, rates=True):
    """The arguments of a function that is given these parameters alone, with or without a rate."""

    def those(call):
        few = given(*call.args[: 1 + rates], **{name: call.kwargs[name] for name in names})
        return few.on(kind_of(few))

    return lambda *drawn: lambda draw: [those(call) for one in drawn for call in one(draw)]


at_rest = of(*BODY, "slope", "gravity", rates=False)


def pressed(calls, on=True):
    """Those in which the weight presses the cylinder on the ramp, or those in which it must be pulled."""
    return [call for call in calls if (right.contact_force(*call.args, **call.kwargs)[1] > 0) == on]


def slow(draw):
    """So slow that the weight presses the cylinder on the ramp."""
    calls = rolling(8)(draw) + rolling(8, offset=0.0)(draw)
    return pressed([call.but(call.args[0], call.args[1] / 5) for call in calls] + plain(draw))


def pulled(draw):
    """G is high and fast; the plain cases, too."""
    fast = [call.but(call.args[0] / 9 + math.pi, 4 * call.args[1]) for call in rolling(8)(draw)]
    return [call.on("a normal force below zero") for call in fast + pressed(plain(draw), on=False)]


flat, weightless = partial(rolling, slope=0.0), partial(rolling, gravity=0.0)
bodies = of(*BODY, rates=False)(rolling(12), rolling(3, offset=0.0), plain, level)
resting = at_rest(rolling(10), flat(3), weightless(2), plain, level)
unweighed = of("mass", "radius", "offset")(rolling(20), plain, level)

# Motions


@once
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


def dense_runs(draw):
    return runs(draw, 200)


def few_times(draw):
    """Not fewer than eight in a long run: odeint takes no more than 500 steps from one to the next unless told to."""
    starts = {
        "two times, let go at rest at phi = 0": (cylinder(draw), 0.0),
        "two times, up a ramp": (cylinder(draw, slope=-draw.uniform(0.2, 0.5)), 1.0),
        "two times, G at the centre": (cylinder(draw, offset=0.0), -1.0),
        "a cylinder at rest, G at its lowest, where it stays": (cylinder(draw, slope=0.0), 0.0),
    }
    two = [
        given(uneven(draw, 2 / usual(c), 2), 0.0, rate * usual(c), **c).on(kind) for kind, (c, rate) in starts.items()
    ]
    again = in_turn(draw, two[0], slope=two[0].kwargs["slope"] / 2, inertia=0.8 * two[0].kwargs["inertia"])
    return [*runs(draw, 8), _heavy_side(draw), *two, *again]


def _heavy_side(draw):
    """Between the first two times a heavy side comes down, quickly, and goes up again.

    This takes short steps there, and in all fewer than the 500 of odeint.
    """
    c = cylinder(draw, slope=0.0)
    c["offset"] = c["radius"] * draw.uniform(0.84, 0.86)
    c["inertia"] = c["mass"] * c["radius"] ** 2 * draw.uniform(0.055, 0.065)
    start = math.pi + draw.uniform(-0.2, 0.2), draw.choice([-1, 1]) * draw.uniform(0.5, 0.55) * usual(c)
    first, last = uneven(draw, 6 / usual(c), 2)
    t = np.array([first, last - 0.4 / usual(c), last])
    return given(t, *start, **c).on("a few times, a cylinder with a heavy side")


def near_lowest(draw):
    """Let go on level ground. By the linear equation these two are off by 3e-3 and 3e-4; BDF at 1e-9 by 9e-8."""
    calls = []
    for angle, turns, close in ((0.19, 6, ""), (0.08, 15, ", close to where it would stay")):
        c = cylinder(draw, slope=0.0)
        t, kind = uneven(draw, turns / usual(c), 2), f"two times, let go at rest on level ground{close}"
        calls.append(given(t, draw.choice([-1, 1]) * angle, 0.0, **c).on(kind))
    return calls


def small_rocking(draw):
    """A small start on level ground."""
    c = cylinder(draw, slope=0.0)
    call = given(draw.uniform(1, 2) * 1e-3, 0.0, **c)
    k = math.sqrt(c["mass"] * c["gravity"] * c["offset"] / right.contact_inertia(0.0, *(c[name] for name in BODY)))
    return given(uneven(draw, 25 / k, 60), *call.args, **c).on("small rocking on level ground")


def many_turns(draw):
    """The start's energy takes G over every top at no less than 0.5 usual(c)."""
    calls = []
    for fixed, kind in (
        ({"gravity": 0.0}, "many turns without gravity"),
        ({"slope": 0.0}, "many turns on level ground"),
    ):
        c = cylinder(draw, **fixed)
        t = uneven(draw, 50 / usual(c), 150)
        calls.append(given(t, draw.uniform(-2, 2), 3 * usual(c), **c).on(kind))
    return calls
