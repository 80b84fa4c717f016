"""Hidden inputs of hw07: random pendulums, and plain ones that tell what random ones do not."""

import itertools
import math

import numpy as np

from tam570_grader import given, in_turn, once, uneven

RIGHT_ANGLE = math.pi / 2
ANY = "random angles, masses and lengths"
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


def pendulum(draw, *names, **fixed):
    """Random masses, lengths and gravity, those of these names; unequal, and not of size one."""
    known = {
        "masses": 10 ** draw.uniform(-0.5, 0.7, 2),
        "lengths": 10 ** draw.uniform(-0.4, 0.4, 2),
        "gravity": draw.uniform(1.5, 25.0),
        **fixed,
    }
    return {name: known[name] for name in names or known}


def angles(draw):
    return draw.uniform(-5, 5, 2)


def thrown(draw, n, *names, **fixed):
    rates = [draw.uniform(0.5, 5, 2) * draw.choice([-1, 1], 2) for _ in range(n)]
    return [given(angles(draw), rate, **pendulum(draw, *names, **fixed)).on(ANY) for rate in rates]


def moving(draw, n, *names):
    return with_plain(thrown(draw, n, *names))


def with_weightless(draw, n):
    return with_plain(thrown(draw, n) + thrown(draw, 3, gravity=0.0))


def resting(draw, n, *names):
    return with_plain([given(angles(draw), **pendulum(draw, *names)).on(ANY) for _ in range(n)])


def pendulums(draw):
    return [given(**pendulum(draw)).on("random masses and lengths") for _ in range(10)]


def with_plain(cases):
    """The cases, and others like the first: exact angles and rates, equal bars, unit bars, no gravity."""
    first = cases[0]
    (th1, th2), omega, known = first.args[0], first.args[1:], first.kwargs
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
    plain = [first.but(np.array(place)).on(kind) for kind, place in places.items()]
    plain += [first.but(**bars).on(kind) for kind, bars in _alike(known).items()]
    if omega:
        plain += _rates(first, {kind: np.array(place) for kind, place in places.items()})
        plain += [case.but(gravity=0.0).on(f"{case.kind}, no gravity") for case in plain[:7] if "gravity" in known]
    return [*cases, *plain]


def _alike(known):
    alike = {"equal masses": {"masses"}, "equal lengths": {"lengths"}, "equal bars": {"masses", "lengths"}}
    equal = {kind: {name: np.full(2, known[name][0]) for name in names & known.keys()} for kind, names in alike.items()}
    return {**equal, "masses, lengths and gravity 1": {name: UNIT[name] for name in known}}


def _rates(first, places):
    theta, (om1, om2) = first.args
    paces = {"at rest": (0.0, 0.0), "om1 = 0": (0.0, om2), "om2 = 0": (om1, 0.0), "om1 = om2": (om1, om1)}
    paces["om1, om2 < 0"] = (-abs(om1), -abs(om2))
    in_line = np.full(2, theta[0])
    moved = [(place, pace, how) for how, pace in paces.items() for place in (theta, in_line)]
    still = [(places[kind], (0.0, 0.0), f"{kind}, at rest") for kind in ("bar 1 straight down", "both bars horizontal")]
    return [first.but(place, np.array(pace)).on(how) for place, pace, how in moved + still]


def nearly_massless(draw):
    """One bar of a mass 1e-9 of the other's."""
    cases = []
    for name, ratio in (("lower", [1.0, 1e-9]), ("upper", [1e-9, 1.0])):
        for _ in range(3):
            (case,) = thrown(draw, 1, masses=draw.uniform(0.5, 4) * np.array(ratio))
            cases.append(case.on(f"a nearly massless {name} bar"))
    return cases


def straight_down(draw):
    """Both bars straight down, at rest and moving: nothing accelerates."""
    (case,) = thrown(draw, 1)
    still, moves = case.but(np.zeros(2), np.zeros(2)), case.but(np.zeros(2))
    return [still.on("hanging at rest"), moves.on("hanging straight down, moving")]


def special(draw):
    """Equal bars, a nearly massless bar, no gravity, by name."""
    length, heavy = draw.uniform(0.5, 2), draw.uniform(0.5, 2)
    equal = {"masses": np.full(2, heavy), "lengths": np.full(2, length)}
    kinds = {
        "equal bars": equal,
        "equal masses": {"masses": equal["masses"]},
        "equal lengths": {"lengths": equal["lengths"]},
        "masses, lengths and gravity 1": UNIT,
        "equal bars, no gravity": {**equal, "gravity": 0.0},
        "a nearly massless lower bar": {"masses": heavy * np.array([1, 1e-9]), "lengths": length * np.array([1, 1.6])},
        "a nearly massless upper bar": {"masses": heavy * np.array([1e-9, 1.0])},
        "no gravity": {"gravity": 0.0},
    }
    return [given(**pendulum(draw, **fixed)).on(kind) for kind, fixed in kinds.items()]


# Motions: theta and omega over the usual rate of a motion from there
STARTS = {
    "hanging at rest": ((0.0, 0.0), (0.0, 0.0), {}),
    "a start from hanging straight down": ((0.0, 0.0), (0.8, -0.5), {}),
    "a start with bar 1 straight down": ((0.0, 1.0), (0.5, 0.0), {}),
    # more than half a turn from one time to another: angles unwrapped from row to row are off by whole turns
    "a fast start with th1 = th2, om1 = om2": ((0.3, 0.3), (4.5, 4.5), {}),
    "a start with negative angles": ((-0.5, -1.0), (0.3, 0.6), {}),
    "masses, lengths and gravity 1": ((1.0, 0.0), (0.0, 1.0), UNIT),
    "equal bars": ((0.7, -1.2), (0.4, 0.6), {"masses": np.full(2, 1.7), "lengths": np.full(2, 0.6)}),
}


def pace(known):
    return math.sqrt(np.max(known["lengths"]) / known["gravity"])  # s


def motions(draw):
    """Random starts at uneven times, t[0] zero and not; plain ones at two or three times; one thing changed in turn."""
    cases = []
    for origin in (0.0, 2.3, -1.7):
        known = pendulum(draw)
        turns = 2 * math.pi * np.sign(origin) * np.array([1, -1])  # an angle beyond pi stays there
        t = uneven(draw, draw.uniform(4, 6) * pace(known), 40, origin)
        start = draw.uniform(-2, 2, 2) + turns, draw.uniform(-1, 1, 2) / pace(known)
        cases.append(given(t, *start, **known).on("t[0] = 0" if origin == 0 else "t[0] not 0"))
    first = cases[-1]
    return cases + plain_motions(draw) + in_turn(draw, first.but(first.args[0][:4]))


def plain_motions(draw):
    cases = []
    for (kind, (theta, omega, fixed)), count in itertools.product(STARTS.items(), (2, 3)):
        known = pendulum(draw, **fixed)
        t = uneven(draw, draw.uniform(1.5, 2.5) * pace(known), count, draw.uniform(-3, 3))
        start = np.array(theta), np.array(omega) / pace(known)
        cases.append(given(t, *start, **known).on(f"{kind}, {count} times"))
    return cases


def from_horizontal(draw):
    known = pendulum(draw, masses=draw.uniform(0.5, 2.0, 2), lengths=draw.uniform(0.7, 1.3, 2), gravity=9.81)
    t = uneven(draw, 10.0, 101, 0.0)
    return [given(t, np.full(2, RIGHT_ANGLE), np.zeros(2), **known).on("a start at rest, both bars horizontal")]


def weightless(draw):
    """Moving, and at rest, without gravity."""
    (call,) = thrown(draw, 1, gravity=0.0)
    moves = given(uneven(draw, 3.0, 40, 0.0), *call.args, **call.kwargs).on("a pendulum without gravity")
    still = moves.but(moves.args[0][[0, -1]], call.args[0], np.zeros(2))
    return [moves, still.on("a pendulum at rest without gravity, two times")]


@once
def tip_path(draw):
    """A call whose path goes to and fro, not from t = 0: a path from there has another end."""
    known = pendulum(draw)
    theta, omega = draw.uniform(1, 2, 2) * draw.choice([-1, 1], 2), draw.uniform(-1, 1, 2) / pace(known)
    t = (draw.choice([-1, 1]) * draw.uniform(1, 3) + np.linspace(0.0, 8.0, 601)) * pace(known)
    return given(t, theta, omega, **known).on("t[0] not 0")
