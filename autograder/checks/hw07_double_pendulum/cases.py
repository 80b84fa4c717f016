"""Hidden inputs of hw07: random pendulums, and plain ones that tell what random ones do not."""

import itertools
import math

import numpy as np

from tam570_grader import given, in_turn, uneven

RIGHT_ANGLE = math.pi / 2
ANY = "a random pendulum"
UNIT = {"masses": np.ones(2), "lengths": np.ones(2), "gravity": 1.0}
PLACES = {
    "hanging straight down": (0.0, 0.0),
    "both bars horizontal": (RIGHT_ANGLE, RIGHT_ANGLE),
    "both bars upright": (math.pi, math.pi),
    "folded upwards": (0.0, math.pi),
    "angles beyond 2 pi": (7.5, 20.0),
    "negative angles beyond 2 pi": (-7.5, -20.0),
    "whole angles, negative": (-1.0, -2.0),
}


def pendulum(draw, **fixed):
    """Random masses, lengths and gravity; unequal, and not of size one."""
    masses, lengths = 10 ** draw.uniform(-0.5, 0.7, 2), 10 ** draw.uniform(-0.4, 0.4, 2)
    return {"masses": masses, "lengths": lengths, "gravity": draw.uniform(1.5, 25.0), **fixed}


def thrown(count, kind=ANY, **fixed):
    """Any angles and rates."""

    def drawn(draw):
        rates = [draw.uniform(0.5, 5, 2) * draw.choice([-1, 1], 2) for _ in range(count)]
        return [given(draw.uniform(-5, 5, 2), rate, **pendulum(draw, **fixed)).on(kind) for rate in rates]

    return drawn


def states(draw):
    """And others like the first: exact angles and rates, equal bars, unit bars, no gravity."""
    random = thrown(8)(draw)
    plain = _places(random[0]) + _alike(random[0])
    weightless = [case.but(gravity=0.0).on(f"{case.kind}, no gravity") for case in plain[:7]]
    return [*random, *plain, *_rates(random[0]), *weightless, *thrown(3, "no gravity", gravity=0.0)(draw)]


def _places(case):
    th1, th2 = case.args[0]
    places = {
        **PLACES,
        "bar 1 straight down": (0.0, th2),
        "bar 2 straight down": (th1, 0.0),
        "th1 = th2": (th1, th1),
        "th2 = -th1": (th1, -th1),
        "bars at a right angle": (th1, th1 + RIGHT_ANGLE),
        "bar 1 horizontal to the left": (-RIGHT_ANGLE, th2),
        "bars in line": (th1, th1 + math.pi),
    }
    return [case.but(np.array(place)).on(kind) for kind, place in places.items()]


def _alike(case):
    equal = {name: np.full(2, case.kwargs[name][0]) for name in ("masses", "lengths")}
    bars = {f"equal {name}": {name: one} for name, one in equal.items()} | {"equal bars": equal, "all 1": UNIT}
    return [case.but(**fixed).on(kind) for kind, fixed in bars.items()]


def _rates(case):
    (th1, th2), (om1, om2) = case.args
    paces = {"at rest": (0.0, 0.0), "om1 = 0": (0.0, om2), "om2 = 0": (om1, 0.0), "om1 = om2": (om1, om1)}
    paces["om1, om2 < 0"] = (-abs(om1), -abs(om2))
    moved = [((th1, other), pace, how) for how, pace in paces.items() for other in (th2, th1)]
    still = (((0.0, th2), "bar 1 straight down"), ((RIGHT_ANGLE, RIGHT_ANGLE), "both bars horizontal"))
    moved += [(place, (0.0, 0.0), f"{kind}, at rest") for place, kind in still]
    return [case.but(np.array(place), np.array(pace)).on(how) for place, pace, how in moved]


def free_bars(draw):
    """(bar, theta, omega), bar 1 and bar 2."""
    return [case.behind(bar) for case in states(draw) for bar in (1, 2)]


def nearly_massless(draw):
    """One bar of a mass 1e-9 of the other's."""
    for name, ratio in (("lower", [1.0, 1e-9]), ("upper", [1e-9, 1.0])):
        for heavy in draw.uniform(0.5, 4, 3):
            yield from thrown(1, f"a nearly massless {name} bar", masses=heavy * np.array(ratio))(draw)


def straight_down(draw):
    """Both bars straight down, at rest and moving: nothing accelerates."""
    (case,) = thrown(1)(draw)
    still, moves = case.but(np.zeros(2), np.zeros(2)), case.but(np.zeros(2))
    return [still.on("hanging at rest"), moves.on("hanging straight down, moving")]


def special(draw):
    """Equal bars, no gravity, a nearly massless bar, by name."""
    (case,) = thrown(1)(draw)
    alike = _alike(case)
    weightless = [one.but(gravity=0.0).on(f"{one.kind}, no gravity") for one in (case, alike[2])]
    return [*alike, *weightless, *nearly_massless(draw)]


# Motions: theta and omega over the usual rate of a motion from there
STARTS = {
    "hanging at rest": ((0.0, 0.0), (0.0, 0.0), {}),
    "a start from hanging straight down": ((0.0, 0.0), (0.8, -0.5), {}),
    "a start with bar 1 straight down": ((0.0, 1.0), (0.5, 0.0), {}),
    # more than half a turn from one time to another: angles unwrapped from row to row are off by whole turns
    "a fast start with th1 = th2, om1 = om2": ((0.3, 0.3), (4.5, 4.5), {}),
    "a start with negative angles": ((-0.5, -1.0), (0.3, 0.6), {}),
    "all 1": ((1.0, 0.0), (0.0, 1.0), UNIT),
    "equal bars": ((0.7, -1.2), (0.4, 0.6), {"masses": np.full(2, 1.7), "lengths": np.full(2, 0.6)}),
}


def pace(known):
    return math.sqrt(np.max(known["lengths"]) / known["gravity"])  # s


def motions(draw):
    """Random starts at uneven times, t[0] zero and not; plain ones at two or three times; one thing changed in turn."""
    for origin in (0.0, 2.3, -1.7):
        known = pendulum(draw)
        turns = 2 * math.pi * np.sign(origin) * np.array([1, -1])  # an angle beyond pi stays there
        t = uneven(draw, draw.uniform(4, 6) * pace(known), 40, origin)
        start = draw.uniform(-2, 2, 2) + turns, draw.uniform(-1, 1, 2) / pace(known)
        random = given(t, *start, **known).on("t[0] not 0" if origin else "t[0] = 0")
        yield random
    for (kind, (theta, omega, fixed)), count in itertools.product(STARTS.items(), (2, 3)):
        known = pendulum(draw, **fixed)
        times = uneven(draw, draw.uniform(1.5, 2.5) * pace(known), count, draw.uniform(-3, 3))
        yield given(times, np.array(theta), np.array(omega) / pace(known), **known).on(f"{kind}, at {count} times")
    yield from in_turn(draw, random.but(t[:4]))


def from_horizontal(draw):
    known = pendulum(draw, masses=draw.uniform(0.5, 2.0, 2), lengths=draw.uniform(0.7, 1.3, 2), gravity=9.81)
    t = uneven(draw, 10.0, 101, 0.0)
    return [given(t, np.full(2, RIGHT_ANGLE), np.zeros(2), **known).on("a start at rest, both bars horizontal")]


def weightless(draw):
    """Moving, and at rest, without gravity."""
    (case,) = thrown(1, gravity=0.0)(draw)
    moves = case.behind(uneven(draw, 3.0, 40, 0.0)).on("a pendulum without gravity")
    still = moves.but(moves.args[0][[0, -1]], case.args[0], np.zeros(2))
    return [moves, still.on("a pendulum at rest without gravity, two times")]


def tip_path(draw):
    """A call whose path goes to and fro, not from t = 0: a path from there has another end."""
    known = pendulum(draw)
    theta, omega = draw.uniform(1, 2, 2) * draw.choice([-1, 1], 2), draw.uniform(-1, 1, 2) / pace(known)
    t = (draw.choice([-1, 1]) * draw.uniform(1, 3) + np.linspace(0.0, 8.0, 601)) * pace(known)
    return given(t, theta, omega, **known).on("t[0] not 0")
