"""Hidden inputs of hw04: random springs and starts, plain ones, and ellipses of every kind."""

import itertools
import math

import numpy as np

from tam570_grader import SOME_TIMES, given, in_turn, uneven

from .right import Z, centre, rate_of

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
WEIGHTS = {None: "", 0.0: ", without gravity"}
PLAIN_VIEWS = {
    "along x": (0.0, 0.0),
    "along y": (math.pi / 2, 0.0),
    "along y, from behind": (-math.pi / 2, 0.0),
    "along x, from behind": (math.pi, 0.0),
    "straight above": (0.0, math.pi / 2),
    "straight below": (0.0, -math.pi / 2),
    "straight above, turned": (1.0, math.pi / 2),
    "above the x axis": (0.0, 1.0),
    "the level of the origin": (1.0, 0.0),
    "beyond straight above": (1.0, 2.0),
}


def spring(draw, gravity=None):
    """A random mass, stiffness and gravity; the spring is stretched by 0.2 to 5 m by the weight."""
    stiffness, sag = 10 ** draw.uniform(-0.3, 1.3), draw.uniform(0.2, 5.0)
    strength = draw.uniform(2.0, 25.0) if gravity is None else gravity
    mass = 10 ** draw.uniform(-0.5, 0.5) if gravity == 0 else stiffness * sag / strength
    return {"mass": mass, "stiffness": stiffness, "gravity": strength}


def start(draw, known):
    """A random position and velocity of similar importance."""
    return draw.normal(size=3) * draw.uniform(1, 3), rate_of(**known) * draw.normal(size=3) * draw.uniform(1, 3)


def random(draw, gravity=None, kind="a random start"):
    """given(position, velocity, **spring)."""
    known = spring(draw, gravity)
    return given(*start(draw, known), **known).on(kind)


def plain(draw):
    """Positions and velocities with zeros, with gravity and without; whole numbers."""
    found = []
    for (kind, place), (gravity, without) in itertools.product(PLAIN.items(), WEIGHTS.items()):
        case = random(draw, gravity)
        found.append(case.but(*place(*case.args, centre(**case.kwargs))).on(f"a mass {kind}{without}"))
    whole = given(np.array([1.0, -1.0, 2.0]), np.array([-1.0, 1.0, 1.0]), **WHOLE).on("whole numbers")
    return [*found, whole, whole.but(whole.args[0], np.zeros(3)).on("whole numbers, at rest")]


def randoms(draw, number, without=2):
    return [random(draw) for _ in range(number - without)] + [random(draw, 0.0) for _ in range(without)]


def states(draw):
    return [given(np.hstack(case.args), **case.kwargs).on(case.kind) for case in randoms(draw, 12) + plain(draw)]


def states_at_times(draw):
    return [given(draw.uniform(-5, 5), *case.args, **case.kwargs).on(case.kind) for case in states(draw)]


def period(case):
    return 2 * math.pi / rate_of(**case.kwargs)


def timed(case, t, kind=""):
    return given(np.asarray(t), *case.args, **case.kwargs).on(kind or case.kind)


def at_times(draw, number, periods, shifted, without, kind):
    """Random starts at uneven times; shifted times do not start at zero."""
    found = []
    for case in randoms(draw, number, without):
        first = draw.uniform(0.2, 0.9) * period(case) * draw.choice([-1, 1]) if shifted else 0.0
        found.append(timed(case, uneven(draw, periods * period(case), 12, first), kind))
    return found


def at_two_times(draw, shifted):
    """Of the plain cases; shifted times need not start at zero."""
    found = []
    for case in plain(draw):
        later = shifted * draw.integers(2) * draw.uniform(-1, 1) * period(case)
        t = later + np.array([0.0, draw.uniform(0.3, 1.3) * period(case)])
        found.append(timed(case, t, f"two times, {case.kind}"))
    return found


def alike(draw):
    """The same motion again, and with one argument changed at a time."""
    case = random(draw)
    first = timed(case, uneven(draw, period(case), 3, 0.0), "three times")
    return [first, *in_turn(draw, first)]


def with_gravity(draw):
    random = at_times(draw, 4, 1.7, False, 0, "a random start")
    return random + [case for case in at_two_times(draw, False) if case.kwargs["gravity"]]


def from_any_time(draw):
    """Of the closed form: without gravity, shifted times, a single one, descending ones, and nothing kept."""
    found = at_times(draw, 2, 1.3, False, 2, "no gravity")
    found += at_times(draw, 2, 1.3, True, 0, "times that do not start at 0")
    found += [case for case in at_two_times(draw, False) if not case.kwargs["gravity"]]
    (case,) = at_times(draw, 1, 1.3, False, 0, "")
    found += [case.but(case.args[0][some]).on(kind) for kind, some in SOME_TIMES.items()]
    return found + alike(draw)


def moving(draw):
    return at_times(draw, 4, 2.3, True, 1, "uneven times, t[0] not 0")


def far_apart(draw):
    return [case.but(case.args[0][[0, -1]]) for case in at_times(draw, 2, 6.4, True, 0, "two times far apart")]


def stiff(draw):
    """60 to 80 rad/s, which steps of a millisecond follow, and steps of ten milliseconds do not."""
    mass = 10 ** draw.uniform(-0.5, 0.5)
    known = {"mass": mass, "stiffness": mass * draw.uniform(60, 80) ** 2, "gravity": draw.uniform(2, 25)}
    case = given(*start(draw, known), **known)
    return [timed(case, 1 + np.array([0.0, draw.uniform(1.2, 1.4) * period(case)]), "two times, a stiff spring")]


def ten_periods(draw):
    case = random(draw)
    return [timed(case, uneven(draw, 10 * period(case), 60, 1.0), "ten periods, t[0] not 0")]


# Ellipses


def ellipses(draw):
    return [random(draw, gravity, "a general ellipse") for gravity in (None, None, None, None, 0.0, 0.0)]


def circles(draw):
    found = []
    for gravity in (None, None, 0.0, 0.0):
        case = random(draw, gravity, "a circle")
        place = case.args[0] - centre(**case.kwargs)
        v = np.cross(place, draw.normal(size=3))
        v *= rate_of(**case.kwargs) * np.linalg.norm(place) / np.linalg.norm(v)
        found.append(case.but(case.args[0], v))
    return found


def flat(draw):
    """Lines, points."""
    found = []
    for gravity in (None, 0.0):
        for moves in (1, 0):
            case = random(draw, gravity, "a line")
            along = rate_of(**case.kwargs) * draw.uniform(-2, 2) * (case.args[0] - centre(**case.kwargs))
            found.append(case.but(case.args[0], moves * along))
        found.append(case.but(centre(**case.kwargs), np.zeros(3)).on("a point"))
    x, y, rest = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]), -Z
    lines = [(0 * x, 0 * x), (rest + x, 0 * x), (rest, y)]
    found += [given(*line, **WHOLE).on("a line") for line in lines]
    return [*found, given(rest, 0 * x, **WHOLE).on("a point")]


def radii(a, b):
    """Two radii of the ellipse with these semi-axes along x and y, one where the mass is at 1 rad and the velocity."""
    c, s = math.cos(1.0), math.sin(1.0)
    return np.array([a * c, b * s, 0.0]), np.array([-a * s, b * c, 0.0])


# kind: position from the place of rest, and velocity, of WHOLE; each is far enough beyond the limits to be told
NEARLY_PLAIN = {
    "a thin ellipse": radii(1.0, 1e-2),
    "an ellipse that is nearly a circle": radii(1.003, 0.997),
    "radii of equal length, which are no axes": math.sqrt(2) * np.array([[math.sqrt(2), 0, 0], [1, 1, 0]]),
    "radii that are nearly axes": np.array([[2, 0, 0], [5e-4, 1, 0]]),
}


def plain_ellipses():
    """Of whole numbers, about (0, 0, -1): level or upright circle and ellipse."""
    x, y, rest = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]), -Z
    circle, ellipse = "a circle", "a general ellipse"
    starts = [(x, y, circle), (x, Z, circle), (2 * x, y, ellipse), (x, 2 * y, ellipse), (Z, x, circle)]
    starts += [(p, v, kind) for kind, (p, v) in NEARLY_PLAIN.items()]
    found = [given(rest + p, v, **WHOLE).on(kind) for p, v, kind in starts]
    again = "an ellipse of a start as before, with another"
    return found + [found[2].but(**{name: 2.0}).on(f"{again} {name}") for name in WHOLE]


def orbits(draw):
    return ellipses(draw) + circles(draw) + plain_ellipses()


# The picture


def views(draw):
    kind = "random points and directions"
    random = [
        given(draw.normal(size=(count, 3)), draw.uniform(-6, 6), draw.uniform(-1.5, 1.5)).on(kind)
        for count in (1, 5, 30)
    ]
    plain = [
        given(points, *view).on(f"a view from {kind}")
        for kind, view in PLAIN_VIEWS.items()
        for points in (np.eye(3), draw.normal(size=(2, 3)))
    ]
    return random + plain


def drawn(draw):
    case = random(draw)
    t = np.linspace(0.0, 0.6 * period(case), 401)
    return given(t, *case.args, draw.uniform(-3, 3), draw.uniform(0.3, 1.2), **case.kwargs)
