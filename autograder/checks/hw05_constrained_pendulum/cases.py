"""Hidden inputs of hw05."""

import math

import numpy as np

from tam570_grader import Case, repeated_calls, uneven

from .reference import on_circle

PLACES = {"the bottom": (0.0, -1.0), "the top": (0.0, 1.0), "the right": (1.0, 0.0), "the left": (-1.0, 0.0)}
UNIT = {"mass": 1.0, "length": 1.0, "gravity": 1.0}


def parameters(rng, **fixed):
    """A random mass, length and gravity."""
    known = {"mass": 10 ** rng.uniform(-1, 1), "length": 10 ** rng.uniform(-0.5, 0.8), "gravity": rng.uniform(2, 25)}
    return {**known, **fixed}


def states(rng):
    """Consistent states, moving and at rest, with gravity and without; of exact zeros at plain places."""
    for label in ["a random state"] * 10 + ["a particle at rest"] * 3 + ["no gravity"] * 4:
        known = parameters(rng, **({"gravity": 0.0} if label == "no gravity" else {}))
        omega = rng.uniform(1, 5) * rng.choice([-1, 1]) * (label != "a particle at rest")
        yield Case(on_circle(rng.uniform(-3, 3), omega, known["length"]), **known).labelled(label)
    for place, (x, y) in PLACES.items():
        pendulums = {"": parameters(rng), ", no gravity": parameters(rng, gravity=0.0), ", all parameters 1": UNIT}
        for rest, known in pendulums.items():
            speed = 1.0 if known is UNIT else rng.uniform(1, 5)
            for v, how in ((speed, "moving"), (-speed, "moving"), (0.0, "at rest")):
                state = np.array([x * known["length"], y * known["length"], -y * v, x * v])
                yield Case(state, **known).labelled(f"a particle at {place}, {how}{rest}")


def off_circle(rng):
    """States that are not consistent, random and on an axis, on the circle and just off it; at 1e-8 of the origin."""
    some = [(rng.normal(size=4) * rng.uniform(0.5, 4), 10 ** rng.uniform(-0.5, 0.8)) for _ in range(12)]
    state, length = some[0]
    speed = math.hypot(*state[2:])
    some += [
        ((x * far, y * far, vx * speed, vy * speed), length)
        for x, y in (*PLACES.values(), (0.6, -0.8))
        for far in (length, length * (1 + 1e-7), length / 2, length * 20)
        for vx, vy in (*PLACES.values(), (0.0, 0.0), (0.6, 0.8))
    ]
    some += [((*place, *state[2:]), 0.5) for place in ((3e-9, -4e-9), (0.0, 5e-9))]  # np.allclose takes them for zero
    whole = (1.0, 0.0, 0.0, 1.0), (0.0, -2.0, 1.0, 1.0), (3.0, 4.0, 0.0, 0.0), (-3.0, 4.0, -3.0, 4.0)
    some += [(numbers, 1.0) for numbers in whole]
    return [Case(np.array(state), length=length).labelled(_where(state, length)) for state, length in some]


def _where(state, length):
    far = math.hypot(*state[:2]) / length
    near = (0, 1e-5, "close to the origin"), (1, 1e-12, "on the circle already"), (1, 1e-6, "just off the circle")
    return "a particle " + next((where for place, limit, where in near if abs(far - place) < limit), "off the circle")


def origin(rng):
    """What is allowed first."""
    allowed, state = Case(np.array([0.0, -2.0, 1.0, 1.0]), length=1.0), np.append([0.0, 0.0], rng.normal(size=2))
    return [allowed, Case(state, length=rng.uniform(0.5, 2)).labelled("a particle at the origin")]


# Motions: kind, angle, its rate in sqrt(g/l) or 1/s, what is not random
STARTS: tuple[tuple[str, float, float, dict[str, float]], ...] = (
    ("at rest, no gravity", 1.0, 0.0, {"gravity": 0.0}),
    ("moving at the bottom, no gravity", 0.0, 1.0, {"gravity": 0.0}),
    ("let go at rest", 1.3, 0.0, {}),
    ("let go at rest, the rod horizontal", math.pi / 2, 0.0, {}),
    ("let go at rest, close to the bottom", 1e-3, 0.0, {}),
    ("let go at rest, close to the top", math.pi - 1e-3, 0.0, {}),  # it falls by e^5 times that, as an error does
    ("at rest at the bottom", 0.0, 0.0, {}),
    ("moving at the bottom", 0.0, 1.2, {}),
    ("moving at the top, a rod of 2 cm", math.pi, 2.5, {"length": 0.02}),  # once round in 0.06 s or more
    ("moving, the rod horizontal, all parameters 1", -math.pi / 2, 1.0, UNIT),
)


def pace(known):
    return math.sqrt(known["gravity"] / known["length"]) or 1.0  # 1/s


def moved(rng, label, turns, count, start, known, signs=(1,)):
    """A motion of so many turns at uneven times, which begin after t = 0, or before as well."""
    span = turns * 2 * math.pi / pace(known)
    t = uneven(rng, span, count, span * rng.uniform(0.2, 0.8) * rng.choice(signs))
    theta, omega = start
    state = on_circle(theta, omega * pace(known), known["length"])
    state[np.abs(state) < 1e-15 * np.abs(state).max()] = 0.0  # sin pi and cos pi/2
    return Case(t, state, **known).labelled(f"{label}, t[0] {'<' if t[0] < 0 else '>'} 0")


def plain(rng, weight):
    """Two or three times, from exact places, at rest or moving either way; with gravity or without."""
    for label, theta, omega, fixed in [start for start in STARTS if (start[3].get("gravity") != 0.0) == weight]:
        side = rng.choice([-1, 1])
        for count, sign in ((2, side), (3, -side)):
            known, turns = parameters(rng, **fixed), rng.uniform(0.3, 0.8)
            start = theta * sign, omega * sign
            yield moved(rng, f"a particle {label}, at {count} times", turns, count, start, known, (-1, 1))


def swinging(rng, turns, count):
    start = rng.uniform((0.8, 0.2), (2.2, 0.6)) * rng.choice([-1, 1], 2)
    return moved(rng, "a particle that swings", turns, count, start, parameters(rng))


def with_gravity(rng):
    round_the_top = rng.uniform((0, 2.3), 3) * rng.choice([-1, 1], 2)
    again, far = swinging(rng, 1.8, 5), swinging(rng, 1.8, 9)
    return [
        swinging(rng, 1.8, 9),
        moved(rng, "a particle that goes over the top", 1.8, 9, round_the_top, parameters(rng), (-1, 1)),
        *repeated_calls(rng, again, start=(again.args[1] * [-1, 1, -1, 1],), length=None),
        far.replace(far.args[0][[0, -1]]).labelled("two times far apart"),
        *plain(rng, True),
    ]


def without_gravity(rng):
    known, omega = parameters(rng, gravity=0.0), rng.uniform(1, 4) * rng.choice([-1, 1])
    return [moved(rng, "no gravity", 2.3 / abs(omega), 12, (rng.uniform(-3, 3), omega), known), *plain(rng, False)]


def long(rng):
    """About ten to twenty swings in 100 s, below the hinge.

    Where g y > v^2, beside and above it, errors of the steps grow if the force is m (v^2 - g y)/l^2 by the given l.
    """
    start = rng.uniform((0.8, 0.2), (1.2, 0.4)) * rng.choice([-1, 1], 2)
    known = parameters(rng, gravity=rng.uniform(3, 6), length=rng.uniform(3, 6))
    return [moved(rng, "100 s", 1, 2, start, known).replace(np.linspace(0.0, 100.0, 60)).labelled("a motion of 100 s")]


def at_the_top(rng):
    known = parameters(rng)
    t = np.linspace(0.0, 20 / pace(known), 9)
    return [Case(t, np.array([0.0, known["length"], 0.0, 0.0]), **known).labelled("a start at rest at the very top")]
