"""Hidden inputs of hw02: random launches, those of a name, and the limits of little and of great drag."""

import math

import numpy as np

from tam570_grader import SOME_TIMES, given, in_turn, uneven

from . import right

ANY = "a random launch"
LIGHT = "a light particle, whose drag is small only in kg/s"
WHOLE = {"mass": 1.0, "drag": 1.0, "gravity": 1.0}
LITTLE = 0.99 * 10.0 ** -np.arange(1, 7)  # below which a series takes over: its error is largest just below
NO_DRAG, NO_GRAVITY = {"drag": 0.0}, {"gravity": 0.0}
ZEROS = {"zero drag": NO_DRAG, "zero gravity": NO_GRAVITY, "zero drag and gravity": {**NO_DRAG, **NO_GRAVITY}}
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


def launch(draw):
    return 10 ** draw.uniform(0.5, 2), draw.uniform(0.15, 1.4)


# States


def states(draw):
    """Velocities in any direction, those that have a name, whole numbers, a light particle."""
    calls = [
        given(draw.uniform(-5, 5), draw.normal(size=4) * 10 ** draw.uniform(0, 2), **parameters(draw)).on("any state")
        for _ in range(20)
    ]
    for kind, velocity in VELOCITIES.items():
        for place in (draw.normal(size=2) * 10, np.zeros(2), -np.ones(2)):
            state = np.append(place, np.multiply(velocity, draw.uniform(1, 9)))
            calls.append(given(0.0, state, **parameters(draw)).on(kind))
    whole = given(0.0, np.array([1.0, 1.0, -1.0, 1.0]), **WHOLE).on("whole numbers")
    return [*calls, whole, given(0.0, draw.normal(size=4) * 10, **light(draw)).on(LIGHT)]


def states_without(draw):
    """At rest, too, and along each axis."""
    return [
        given(0.0, draw.normal(size=4) * moving * 10, **parameters(draw, **zero)).on(kind)
        for kind, zero in ZEROS.items()
        for moving in (1, 1, 1, [1, 1, 0, 0], [1, 1, 0, 1], [1, 1, 1, 0])
    ]


def without_time(draw):
    """For the function of the state alone."""
    return [given(*case.args[1:], **case.kwargs).on(case.kind) for case in states(draw) + states_without(draw)]


# Motions


def flight(draw, kind, known, start=0.0):
    """A launch, and times from `start` on, for one to three times m/c."""
    fade = known["drag"] / known["mass"] or 0.3
    return given(uneven(draw, draw.uniform(1, 3) / fade, 30, start), *launch(draw), **known).on(kind)


def flights(draw):
    late = [flight(draw, f"{ANY}, t[0] not 0", parameters(draw), start) for start in (3.7, -2.0)]
    return [*late, *(flight(draw, ANY, parameters(draw)) for _ in range(2)), *plain_flights(draw)]


def flights_from_zero(draw):
    without = flight(draw, f"{ANY} without gravity", parameters(draw, gravity=0.0))
    return [*(flight(draw, ANY, parameters(draw)) for _ in range(6)), without, *plain_flights(draw)]


def plain_flights(draw):
    """Two times each: directions that have a name, a drop, whole numbers."""
    starts = [(kind, launch(draw)[0], angle, parameters(draw)) for kind, angle in DIRECTIONS.items()]
    starts += [("a particle dropped", 0.0, 1.0, parameters(draw)), ("whole numbers", 1.0, 1.0, WHOLE)]
    for kind, *start, known in starts:
        t = np.array([0.0, draw.uniform(1, 3) * known["mass"] / known["drag"]])
        yield given(t, *start, **known).on(f"two times, {kind}")


def flights_without(draw):
    """Without drag or gravity, of light particles, and like one before."""
    without = [flight(draw, kind, parameters(draw, **zero)) for kind, zero in ZEROS.items()]
    return [*without, flight(draw, LIGHT, light(draw)), *alike_flights(draw)]


def alike_flights(draw):
    """Launches that are like the first of them but for one argument."""
    first = flight(draw, ANY, parameters(draw))
    t, speed, angle = first.args
    first = first.but(t[:3])
    return [first, *in_turn(draw, first, start=(1.3 * speed, 0.7 * angle))]


def late_flights(draw):
    """Launched at t = 0, asked from another time on; a single time, and backwards."""
    calls = [flight(draw, "times that do not begin at 0", parameters(draw), start) for start in (2.5, -0.5, 0.7)]
    return calls + [calls[0].but(calls[0].args[0][some]).on(kind) for kind, some in SOME_TIMES.items()]


def flights_with_any_drag(draw):
    """None, little, of light particles, and like one before at t = 0.

    Great drag is that of times c t/m up to a thousand or two, where e^s is more than any number, and to where no small
    steps lead.
    """
    drags = [0.0, *10.0 ** draw.uniform(-14, -11, 3), *10.0 ** draw.uniform(-10, -2, 4)]
    known = [("very little drag" if drag else "no drag", parameters(draw, drag=drag)) for drag in drags]
    calls = [given(uneven(draw, draw.uniform(1, 9), 20, 0.0), *launch(draw), **one).on(kind) for kind, one in known]
    one = parameters(draw)
    for span in (*LITTLE, draw.uniform(1000, 2000), 1e9):  # of c t/m
        t = uneven(draw, span * one["mass"] / one["drag"], 20, 0.0)
        calls.append(given(t, *launch(draw), **one).on("very little drag" if span < 1 else "great drag"))
    return calls + [flight(draw, LIGHT, light(draw)), *(case for case in alike_flights(draw) if case.args[0][0] == 0)]


# Landings


def landings(draw):
    """Random ones; straight up, at 45 degrees, nearly flat, each with drag and without; whole numbers."""
    calls = [of_lift(draw, lift, ANY) for lift in 10.0 ** draw.uniform(-1.3, 1.3, 12)]
    angles = {"a launch straight up": math.pi / 2, "a launch at 45 degrees": math.pi / 4, "a nearly flat launch": 0.01}
    for kind, angle in angles.items():
        for also, lift in (("", draw.uniform(0.3, 3)), (", no drag", 0.0)):
            calls.append(of_lift(draw, lift, f"{kind}{also}", angle))
    whole = given(1.0, 1.0, **WHOLE).on("whole numbers")
    return [*calls, whole, whole.but(2.0, drag=0.0), whole.but(1.0, math.pi / 2)]


def of_lift(draw, lift, kind, angle=None):
    """A launch with this lift, b = c vy/(m g)."""
    (speed, usual), known = launch(draw), parameters(draw)
    angle = angle or usual
    known["drag"] = lift * known["mass"] * known["gravity"] / (speed * math.sin(angle))
    return given(speed, angle, **known).on(kind)


def landings_of_little_drag(draw):
    """No drag, and b below 1e-1, most often where Lambert's W is off by 1e-16/b^2."""
    lifts = [*10.0 ** draw.uniform(-16, -8, 4), *LITTLE]
    lifts += [*10.0 ** ((np.arange(12) + draw.uniform(0, 1, 12)) / 4 - 8)]
    return [of_lift(draw, 0.0, "no drag"), *(of_lift(draw, lift, "very little drag") for lift in lifts)]


def landings_of_great_drag(draw):
    """b from ten to a million; from 709 on, e^s is more than any number. Light particles; launches like one before."""
    great = [of_lift(draw, lift, "great drag") for lift in 10.0 ** draw.uniform((1, 3, 3, 4), (3, 4, 4, 6))]
    return great + [given(*launch(draw), **light(draw)).on(LIGHT) for _ in range(2)] + alike_landings(draw)


def flat_landings(draw):
    """The last takes 3e-6 s; a root good to 2e-12 s, as brentq's are, is off by less than the limit. Its b is 1."""
    angles = {"a launch straight up": math.pi / 2, "a nearly flat launch": 1e-3}
    some = [of_lift(draw, draw.uniform(0.3, 3), kind, angle) for kind, angle in angles.items()]
    return [*some, given(2.0, 1e-6, mass=1.0, drag=5e5, gravity=1.0).on("a nearly flat launch")]


def alike_landings(draw):
    """Launches that are like the first of them but for one parameter."""
    first = of_lift(draw, draw.uniform(0.3, 3), ANY)
    others = [first.but(**{name: 1.4 * value}) for name, value in first.kwargs.items()]
    return [first, *(call.on("the launch before with one parameter changed") for call in others)]


# Speeds


def at_speed(swiftness, kind, known):
    """A speed in units of the terminal speed m g/c."""
    return given(swiftness * known["mass"] * known["gravity"] / known["drag"], **known).on(kind)


def usual_speeds(draw):
    kind = "a speed from a tenth to a hundred times the terminal speed"
    some = [at_speed(swiftness, kind, parameters(draw)) for swiftness in 10.0 ** draw.uniform(-1, 2, 6)]
    return some + [given(speed, **WHOLE).on(kind) for speed in (1.0, 2.0)]


def slow_speeds(draw):
    """No drag; below a tenth of the terminal speed; about it, of light particles and in weak gravity; like one before.

    The third is always from .007 to .01, where a series of first order in the drag is off by 5e-6 and more.
    """
    drags = {0.0: "no drag", 1e-12: "very little drag", 1e-10: "very little drag"}
    calls = [given(launch(draw)[0], **parameters(draw, drag=drag)).on(kind) for drag, kind in drags.items()]
    for swiftness in 10.0 ** (draw.uniform(0, 1, 4) * [2, 1, 0.15, 1] - [6, 4, 2.16, 2]):
        calls.append(at_speed(swiftness, "a speed below a tenth of the terminal speed", parameters(draw)))
    for swiftness in 10.0 ** draw.uniform(-0.3, 0.3, 2):
        weak = parameters(draw, gravity=10 ** draw.uniform(-3, -2))
        calls.append(at_speed(swiftness, LIGHT, light(draw)))
        calls.append(at_speed(swiftness, "a slow launch where gravity is weak", weak))
    return calls + alike_landings(draw)


def huge_speeds(draw):
    """Minimising the range on a logarithmic scale is good to 1e-4 of the angle up to 1e6, and not at 1e7."""
    return [at_speed(swiftness, "a huge speed", parameters(draw)) for swiftness in 10.0 ** draw.uniform(4, 6, 5)]


def angles(draw):
    some = [*draw.uniform(0.1, 1.5, 6), math.pi / 2, math.pi / 4, math.pi / 3, 1.0, 0.01]
    return [given(angle).on("a random angle") for angle in some]


def picture(draw):
    """Visibly no straight line, and no parabola: some terminal speeds; 401 samples."""
    known, angle = parameters(draw), draw.uniform(0.5, 1.2)
    speed = draw.uniform(1.5, 5) * known["mass"] * known["gravity"] / known["drag"]
    duration = max(2.5 * known["mass"] / known["drag"], 1.2 * right.flight_time(speed, angle, **known))
    return given(np.linspace(0.0, duration, 401), speed, angle, **known)
