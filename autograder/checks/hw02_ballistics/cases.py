"""Hidden inputs of hw02: random launches, named ones, and the limits of little and of great drag."""

import itertools
import math

import numpy as np

from tam570_grader import KEPT, SOME_TIMES, Case, repeated_calls, uneven

from . import reference

ANY = "a random launch"
LIGHT = "a light particle, whose drag is small only in kg/s"
SMALL_BESIDE = "Whether drag counts depends on c t/m or c v/(m g), not on c."
TO_ZERO = "What becomes of your formula as the drag goes to zero?"
FAR_ON = "What is left of the equation when e^-s is nothing? e^s goes beyond all numbers."
SLOW = "a speed below a tenth of the terminal speed"
ONES = {"mass": 1.0, "drag": 1.0, "gravity": 1.0}
LITTLE = 0.99 * 10.0 ** -np.arange(1, 7)  # if a series is used below a power of ten, its error is largest just below
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


def parameters(rng, **fixed):
    """Return a random mass, drag and gravity; the rate c/m is from .05 to 1.5."""
    mass = 10 ** rng.uniform(-0.7, 1)
    random = {"mass": mass, "drag": mass * 10 ** rng.uniform(-1.3, 0.2), "gravity": rng.uniform(1.5, 25)}
    return {**random, **fixed}


def light(rng):
    """Return a particle of some milligrams, with a drag that is tiny, but not relative to the weight."""
    mass = 10 ** rng.uniform(-6, -5)
    return parameters(rng, mass=mass, drag=mass * rng.uniform(0.3, 1.5))


def launch(rng):
    return 10 ** rng.uniform(0.5, 2), rng.uniform(0.15, 1.4)


# States


def states(rng):
    """Return states with velocities in any direction, named ones, integers, and a light particle."""
    cases = [
        Case(rng.uniform(-5, 5), rng.normal(size=4) * 10 ** rng.uniform(0, 2), **parameters(rng)).labelled("any state")
        for _ in range(3)
    ]
    positions = itertools.cycle((rng.normal(size=2) * 10, np.zeros(2), -np.ones(2)))
    for (label, velocity), position in zip(VELOCITIES.items(), positions, strict=False):
        state = np.append(position, np.multiply(velocity, rng.uniform(1, 9)))
        cases.append(Case(0.0, state, **parameters(rng)).labelled(label))
    ones = Case(0.0, np.array([1.0, 1.0, -1.0, 1.0]), **ONES).labelled("whole numbers")
    return [*cases, ones, Case(0.0, rng.normal(size=4) * 10, **light(rng)).labelled(LIGHT, SMALL_BESIDE)]


def states_without(rng):
    """Return states without drag or gravity, also at rest and along each axis."""
    return [
        Case(0.0, rng.normal(size=4) * moving * 10, **parameters(rng, **zero)).labelled(label)
        for (label, zero), other in zip(ZEROS.items(), ([1, 1, 0, 0], [1, 1, 0, 1], [1, 1, 1, 0]), strict=True)
        for moving in (1, other)
    ]


def without_time(rng):
    """Return the arguments of a function of the state alone."""
    return [Case(*case.args[1:], **case.kwargs).labelled(case.label) for case in states(rng) + states_without(rng)]


# Motions


def flight(rng, label, particle, start=0.0):
    """Return a launch at `start`, with times from then on, for one to three times m/c."""
    fade = particle["drag"] / particle["mass"] or 0.3
    hint = SMALL_BESIDE if label == LIGHT else ""
    return Case(uneven(rng, rng.uniform(1, 3) / fade, 30, start), *launch(rng), **particle).labelled(label, hint)


def flights(rng):
    plain = [case for case in plain_flights(rng) if case.label.endswith(("straight down", "upwards", "dropped"))]
    return [flight(rng, f"{ANY}, t[0] not 0", parameters(rng), rng.choice([-2.0, 3.7])), *plain]


def flights_from_zero(rng):
    without = flight(rng, f"{ANY} without gravity", parameters(rng, gravity=0.0))
    return [*(flight(rng, ANY, parameters(rng)) for _ in range(2)), without, *plain_flights(rng)]


def plain_flights(rng):
    """Yield launches with two times each: named directions, a drop, integers."""
    starts = [(label, launch(rng)[0], angle, parameters(rng)) for label, angle in DIRECTIONS.items()]
    starts += [("a particle dropped", 0.0, 1.0, parameters(rng)), ("whole numbers", 1.0, 1.0, ONES)]
    for label, *start, particle in starts:
        t = np.array([0.0, rng.uniform(1, 3) * particle["mass"] / particle["drag"]])
        yield Case(t, *start, **particle).labelled(f"two times, {label}")


def flights_without(rng):
    """Return launches without gravity, of a light particle, and without drag, with changed calls."""
    weightless = flight(rng, "zero gravity", parameters(rng, **ZEROS["zero gravity"]))
    return [weightless, flight(rng, LIGHT, light(rng)), *alike_flights(rng, "zero drag")]


def alike_flights(rng, label=ANY):
    """Return a launch, and the same with other times, start or parameters."""
    first = flight(rng, label, parameters(rng, **ZEROS.get(label, {})))
    t, speed, angle = first.args
    first = first.replace(t[:3])
    return [first, *repeated_calls(rng, first, start=(1.3 * speed, 0.7 * angle))]


def late_flights(rng):
    """Return launches at t = 0 with later times only; a single time, and times in descending order."""
    cases = [flight(rng, "times that do not begin at 0", parameters(rng), start) for start in (2.5, -0.5)]
    return cases + [cases[0].replace(cases[0].args[0][some]).labelled(label) for label, some in SOME_TIMES.items()]


def flights_with_any_drag(rng):
    """Return launches at t = 0 with no, little and great drag, of a light particle, and with changed calls.

    Great drag means c t/m of one or two thousand, where e^s overflows, and of 1e9, which small steps cannot reach.
    """
    cases = []
    for drag in (0.0, *10.0 ** rng.uniform((-14, -9, -7, -5), (-11, -8, -6, -2))):
        t, words = uneven(rng, rng.uniform(1, 9), 20, 0.0), ("very little drag",) if drag else ("no drag", TO_ZERO)
        cases.append(Case(t, *launch(rng), **parameters(rng, drag=drag)).labelled(*words))
    particle = parameters(rng)
    for span in (*LITTLE, rng.uniform(1000, 2000), 1e9):  # largest c t/m
        t = uneven(rng, span * particle["mass"] / particle["drag"], 20, 0.0)
        words = ("very little drag",) if span < 1 else ("great drag", FAR_ON)
        cases.append(Case(t, *launch(rng), **particle).labelled(*words))
    return [*cases, flight(rng, LIGHT, light(rng)), *alike_flights(rng)]


# Landings


def landings(rng):
    """Return random landings; straight up, at 45 degrees and nearly flat, each with drag and without; integers."""
    cases = [of_lift(rng, lift, ANY) for lift in 10.0 ** rng.uniform(-1.3, 1.3, 4)]
    angles = {"a launch straight up": math.pi / 2, "a launch at 45 degrees": math.pi / 4, "a nearly flat launch": 0.01}
    for label, angle in angles.items():
        for suffix, lift in (("", rng.uniform(0.3, 3)), (", no drag", 0.0)):
            cases.append(of_lift(rng, lift, f"{label}{suffix}", angle))
    ones = Case(1.0, 1.0, **ONES).labelled("whole numbers")
    return [*cases, ones, ones.replace(2.0, drag=0.0), ones.replace(1.0, math.pi / 2)]


def of_lift(rng, lift, label, angle=None, hint=""):
    """Return a launch with this lift, b = c vy/(m g)."""
    (speed, usual), particle = launch(rng), parameters(rng)
    angle = angle or usual
    particle["drag"] = lift * particle["mass"] * particle["gravity"] / (speed * math.sin(angle))
    return Case(speed, angle, **particle).labelled(label, hint or ("" if lift else TO_ZERO))


def landings_of_little_drag(rng):
    """Return launches with no drag, and with b below 1e-1, mostly where Lambert's W has an error of 1e-16/b^2."""
    lifts = [*10.0 ** rng.uniform((-16, -13.5), (-13.5, -8)), *LITTLE]
    lifts += [*10.0 ** ((np.arange(5) + rng.uniform(0, 1, 5)) * 0.6 - 8)]
    return [of_lift(rng, 0.0, "no drag"), *(of_lift(rng, lift, "very little drag") for lift in lifts)]


def landings_of_great_drag(rng):
    """Return b from ten to a million (e^s overflows from 709 on), launches of light particles, and changed calls."""
    great = [of_lift(rng, lift, "great drag", hint=FAR_ON) for lift in 10.0 ** rng.uniform((1, 3, 3, 4), (3, 4, 4, 6))]
    return [*great, Case(*launch(rng), **light(rng)).labelled(LIGHT, SMALL_BESIDE), *alike_landings(rng)]


def flat_landings(rng):
    """Return steep and flat launches; the last, with b = 1, takes 3e-6 s, and brentq's error of 2e-12 s passes."""
    angles = {"a launch straight up": math.pi / 2, "a nearly flat launch": 1e-3}
    cases = [of_lift(rng, rng.uniform(0.3, 3), label, angle) for label, angle in angles.items()]
    return [*cases, Case(2.0, 1e-6, mass=1.0, drag=5e5, gravity=1.0).labelled("a nearly flat launch")]


def alike_landings(rng):
    """Return a launch, and the same with each parameter changed."""
    first = of_lift(rng, rng.uniform(0.3, 3), ANY)
    others = [first.replace(**{name: 1.4 * value}) for name, value in first.kwargs.items()]
    return [first, *(case.labelled("the launch before with one parameter changed", KEPT) for case in others)]


# Speeds


def at_speed(swiftness, label, particle, hint=""):
    """Return a case with a speed in units of the terminal speed m g/c."""
    speed = swiftness * particle["mass"] * particle["gravity"] / particle["drag"]
    return Case(speed, **particle).labelled(label, hint)


def usual_speeds(rng):
    label = "a speed from a tenth to a hundred times the terminal speed"
    cases = [at_speed(swiftness, label, parameters(rng)) for swiftness in 10.0 ** rng.uniform((-1, 0, 1), (0, 1, 2))]
    return [*cases, Case(1.0, **ONES).labelled(label)]


def slow_speeds(rng):
    """Return no drag; speeds below a tenth of the terminal one; about it, light or in weak gravity; and changed calls.

    The third slow one is from .007 to .01, where a series of first order in the drag has an error of 5e-6 or more.
    """
    drags = {0.0: ("no drag", TO_ZERO), 1e-12: ("very little drag",), 1e-10: ("very little drag",)}
    cases = [Case(launch(rng)[0], **parameters(rng, drag=drag)).labelled(*words) for drag, words in drags.items()]
    for swiftness in 10.0 ** (rng.uniform(0, 1, 4) * [2, 1, 0.15, 1] - [6, 4, 2.16, 2]):
        cases.append(at_speed(swiftness, SLOW, parameters(rng)))
    weak = parameters(rng, gravity=10 ** rng.uniform(-3, -2))
    cases.append(at_speed(10 ** rng.uniform(-0.3, 0.3), LIGHT, light(rng), SMALL_BESIDE))
    cases.append(at_speed(10 ** rng.uniform(-0.3, 0.3), "a slow launch where gravity is weak", weak, SMALL_BESIDE))
    return cases + alike_landings(rng)


def huge_speeds(rng):
    """Return huge speeds; minimising finds the angle to 1e-4 up to 1e6 on a logarithmic scale, 3e5 on a linear one."""
    return [at_speed(swiftness, "a huge speed", parameters(rng)) for swiftness in 10.0 ** rng.uniform((4, 5.5), (5, 6))]


def angles(rng):
    angles = *rng.uniform(0.1, 1.5, 2), math.pi / 2, math.pi / 4, 0.01
    return [Case(angle).labelled("a random angle") for angle in angles]


def picture(rng):
    """Return a path that is visibly no straight line, and no parabola: some terminal speeds; 201 samples."""
    particle, angle = parameters(rng), rng.uniform(0.5, 1.2)
    speed = rng.uniform(1.5, 5) * particle["mass"] * particle["gravity"] / particle["drag"]
    duration = max(2.5 * particle["mass"] / particle["drag"], 1.2 * reference.flight_time(speed, angle, **particle))
    return Case(np.linspace(0.0, duration, 201), speed, angle, **particle)
