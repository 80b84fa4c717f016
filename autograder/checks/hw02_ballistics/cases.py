"""Hidden inputs of hw02: random launches, those of a name, and the limits of little and of great drag."""

import math

import numpy as np

from tam570_grader import SOME_TIMES, given, in_turn, uneven

from . import right

ANY = "a random launch"
LIGHT = "a light particle, whose drag is small in kg/s alone"
WHOLE = {"mass": 1.0, "drag": 1.0, "gravity": 1.0}
ZEROS = {
    "zero drag": {"drag": 0.0},
    "zero gravity": {"gravity": 0.0},
    "zero drag and gravity": {"drag": 0.0, "gravity": 0.0},
}
VELOCITIES = {
    "a particle at rest": (0.0, 0.0),
    "a particle at the top of its path": (1.0, 0.0),
    "a particle at the top of its path, thrown to the left": (-1.0, 0.0),
    "a particle on its way straight up": (0.0, 1.0),
    "a particle that falls straight down": (0.0, -1.0),
}
DIRECTIONS = {
    "a launch along x": 0.0,
    "a launch straight up": math.pi / 2,
    "a launch straight down": -math.pi / 2,
    "a launch to the left": math.pi,
    "a launch to the left, upwards": 2.0,
    "a launch downwards": -0.7,
    "a launch at 45 degrees": math.pi / 4,
}


def parameters(draw, **fixed):
    """A random mass, drag and gravity; the rate c/m is from .05 to 1.5."""
    mass = 10 ** draw.uniform(-0.7, 1)
    free = {"mass": mass, "drag": mass * 10 ** draw.uniform(-1.3, 0.2), "gravity": draw.uniform(1.5, 25)}
    return {**free, **fixed}


def light(draw):
    """A particle of some milligrams: the drag is tiny, but not beside the weight."""
    mass = 10 ** draw.uniform(-6, -5)
    return parameters(draw, mass=mass, drag=mass * draw.uniform(0.3, 1.5))


def weak(draw):
    return parameters(draw, gravity=10 ** draw.uniform(-3, -2))


def launch(draw):
    return 10 ** draw.uniform(0.5, 2), draw.uniform(0.15, 1.4)


# States


def states(draw):
    """Velocities in any direction, those that have a name, and whole numbers."""
    calls = [
        given(draw.uniform(-5, 5), draw.normal(size=4) * 10 ** draw.uniform(0, 2), **parameters(draw)).on("any state")
        for _ in range(20)
    ]
    for kind, velocity in VELOCITIES.items():
        for place in (draw.normal(size=2) * 10, np.zeros(2), -np.ones(2)):
            state = np.append(place, np.multiply(velocity, draw.uniform(1, 9)))
            calls.append(given(0.0, state, **parameters(draw)).on(kind))
    return [*calls, given(0.0, np.array([1.0, 1.0, -1.0, 1.0]), **WHOLE).on("whole numbers")]


def states_without(draw):
    """At rest, too, and along each axis."""
    moving = (1, 1, 1, [1, 1, 0, 0], [1, 1, 0, 1], [1, 1, 1, 0])
    known = ((some, kind, parameters(draw, **zero)) for kind, zero in ZEROS.items() for some in moving)
    return [given(0.0, draw.normal(size=4) * some * 10, **one).on(kind) for some, kind, one in known]


def light_state(draw):
    return given(0.0, draw.normal(size=4) * 10, **light(draw)).on(LIGHT)


# Motions


def flight(draw, start, known, kind):
    """A launch, and times from `start` on, for one to three times m/c."""
    fade = known["drag"] / known["mass"] or 0.3
    return given(uneven(draw, draw.uniform(1, 3) / fade, 30, start), *launch(draw), **known).on(kind)


def flights(draw):
    late = f"{ANY}, t[0] not 0"
    return [flight(draw, start, parameters(draw), late if start else ANY) for start in (0.0, 3.7, -2.0, 0.0)]


def flights_from_zero(draw):
    calls = [flight(draw, 0.0, parameters(draw), ANY) for _ in range(6)]
    return [*calls, flight(draw, 0.0, parameters(draw, gravity=0.0), f"{ANY} without gravity")]


def plain_flights(draw, shifted):
    """Two times each: directions that have a name, a drop, whole numbers; the first time is zero unless shifted."""
    starts = [(kind, launch(draw)[0], angle, parameters(draw)) for kind, angle in DIRECTIONS.items()]
    starts += [("a particle dropped", 0.0, 1.0, parameters(draw)), ("whole numbers", 1.0, 1.0, WHOLE)]
    calls = []
    for kind, speed, angle, known in starts:
        first = shifted * draw.uniform(0.2, 2) * draw.integers(2)
        t = np.array([first, first + draw.uniform(1, 3) * known["mass"] / known["drag"]])
        calls.append(given(t, speed, angle, **known).on(f"two times, {kind}"))
    return calls


def flights_without(draw):
    known = [(parameters(draw, **zero), kind) for kind, zero in ZEROS.items()]
    return [*(flight(draw, 0.0, *one) for one in known), flight(draw, 0.0, light(draw), LIGHT)]


def alike_flights(draw, from_zero=False):
    """Launches that are like the first of them but for one argument; all at t = 0, or not."""
    first = flight(draw, 0.0, parameters(draw), ANY)
    first = first.but(first.args[0][[0, -1]])
    speed, angle = first.args[1:]
    other = first.but(0.6 * first.args[0]).on("a launch like the one before but for its times")
    calls = [first, other, first, *in_turn(draw, first, start=(1.3 * speed, 0.7 * angle))]
    return [call for call in calls if call.args[0][0] == 0 or not from_zero]


def late_flights(draw):
    """Launched at t = 0, asked from another time on; a single time, and backwards."""
    kind = "times that do not begin at 0"
    calls = [flight(draw, start, parameters(draw), kind) for start in (2.5, -0.5, 0.7)]
    return calls + [calls[0].but(calls[0].args[0][some]).on(kind) for kind, some in SOME_TIMES.items()]


def flights_of_little_drag(draw):
    drags = (0.0, *10.0 ** draw.uniform(-14, -11, 3), *10.0 ** draw.uniform(-10, -2, 8))
    known = ((uneven(draw, draw.uniform(1, 9), 20, 0.0), parameters(draw, drag=drag)) for drag in drags)
    return [given(t, *launch(draw), **one).on("very little drag" if one["drag"] else "no drag") for t, one in known]


def flights_of_great_drag(draw):
    """Times c t/m up to a thousand or two, where e^s is more than any number; and to where no small steps lead."""
    known = parameters(draw)
    spans = draw.uniform(1000, 2000), 1e9
    times = [uneven(draw, span * known["mass"] / known["drag"], 20, 0.0) for span in spans]
    return [given(t, *launch(draw), **known).on("great drag") for t in times]


# Landings


def landings(draw, count):
    return [given(*launch(draw), **parameters(draw)).on(ANY) for _ in range(count)]


def plain_landings(draw):
    """Straight up, at 45 degrees, nearly flat, each with drag and without; and whole numbers."""
    angles = {"a launch straight up": math.pi / 2, "a launch at 45 degrees": math.pi / 4, "a nearly flat launch": 0.01}
    calls = [
        given(launch(draw)[0], angle, **parameters(draw, **fixed)).on(f"{kind}{also}")
        for kind, angle in angles.items()
        for also, fixed in (("", {}), (", no drag", {"drag": 0.0}))
    ]
    whole = [given(1.0, 1.0, **WHOLE), given(2.0, 1.0, **{**WHOLE, "drag": 0.0}), given(1.0, math.pi / 2, **WHOLE)]
    return calls + [call.on("whole numbers") for call in whole]


def of_lift(draw, lift, kind):
    """A launch with this lift, b = c vy/(m g)."""
    (speed, angle), known = launch(draw), parameters(draw)
    known["drag"] = lift * known["mass"] * known["gravity"] / (speed * math.sin(angle))
    return given(speed, angle, **known).on(kind)


def landings_of_little_drag(draw):
    """No drag, and b below 1e-2, most often where Lambert's W is off by 1e-16/b^2."""
    lifts = [0.0, *10.0 ** draw.uniform(-16, -8, 4), *10.0 ** draw.uniform(-5, -2, 6)]
    lifts += [*10.0 ** ((np.arange(12) + draw.uniform(0, 1, 12)) / 4 - 8)]
    return [of_lift(draw, lift, "very little drag" if lift else "no drag") for lift in lifts]


def landings_of_great_drag(draw):
    """b from ten to a million; from 709 on, e^s is more than any number."""
    return [of_lift(draw, lift, "great drag") for lift in 10.0 ** draw.uniform((1, 3, 3, 4), (3, 4, 4, 6))]


def flat_landings(draw):
    """The last takes 3e-6 s; a root good to 2e-12 s, as brentq's are, is off by less than the limit. Its b is 1."""
    up, flat = (given(launch(draw)[0], angle, **parameters(draw)) for angle in (math.pi / 2, 1e-3))
    flattest = given(2.0, 1e-6, mass=1.0, drag=5e5, gravity=1.0)
    return [up.on("a launch straight up"), *(call.on("a nearly flat launch") for call in (flat, flattest))]


def light_landings(draw):
    return [given(*launch(draw), **light(draw)).on(LIGHT) for _ in range(2)]


def alike_landings(draw):
    """Launches that are like the first of them but for one parameter."""
    (first,) = landings(draw, 1)
    others = [first.but(**{name: 1.4 * value}) for name, value in first.kwargs.items()]
    return [first, *(call.on("a launch like the one before but for one parameter") for call in others)]


# Speeds


def speeds(draw, swiftnesses, kind, special=parameters):
    """Speeds in units of the terminal speed m g/c."""
    known = [(swiftness, special(draw)) for swiftness in swiftnesses]
    return [given(v * one["mass"] * one["gravity"] / one["drag"], **one).on(kind) for v, one in known]


def usual_speeds(draw):
    kind = "a speed from a tenth to a hundred times the terminal speed"
    return speeds(draw, [*10.0 ** draw.uniform(-1, 2, 6)], kind) + [given(v, **WHOLE).on(kind) for v in (1.0, 2.0)]


def slow_speeds(draw):
    """The third is always from .007 to .01, where a series of first order in the drag is off by 5e-6 and more."""
    kind = "a speed below a tenth of the terminal speed"
    return speeds(draw, 10.0 ** (draw.uniform(0, 1, 4) * [2, 1, 0.15, 1] - [6, 4, 2.16, 2]), kind)


def speeds_without_drag(draw):
    kinds = {0.0: "no drag", 1e-12: "very little drag", 1e-10: "very little drag"}
    return [given(launch(draw)[0], **parameters(draw, drag=drag)).on(kind) for drag, kind in kinds.items()]


def small_speeds(draw):
    """About the terminal speed of light particles, and where gravity is weak."""
    about = [10.0 ** draw.uniform(-0.3, 0.3, 2) for _ in range(2)]
    slow = speeds(draw, about[1], "a slow launch where gravity is weak", weak)
    return speeds(draw, about[0], LIGHT, light) + slow


def alike_speeds(draw):
    return [given(call.args[0], **call.kwargs).on(call.kind) for call in alike_landings(draw)]


def picture(draw):
    """Visibly no straight line, and no parabola: some terminal speeds; 401 samples."""
    known, angle = parameters(draw), draw.uniform(0.5, 1.2)
    speed = draw.uniform(1.5, 5) * known["mass"] * known["gravity"] / known["drag"]
    duration = max(2.5 * known["mass"] / known["drag"], 1.2 * right.flight_time(speed, angle, **known))
    return given(np.linspace(0.0, duration, 401), speed, angle, **known)
