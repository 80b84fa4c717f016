"""Hidden inputs of hw05."""

import math

import numpy as np

from tam570_grader import Case, repeated_calls, uneven

from .reference import on_circle

PLACES = {"the bottom": (0.0, -1.0), "the top": (0.0, 1.0), "the right": (1.0, 0.0), "the left": (-1.0, 0.0)}
UNIT = {"mass": 1.0, "length": 1.0, "gravity": 1.0}


def parameters(rng, **fixed):
    """Return a random mass, length and gravity."""
    random = {"mass": 10 ** rng.uniform(-1, 1), "length": 10 ** rng.uniform(-0.5, 0.8), "gravity": rng.uniform(2, 25)}
    return {**random, **fixed}


def states(rng):
    """Yield consistent states, moving and at rest, with gravity and without; with exact zeros at named places."""
    for label in ["a random state"] * 3 + ["a particle at rest"] * 2 + ["no gravity"] * 2:
        pendulum = parameters(rng, **({"gravity": 0.0} if label == "no gravity" else {}))
        omega = rng.uniform(1, 5) * rng.choice([-1, 1]) * (label != "a particle at rest")
        yield Case(on_circle(rng.uniform(-3, 3), omega, pendulum["length"]), **pendulum).labelled(label)
    for (where, (x, y)), sign in zip(PLACES.items(), (1, -1, 1, -1), strict=True):
        for speed, label in ((sign * rng.uniform(1, 5), "moving"), (0.0, "at rest")):
            pendulum = parameters(rng)
            state = np.array([x * pendulum["length"], y * pendulum["length"], -y * speed, x * speed])
            yield Case(state, **pendulum).labelled(f"a particle at {where}, {label}")
    at_the_right = Case(np.array([1.0, 0.0, 0.0, 1.0]), **UNIT).labelled("a particle at the right, all parameters 1")
    yield from (at_the_right, at_the_right.replace(gravity=0.0).labelled("a particle at the right, no gravity"))


def off_circle(rng):
    """Return inconsistent states, random and on an axis, on the circle and just off it; 5e-9 m from the origin."""
    states = [(rng.normal(size=4) * rng.uniform(0.5, 4), 10 ** rng.uniform(-0.5, 0.8)) for _ in range(3)]
    state, length = states[0]
    places = *PLACES.values(), (0.6, -0.8)
    velocities = *PLACES.values(), (0.0, 0.0), (0.6, 0.8)
    distances = length, length * (1 + 1e-7), length / 2, length * 20
    for i in range(12):
        position, velocity = np.array(places[i % 5]), np.array(velocities[i % 6])
        states.append((np.append(position * distances[i % 4], velocity * math.hypot(*state[2:])), length))
    # np.allclose takes these positions for zero
    states += [((*position, *state[2:]), 0.5) for position in ((3e-9, -4e-9), (0.0, 5e-9))]
    states += [(numbers, 1.0) for numbers in ((1.0, 0.0, 0.0, 1.0), (3.0, 4.0, 0.0, 0.0), (-3.0, 4.0, -3.0, 4.0))]
    return [Case(np.array(state), length=length).labelled(_where(state, length)) for state, length in states]


def _where(state, length):
    distance = math.hypot(*state[:2]) / length
    near = (0, 1e-5, "close to the origin"), (1, 1e-12, "on the circle already"), (1, 1e-6, "just off the circle")
    return "a particle " + next((label for at, limit, label in near if abs(distance - at) < limit), "off the circle")


def origin(rng):
    """Return an allowed case, then one at the origin."""
    allowed, state = Case(np.array([0.0, -2.0, 1.0, 1.0]), length=1.0), np.append([0.0, 0.0], rng.normal(size=2))
    return [allowed, Case(state, length=rng.uniform(0.5, 2)).labelled("a particle at the origin")]


# Motions


def pace(pendulum):
    return math.sqrt(pendulum["gravity"] / pendulum["length"]) or 1.0  # 1/s


def motion(rng, label, turns, count, angle, rate, **fixed):
    """Return a motion of some turns at uneven times, from an angle and a rate in sqrt(g/l) or 1/s."""
    pendulum = parameters(rng, **fixed)
    span = turns * 2 * math.pi / pace(pendulum)
    t = uneven(rng, span, count, span * rng.uniform(0.2, 0.8))
    state = on_circle(angle, rate * pace(pendulum), pendulum["length"])
    state[np.abs(state) < 1e-15 * np.abs(state).max()] = 0.0  # rounding errors of sin pi and cos pi/2
    return Case(t, state, **pendulum).labelled(label)


def with_gravity(rng):
    """Return a swing, and one change at a time; motions from exact places and next to the top, also before t = 0."""
    angle, rate = rng.uniform((0.8, 0.2), (2.2, 0.6)) * rng.choice([-1, 1], 2)
    swings = motion(rng, "a particle that swings", 0.8, 5, angle, rate)
    level = swings.kwargs["length"] * np.array([math.copysign(1.0, -angle), 0.0, 0.0, 0.0])
    top = motion(rng, "a particle moving at the top, a rod of 2 cm, t[0] < 0", 0.45, 4, math.pi, -2.5, length=0.02)
    return [
        swings,
        *repeated_calls(rng, swings, start=(level,), length=None),
        top.replace(top.args[0] - 2 * top.args[0][-1]),  # a turn takes 0.06 s or more
        # the angle from the top grows by e^5, as an error does
        motion(rng, "a particle let go at rest, close to the top, at two times", 0.7, 2, math.pi - 1e-3, 0.0),
    ]


def without_gravity(rng):
    rate = -rng.uniform(1, 4)  # clockwise, so that its sign matters; from below the hinge to above
    turns = motion(rng, "no gravity", -0.37 / rate, 12, rng.uniform(-1.0, 0.2), rate, gravity=0.0)
    still = motion(rng, "a particle at rest, no gravity, at two times", 0.5, 2, 1.0, 0.0, gravity=0.0)
    return [turns, still]


def long(rng):
    """Return a motion of 100 s, some five swings below the hinge; a linear one lags by a third of a swing at the end.

    Where g y > v^2, beside and above the hinge, errors of the steps grow by a force m (v^2 - g y)/l^2 with the given l.
    """
    angle, rate = rng.uniform((1.1, 0.2), (1.4, 0.4)) * rng.choice([-1, 1], 2)
    case = motion(rng, "a motion of 100 s", 1, 2, angle, rate, gravity=rng.uniform(0.5, 0.7), length=rng.uniform(6, 8))
    return [case.replace(np.linspace(0.0, 100.0, 18))]


def at_the_top(rng):
    pendulum = parameters(rng)
    t = np.linspace(0.0, 20 / pace(pendulum), 9)
    top = np.array([0.0, pendulum["length"], 0.0, 0.0])
    return [Case(t, top, **pendulum).labelled("a start at rest at the very top")]
