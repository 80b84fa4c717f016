"""Hidden inputs of hw07: random pendulums, and plain ones that tell what random ones do not."""

import itertools
import math

import numpy as np

from tam570_grader import Case, repeated_calls, uneven

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


def pendulum(rng, **fixed):
    """Random masses, lengths and gravity; unequal, and not of size one."""
    masses, lengths = 10 ** rng.uniform(-0.5, 0.7, 2), 10 ** rng.uniform(-0.4, 0.4, 2)
    return {"masses": masses, "lengths": lengths, "gravity": rng.uniform(1.5, 25.0), **fixed}


def thrown(count, label=ANY, **fixed):
    """Any angles and rates."""

    def drawn(rng):
        rates = [rng.uniform(0.5, 5, 2) * rng.choice([-1, 1], 2) for _ in range(count)]
        return [Case(rng.uniform(-5, 5, 2), rate, **pendulum(rng, **fixed)).labelled(label) for rate in rates]

    return drawn


def states(rng):
    """And others like the first: exact angles and rates, equal bars, unit bars, no gravity."""
    random = thrown(8)(rng)
    plain = _places(random[0]) + _alike(random[0])
    weightless = [case.replace(gravity=0.0).labelled(f"{case.label}, no gravity") for case in plain[:7]]
    return [*random, *plain, *_rates(random[0]), *weightless, *thrown(3, "no gravity", gravity=0.0)(rng)]


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
    return [case.replace(np.array(place)).labelled(label) for label, place in places.items()]


def _alike(case):
    equal = {name: np.full(2, case.kwargs[name][0]) for name in ("masses", "lengths")}
    bars = {f"equal {name}": {name: one} for name, one in equal.items()} | {"equal bars": equal, "all 1": UNIT}
    return [case.replace(**fixed).labelled(label) for label, fixed in bars.items()]


def _rates(case):
    (th1, th2), (om1, om2) = case.args
    paces = {"at rest": (0.0, 0.0), "om1 = 0": (0.0, om2), "om2 = 0": (om1, 0.0), "om1 = om2": (om1, om1)}
    paces["om1, om2 < 0"] = (-abs(om1), -abs(om2))
    moved = [((th1, other), pace, how) for how, pace in paces.items() for other in (th2, th1)]
    still = (((0.0, th2), "bar 1 straight down"), ((RIGHT_ANGLE, RIGHT_ANGLE), "both bars horizontal"))
    moved += [(place, (0.0, 0.0), f"{label}, at rest") for place, label in still]
    return [case.replace(np.array(place), np.array(pace)).labelled(how) for place, pace, how in moved]


def free_bars(rng):
    """(bar, theta, omega), bar 1 and bar 2."""
    return [case.with_leading(bar) for case in states(rng) for bar in (1, 2)]


def nearly_massless(rng):
    """One bar of a mass 1e-9 of the other's."""
    for name, ratio in (("lower", [1.0, 1e-9]), ("upper", [1e-9, 1.0])):
        for heavy in rng.uniform(0.5, 4, 3):
            yield from thrown(1, f"a nearly massless {name} bar", masses=heavy * np.array(ratio))(rng)


def straight_down(rng):
    """Both bars straight down, at rest and moving: nothing accelerates."""
    (case,) = thrown(1)(rng)
    still, moves = case.replace(np.zeros(2), np.zeros(2)), case.replace(np.zeros(2))
    return [still.labelled("hanging at rest"), moves.labelled("hanging straight down, moving")]


def special(rng):
    """Equal bars, no gravity, a nearly massless bar, by name."""
    (case,) = thrown(1)(rng)
    alike = _alike(case)
    weightless = [one.replace(gravity=0.0).labelled(f"{one.label}, no gravity") for one in (case, alike[2])]
    return [*alike, *weightless, *nearly_massless(rng)]


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


def motions(rng):
    """Random starts at uneven times, t[0] zero and not; plain ones at two or three times; one thing changed in turn."""
    for origin in (0.0, 2.3, -1.7):
        known = pendulum(rng)
        turns = 2 * math.pi * np.sign(origin) * np.array([1, -1])  # an angle beyond pi stays there
        t = uneven(rng, rng.uniform(4, 6) * pace(known), 40, origin)
        start = rng.uniform(-2, 2, 2) + turns, rng.uniform(-1, 1, 2) / pace(known)
        random = Case(t, *start, **known).labelled("t[0] not 0" if origin else "t[0] = 0")
        yield random
    for (label, (theta, omega, fixed)), count in itertools.product(STARTS.items(), (2, 3)):
        known = pendulum(rng, **fixed)
        times = uneven(rng, rng.uniform(1.5, 2.5) * pace(known), count, rng.uniform(-3, 3))
        yield Case(times, np.array(theta), np.array(omega) / pace(known), **known).labelled(
            f"{label}, at {count} times"
        )
    yield from repeated_calls(rng, random.replace(t[:4]))


def from_horizontal(rng):
    known = pendulum(rng, masses=rng.uniform(0.5, 2.0, 2), lengths=rng.uniform(0.7, 1.3, 2), gravity=9.81)
    t = uneven(rng, 10.0, 101, 0.0)
    return [Case(t, np.full(2, RIGHT_ANGLE), np.zeros(2), **known).labelled("a start at rest, both bars horizontal")]


def weightless(rng):
    """Moving, and at rest, without gravity."""
    (case,) = thrown(1, gravity=0.0)(rng)
    moves = case.with_leading(uneven(rng, 3.0, 40, 0.0)).labelled("a pendulum without gravity")
    still = moves.replace(moves.args[0][[0, -1]], case.args[0], np.zeros(2))
    return [moves, still.labelled("a pendulum at rest without gravity, two times")]


def tip_path(rng):
    """A call whose path goes to and fro, not from t = 0: a path from there has another end."""
    known = pendulum(rng)
    theta, omega = rng.uniform(1, 2, 2) * rng.choice([-1, 1], 2), rng.uniform(-1, 1, 2) / pace(known)
    t = (rng.choice([-1, 1]) * rng.uniform(1, 3) + np.linspace(0.0, 8.0, 601)) * pace(known)
    return Case(t, theta, omega, **known).labelled("t[0] not 0")
