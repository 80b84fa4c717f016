"""Hidden inputs of hw04: random springs and starts, plain ones, and ellipses of every kind."""

import itertools
import math
from collections.abc import Callable

import numpy as np

from tam570_grader import KEPT, SOME_TIMES, Case, repeated_calls, uneven

from .reference import Z, centre, rate_of

X, Y = np.eye(3)[:2]
ONES = {"mass": 1.0, "stiffness": 1.0, "gravity": 1.0}
PLAIN: dict[str, Callable[..., tuple[object, object]]] = {
    "at rest": lambda r, v, centre: (r, 0 * v),
    "at the origin": lambda r, v, centre: (0 * r, v),
    "at rest at the origin": lambda r, v, centre: (0 * r, 0 * v),
    "at the place of rest": lambda r, v, centre: (centre, v),
    "above the origin, going up": lambda r, v, centre: (abs(r) * Z, abs(v) * Z),
    "below the origin, going down": lambda r, v, centre: (-abs(r) * Z, -abs(v) * Z),
    "level with the origin": lambda r, v, centre: (r * (1 - Z), v * (1 - Z)),
    "in the plane y = 0": lambda r, v, centre: (r * [1, 0, 1], v * [1, 0, 1]),
}  # {label: start(random position, random velocity, equilibrium) -> position, velocity}
C, S = math.cos(1.0), math.sin(1.0)  # cos and sin of 1 rad, for points of an ellipse with semi-axes a X and b Y
# {label: (position from the equilibrium, velocity), for ONES}; the last are clearly no circle, or not along the axes
ABOUT_REST = {
    "a circle": [(X, Y), (Z, X)],
    "a general ellipse": [(2 * X, Y), (X, 2 * Y)],
    "a thin ellipse": [(C * X + 1e-2 * S * Y, 1e-2 * C * Y - S * X)],
    "an ellipse that is nearly a circle": [(1.003 * C * X + 0.997 * S * Y, 0.997 * C * Y - 1.003 * S * X)],
    "radii of equal length, not along the axes": [(2 * X, math.sqrt(2) * (X + Y))],
    "radii that are nearly axes": [(2 * X, 5e-4 * X + Y)],
}
PLAIN_VIEWS = {
    "along x": (0.0, 0.0),
    "along y": (math.pi / 2, 0.0),
    "along y, from behind": (-math.pi / 2, 0.0),
    "along x, from behind": (math.pi, 0.0),
    "from straight above": (0.0, math.pi / 2),
    "from straight below": (0.0, -math.pi / 2),
    "from straight above, turned": (1.0, math.pi / 2),
    "from above the x axis": (0.0, 1.0),
    "from the level of the origin": (1.0, 0.0),
    "from beyond straight above": (1.0, 2.0),
}


def spring(rng, gravity=None):
    """Return a random mass, stiffness and gravity; the weight stretches the spring by 0.2 to 5 m."""
    stiffness, sag = 10 ** rng.uniform(-0.3, 1.3), rng.uniform(0.2, 5.0)
    strength = rng.uniform(2.0, 25.0) if gravity is None else gravity
    mass = 10 ** rng.uniform(-0.5, 0.5) if gravity == 0 else stiffness * sag / strength
    return {"mass": mass, "stiffness": stiffness, "gravity": strength}


def random(rng, gravity=None, label="a random start"):
    """Return (position, velocity, **spring), with position and velocity of similar importance."""
    parameters = spring(rng, gravity)
    position, velocity = rng.normal(size=(2, 3)) * rng.uniform(1, 3, (2, 1))
    return Case(position, rate_of(**parameters) * velocity, **parameters).labelled(label)


WEIGHTLESS = ("at rest", "at rest at the origin", "in the plane y = 0")


def plain(rng):
    """Yield positions and velocities with zeros, with gravity and without; integers."""
    for label, start in PLAIN.items():
        for gravity in (None, 0.0) if label in WEIGHTLESS else (None,):
            case, weight = random(rng, gravity), "" if gravity is None else ", without gravity"
            yield case.replace(*start(*case.args, centre(**case.kwargs))).labelled(f"a mass {label}{weight}")
    yield Case(np.array([1.0, -1.0, 2.0]), np.array([-1.0, 1.0, 1.0]), **ONES).labelled("whole numbers")


def small(rng):
    """Return a tiny motion about the origin, without gravity; np.allclose takes 1e-8 for zero, also for speeds."""
    case = random(rng, 0.0, "a very small motion")
    return case.replace(*(1e-11 * vector for vector in case.args))


def states(rng):
    cases = [*(random(rng, gravity) for gravity in (None, None, None, 0.0)), *plain(rng), small(rng)]
    return [Case(np.hstack(case.args), **case.kwargs).labelled(case.label) for case in cases]


def states_at_times(rng):
    return [case.with_leading(rng.uniform(-5, 5)) for case in states(rng)]


def period(case):
    return 2 * math.pi / rate_of(**case.kwargs)


def motions(periods, label, first=None, gravities=(None,), count=12):
    """Return a function for random starts at uneven times, from `first`, in periods; default: any time but zero."""

    def cases(rng):
        for gravity in gravities:
            case = random(rng, gravity)
            start = None if first is None else first * period(case)
            yield case.with_leading(uneven(rng, periods * period(case), count, start)).labelled(label)

    return cases


moving = motions(1.2, "uneven times, t[0] not 0", gravities=(None, 0.0))
many_periods = motions(5.2, "five periods, t[0] not 0", 0.4, count=20)


def at_two_times(rng):
    """Yield the plain cases at two times."""
    for case in plain(rng):
        t = np.array([0.0, rng.uniform(0.3, 1.3) * period(case)])
        yield case.with_leading(t).labelled(f"two times, {case.label}")


def few_times(rng):
    """Return rest at the origin, and a motion with changed calls."""
    return [*(case for case in at_two_times(rng) if "at rest at the origin" in case.label), *like_the_first(rng)]


def like_the_first(rng):
    """Return a motion, and the same at other times, from another start, with another spring."""
    (first,) = motions(0.7, "three times", 0.0, count=3)(rng)
    return [first, *repeated_calls(rng, first)]


def with_gravity(rng):
    yield from motions(1.7, "a random start", 0.0, gravities=(None, None))(rng)
    yield from (case for case in at_two_times(rng) if case.kwargs["gravity"])


def from_any_time(rng):
    """Yield calls of the closed form: no gravity, shifted times, a single one, descending ones, and changed calls."""
    yield from motions(1.3, "no gravity", 0.0, gravities=(0.0,))(rng)
    yield from motions(1.3, "times that do not start at 0")(rng)
    yield from (case for case in at_two_times(rng) if not case.kwargs["gravity"])
    (case,) = motions(1.3, "", 0.0)(rng)
    yield from (case.replace(case.args[0][some]).labelled(label) for label, some in SOME_TIMES.items())
    yield case.replace(case.args[0] - case.args[0][-1]).labelled("times that end at 0")
    yield small(rng).with_leading(case.args[0])
    yield from like_the_first(rng)


def stiff(rng):
    """Return two periods at 60 to 80 rad/s, which steps of 1 ms can follow, and steps of 10 ms cannot."""
    case = random(rng, label="two times, a stiff spring")
    case = case.replace(stiffness=case.kwargs["mass"] * rng.uniform(60, 80) ** 2)
    return [case.with_leading(1 + np.array([0.0, rng.uniform(2.2, 2.4) * period(case)]))]


# Ellipses


def orbits(rng):
    """Yield random ellipses and circles; those of integers, about (0, 0, -1), and with one parameter changed."""
    yield from [random(rng, gravity, "a general ellipse") for gravity in (None, None, 0.0)]
    for gravity in (None, 0.0):
        case = random(rng, gravity, "a circle")
        radius = case.args[0] - centre(**case.kwargs)
        v = np.cross(radius, rng.normal(size=3))
        v *= rate_of(**case.kwargs) * np.linalg.norm(radius) / np.linalg.norm(v)
        yield case.replace(case.args[0], v)
    yield from [Case(p - Z, v, **ONES).labelled(label) for label, starts in ABOUT_REST.items() for p, v in starts]
    ellipse = "the ellipse before with another"
    yield from [Case(2 * X - Z, Y, **{**ONES, name: 2.0}).labelled(f"{ellipse} {name}", KEPT) for name in ONES]


def flat(rng):
    """Yield ellipses that are lines or points."""
    for gravity in (None, 0.0):
        for moves in (1, 0):
            case = random(rng, gravity, "a line")
            along = rate_of(**case.kwargs) * rng.uniform(-2, 2) * (case.args[0] - centre(**case.kwargs))
            yield case.replace(case.args[0], moves * along)
        yield case.replace(centre(**case.kwargs), np.zeros(3)).labelled("a point")
    lines = (0 * X, 0 * X, "a line"), (X - Z, 0 * X, "a line"), (-Z, Y, "a line"), (-Z, 0 * X, "a point")
    yield from [Case(r, v, **ONES).labelled(label) for r, v, label in lines]


# The picture


def views(rng):
    points = itertools.cycle((np.eye(3), rng.normal(size=(2, 3))))
    for (label, view), seen in zip(PLAIN_VIEWS.items(), points, strict=False):
        yield Case(seen, *view).labelled(f"a view {label}")
    for count in (1, 5):
        points, view = rng.normal(size=(count, 3)), rng.uniform(-1, 1, 2) * (6, 1.5)
        yield Case(points, *view).labelled("random points and directions")


def drawn(rng):
    case = random(rng)
    t = np.linspace(0.0, 0.6 * period(case), 201)  # from 0, so that the closed form is as good as the simulation
    return Case(t, *case.args, rng.uniform(-3, 3), rng.uniform(0.3, 1.2), **case.kwargs)
