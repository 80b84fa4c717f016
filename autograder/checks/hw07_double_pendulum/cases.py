"""Hidden inputs of hw07: random pendulums, and plain ones for mistakes that random ones do not show."""

import math

import numpy as np

from tam570_grader import Case, repeated_calls, uneven

RIGHT_ANGLE = math.pi / 2
ANY = "a random pendulum"
UNIT = {"masses": np.ones(2), "lengths": np.ones(2), "gravity": 1.0}


def pendulum(rng, **fixed):
    """Return random masses, lengths and gravity; unequal, and not of size one."""
    masses, lengths = 10 ** rng.uniform(-0.5, 0.7, 2), 10 ** rng.uniform(-0.4, 0.4, 2)
    return {"masses": masses, "lengths": lengths, "gravity": rng.uniform(1.5, 25.0), **fixed}


def thrown(rng, count, label=ANY, **fixed):
    """Return random angles and rates."""
    rates = [rng.uniform(0.5, 5, 2) * rng.choice([-1, 1], 2) for _ in range(count)]
    return [Case(rng.uniform(-5, 5, 2), rate, **pendulum(rng, **fixed)).labelled(label) for rate in rates]


def states(rng):
    """Return random states, and others like the first: exact angles and rates, equal bars, unit bars, no gravity."""
    random = thrown(rng, 3)
    plain = [*_places(random[0]), *_alike(random[0]), *_rates(random[0])]
    weightless = [case.replace(gravity=0.0).labelled(f"{case.label}, no gravity") for case in (random[1], plain[0])]
    return [*random, *plain, *weightless]


def _places(case):
    th1, th2 = case.args[0]
    places = {
        "hanging straight down": (0.0, 0.0),
        "both bars horizontal": (RIGHT_ANGLE, RIGHT_ANGLE),
        "folded upwards": (0.0, math.pi),
        "angles beyond 2 pi": (7.5, -20.0),
        "whole angles": (-1.0, -2.0),
        "th1 = th2": (th1, th1),
        "bars at a right angle": (th1, th1 + RIGHT_ANGLE),
    }
    return [case.replace(np.array(angles)).labelled(label) for label, angles in places.items()]


def _alike(case):
    equal = {name: np.full(2, case.kwargs[name][0]) for name in ("masses", "lengths")}
    bars = [case.replace(**{name: value}).labelled(f"equal {name}") for name, value in equal.items()]
    return [*bars, case.replace(**equal).labelled("equal bars"), case.replace(**UNIT).labelled("all 1")]


def _rates(case):
    (th1, th2), (om1, om2) = case.args
    states = {
        "at rest": ((th1, th2), (0.0, 0.0)),
        "om1 = 0": ((th1, th2), (0.0, om2)),
        "om2 = 0": ((th1, th2), (om1, 0.0)),
        "om1, om2 < 0": ((th1, th2), (-abs(om1), -abs(om2))),
        "th1 = th2, om1 = om2": ((th1, th1), (om1, om1)),
    }
    return [case.replace(*map(np.array, state)).labelled(label) for label, state in states.items()]


def free_bars(rng):
    """Return (bar, theta) for bar 1 and bar 2."""
    cases = thrown(rng, 3)
    cases += [*_places(cases[0]), cases[1].replace(gravity=0.0).labelled(f"{ANY}, no gravity")]
    return [case.with_leading(bar) for case in cases for bar in (1, 2)]


def nearly_massless(rng):
    """Yield pendulums in which one bar has 1e-9 of the other's mass."""
    for name, ratio in (("lower", [1.0, 1e-9]), ("upper", [1e-9, 1.0])):
        for heavy in rng.uniform(0.5, 4, 2):
            yield from thrown(rng, 1, f"a nearly massless {name} bar", masses=heavy * np.array(ratio))


def straight_down(rng):
    """Return both bars straight down, at rest and moving, where nothing accelerates."""
    (case,) = thrown(rng, 1)
    still, moves = case.replace(np.zeros(2), np.zeros(2)), case.replace(np.zeros(2))
    return [still.labelled("hanging at rest"), moves.labelled("hanging straight down, moving")]


def special(rng):
    """Return equal bars, no gravity, and a nearly massless bar, with labels."""
    (case,) = thrown(rng, 1)
    equal_bars = _alike(case)
    return [*equal_bars, equal_bars[2].replace(gravity=0.0).labelled("equal bars, no gravity"), *nearly_massless(rng)]


# Motions: {label: (theta, omega in units of the usual rate, fixed parameters, number of times)}
STARTS = {
    "hanging at rest, two times": ((0.0, 0.0), (0.0, 0.0), {}, 2),
    # more than half a turn between two times: angles unwrapped from row to row are wrong by whole turns
    "a fast start with th1 = th2, om1 = om2": ((0.3, 0.3), (4.5, 4.5), {}, 3),
    "a start with bar 1 straight down, all 1, two times": ((0.0, 1.0), (0.0, 1.0), UNIT, 2),
}


def pace(pendulum):
    return math.sqrt(np.max(pendulum["lengths"]) / pendulum["gravity"])  # s


def motions(rng):
    """Yield a random start at uneven times, t[0] above zero; plain ones at two or three times; and changed calls."""
    bars, origin = pendulum(rng), rng.uniform(1.5, 2.5)
    turns = 2 * math.pi * rng.permutation([1, -1])  # an angle beyond pi must not be wrapped
    t = uneven(rng, rng.uniform(3, 4) * pace(bars), 9, origin)
    start = rng.uniform(-2, 2, 2) + turns, rng.uniform(-1, 1, 2) / pace(bars)
    yield Case(t, *start, **bars).labelled("t[0] not 0")
    for label, (theta, omega, fixed, count) in STARTS.items():
        bars = fixed or bars
        times = uneven(rng, rng.uniform(1.5, 1.8) * pace(bars), count, rng.uniform(-3, 3))
        case = Case(times, np.array(theta), np.array(omega) / pace(bars), **bars).labelled(label)
        yield case
        if count == 3:
            yield from repeated_calls(rng, case)


def from_horizontal(rng):
    bars = pendulum(rng, masses=rng.uniform(0.5, 2.0, 2), lengths=rng.uniform(2.5, 4.0, 2), gravity=9.81)
    t = uneven(rng, 10.0, 13, 0.0)
    return [Case(t, np.full(2, RIGHT_ANGLE), np.zeros(2), **bars).labelled("a start at rest, both bars horizontal")]


def weightless(rng):
    """Return a motion, and rest, without gravity."""
    (case,) = thrown(rng, 1, gravity=0.0)
    moves = case.with_leading(uneven(rng, 1.5, 8, 0.0)).labelled("a pendulum without gravity")
    still = moves.replace(moves.args[0][[0, -1]], case.args[0], np.zeros(2))
    return [moves, still.labelled("a pendulum at rest without gravity, two times")]


def tip_path(rng):
    """Return a call whose path goes to and fro, not from t = 0, from where the path has another end."""
    bars = pendulum(rng)
    theta, omega = rng.uniform(1, 2, 2) * rng.choice([-1, 1], 2), rng.uniform(-1, 1, 2) / pace(bars)
    t = (rng.choice([-1, 1]) * rng.uniform(1, 3) + np.linspace(0.0, 2.0, 134)) * pace(bars)
    return Case(t, theta, omega, **bars).labelled("t[0] not 0")
