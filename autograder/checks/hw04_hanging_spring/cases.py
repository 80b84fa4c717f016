"""Hidden inputs of hw04: random springs and starts, plain ones, and ellipses of every kind."""

import itertools
import math

import numpy as np

from tam570_grader import SOME_TIMES, given, in_turn, uneven

from .right import Z, centre, rate_of

X, Y = np.eye(3)[:2]
WHOLE = {"mass": 1.0, "stiffness": 1.0, "gravity": 1.0}
PLAIN = {
    "at rest": lambda r, v, centre: (r, 0 * v),
    "at the origin": lambda r, v, centre: (0 * r, v),
    "at rest at the origin": lambda r, v, centre: (0 * r, 0 * v),
    "at the place of rest": lambda r, v, centre: (centre, v),
    "above the origin, going up": lambda r, v, centre: (abs(r) * Z, abs(v) * Z),
    "below the origin, going down": lambda r, v, centre: (-abs(r) * Z, -abs(v) * Z),
    "level with the origin": lambda r, v, centre: (r * (1 - Z), v * (1 - Z)),
    "in the plane y = 0": lambda r, v, centre: (r * [1, 0, 1], v * [1, 0, 1]),
}  # kind: the position and velocity, of random ones and the place of rest
C, S = math.cos(1.0), math.sin(1.0)  # radii a X and b Y, and those where the mass is at 1 rad
# kind: positions from the place of rest, and velocities, of WHOLE; the last kinds are far enough off to be told
ABOUT_REST = {
    "a circle": [(X, Y), (X, Z), (Z, X)],
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


def spring(draw, gravity=None):
    """A random mass, stiffness and gravity; the spring is stretched by 0.2 to 5 m by the weight."""
    stiffness, sag = 10 ** draw.uniform(-0.3, 1.3), draw.uniform(0.2, 5.0)
    strength = draw.uniform(2.0, 25.0) if gravity is None else gravity
    mass = 10 ** draw.uniform(-0.5, 0.5) if gravity == 0 else stiffness * sag / strength
    return {"mass": mass, "stiffness": stiffness, "gravity": strength}


def random(draw, gravity=None, kind="a random start"):
    """given(position, velocity, **spring), both of similar importance."""
    known = spring(draw, gravity)
    position, velocity = draw.normal(size=(2, 3)) * draw.uniform(1, 3, (2, 1))
    return given(position, rate_of(**known) * velocity, **known).on(kind)


def plain(draw):
    """Positions and velocities with zeros, with gravity and without; whole numbers."""
    for (kind, place), gravity in itertools.product(PLAIN.items(), (None, 0.0)):
        case = random(draw, gravity)
        weight = "" if gravity is None else ", without gravity"
        yield case.but(*place(*case.args, centre(**case.kwargs))).on(f"a mass {kind}{weight}")
    whole = given(np.array([1.0, -1.0, 2.0]), np.array([-1.0, 1.0, 1.0]), **WHOLE).on("whole numbers")
    yield from (whole, whole.but(whole.args[0], np.zeros(3)).on("whole numbers, at rest"))


def small(draw):
    """About the origin, without gravity; np.allclose takes 1e-9 for zero."""
    case = random(draw, 0.0, "a very small motion")
    return case.but(*(1e-9 * one for one in case.args))


def states(draw):
    cases = [*(random(draw, gravity) for gravity in [None] * 10 + [0.0] * 2), *plain(draw), small(draw)]
    return [given(np.hstack(case.args), **case.kwargs).on(case.kind) for case in cases]


def states_at_times(draw):
    return [case.behind(draw.uniform(-5, 5)) for case in states(draw)]


def period(case):
    return 2 * math.pi / rate_of(**case.kwargs)


def motions(periods, kind, first=None, gravities=(None,), count=12):
    """Random starts at uneven times, the first of which is not zero unless that is said."""

    def drawn(draw):
        for gravity in gravities:
            case = random(draw, gravity)
            yield case.behind(uneven(draw, periods * period(case), count, first)).on(kind)

    return drawn


moving = motions(2.3, "uneven times, t[0] not 0", gravities=(None, None, None, 0.0))
far_apart = motions(6.4, "two times far apart", gravities=(None, None), count=2)
ten_periods = motions(10, "ten periods, t[0] not 0", 1.0, count=60)


def at_two_times(draw):
    """Of the plain cases."""
    for case in plain(draw):
        yield case.behind(np.array([0.0, draw.uniform(0.3, 1.3) * period(case)])).on(f"two times, {case.kind}")


def alike(draw):
    """The same motion again, and with one argument changed at a time."""
    (first,) = motions(1, "three times", 0.0, count=3)(draw)
    return [first, *in_turn(draw, first)]


def with_gravity(draw):
    yield from motions(1.7, "a random start", 0.0, gravities=(None,) * 4)(draw)
    yield from (case for case in at_two_times(draw) if case.kwargs["gravity"])


def from_any_time(draw):
    """Of the closed form: without gravity, shifted times, a single one, descending ones, and nothing kept."""
    yield from motions(1.3, "no gravity", 0.0, gravities=(0.0, 0.0))(draw)
    yield from motions(1.3, "times that do not start at 0", gravities=(None, None))(draw)
    yield from (case for case in at_two_times(draw) if not case.kwargs["gravity"])
    (case,) = motions(1.3, "", 0.0)(draw)
    yield from (case.but(case.args[0][some]).on(kind) for kind, some in SOME_TIMES.items())
    yield case.but(case.args[0] - case.args[0][-1]).on("times that end at 0")
    yield small(draw).behind(case.args[0])
    yield from alike(draw)


def stiff(draw):
    """60 to 80 rad/s, which steps of a millisecond follow, and steps of ten milliseconds do not."""
    case = random(draw, kind="two times, a stiff spring")
    case = case.but(stiffness=case.kwargs["mass"] * draw.uniform(60, 80) ** 2)
    return [case.behind(1 + np.array([0.0, draw.uniform(1.2, 1.4) * period(case)]))]


# Ellipses


def orbits(draw):
    """Random ellipses and circles; those of whole numbers, about (0, 0, -1), and with one parameter changed."""
    yield from [random(draw, gravity, "a general ellipse") for gravity in (None, None, None, None, 0.0, 0.0)]
    for gravity in (None, None, 0.0, 0.0):
        case = random(draw, gravity, "a circle")
        place = case.args[0] - centre(**case.kwargs)
        v = np.cross(place, draw.normal(size=3))
        v *= rate_of(**case.kwargs) * np.linalg.norm(place) / np.linalg.norm(v)
        yield case.but(case.args[0], v)
    yield from [given(p - Z, v, **WHOLE).on(kind) for kind, starts in ABOUT_REST.items() for p, v in starts]
    again = "the ellipse before with another"
    yield from [given(2 * X - Z, Y, **{**WHOLE, name: 2.0}).on(f"{again} {name}") for name in WHOLE]


def flat(draw):
    """Lines, points."""
    for gravity in (None, 0.0):
        for moves in (1, 0):
            case = random(draw, gravity, "a line")
            along = rate_of(**case.kwargs) * draw.uniform(-2, 2) * (case.args[0] - centre(**case.kwargs))
            yield case.but(case.args[0], moves * along)
        yield case.but(centre(**case.kwargs), np.zeros(3)).on("a point")
    lines = (0 * X, 0 * X, "a line"), (X - Z, 0 * X, "a line"), (-Z, Y, "a line"), (-Z, 0 * X, "a point")
    yield from [given(r, v, **WHOLE).on(kind) for r, v, kind in lines]


# The picture


def views(draw):
    for kind, view in PLAIN_VIEWS.items():
        yield from [given(points, *view).on(f"a view {kind}") for points in (np.eye(3), draw.normal(size=(2, 3)))]
    for count in (1, 5, 30):
        points, view = draw.normal(size=(count, 3)), draw.uniform(-1, 1, 2) * (6, 1.5)
        yield given(points, *view).on("random points and directions")


def drawn(draw):
    case = random(draw)
    t = draw.choice([-1, 1]) * draw.uniform(0.3, 1) * period(case) + np.linspace(0.0, 0.6 * period(case), 401)
    return given(t, *case.args, draw.uniform(-3, 3), draw.uniform(0.3, 1.2), **case.kwargs)
