"""Hidden inputs of hw01: random pendulums, and plain ones for mistakes that random ones do not show."""

import math

import numpy as np

from tam570_grader import KEPT, SOME_TIMES, Case, in_symbols, repeated_calls, uneven

from . import reference

ANY = "a random pendulum"
WEAK = 0.05  # gravity, m/s^2
SYMBOLS = ("theta", "omega", "m", "l", "g")
PLAIN = {0.0: "at the bottom", -math.pi / 2: "level with the hinge", math.pi: "at the top"}  # {angle: its label}


def rod(rng, gravity=None):
    return {"length": 10 ** rng.uniform(-0.6, 0.8), "gravity": rng.uniform(1.0, 25.0) if gravity is None else gravity}


def parameters(rng, gravity=None):
    return {"mass": 10 ** rng.uniform(-1, 1), **rod(rng, gravity)}


def rate_of(rod):
    """Return the rate of small motions, rad/s."""
    return math.sqrt(rod["gravity"] / rod["length"])


def describe(theta, omega, gravity):
    parts = "a pendulum", "" if omega else "at rest", PLAIN.get(theta, "")
    label = " ".join(filter(None, parts)) if any(parts[1:]) else ANY
    return label if gravity else f"{label}, without gravity"


def label(cases):
    return [case.labelled(describe(case.args[0], case.args[1], case.kwargs["gravity"])) for case in cases]


def states(rng):
    """Return random states with gravity, weak gravity and none; named angles with a speed of either sign; integers."""
    cases = [
        Case(rng.uniform(-9, 9), rng.uniform(1, 6) * rng.choice([-1, 1]), **parameters(rng, gravity))
        for gravity in (None, None, None, WEAK, 0.0)
    ]
    speed = abs(cases[0].args[1])
    plain = [cases[0].replace(angle, sign * speed) for angle, sign in zip(PLAIN, (1, 1, -1), strict=True)]
    return label([*cases, *plain, Case(-1.0, 2.0, mass=1.0, length=1.0, gravity=1.0)])


def at_rest(rng):
    """Return rest at random and at named angles; with gravity and without."""
    angles = rng.uniform(0.3, 2.8), rng.uniform(-2.8, -0.3), *PLAIN
    cases = [Case(angle, 0.0, **parameters(rng)) for angle in angles]
    return label([*cases, Case(rng.uniform(-2.8, 2.8), 0.0, **parameters(rng, gravity=0.0))])


def symbols(rng):
    """Return some of these values for symbols; each takes as long as ten calls with numbers."""
    return in_symbols(states(rng)[::2] + at_rest(rng)[::2], *SYMBOLS)


# Motions


def swing(rng, gravity=None):
    """Return a start that swings back and forth far from small angles, and its pendulum."""
    pendulum, sign = rod(rng, gravity), rng.choice([-1, 1], 2)
    return (rng.uniform(1.2, 2.2) * sign[0], rng.uniform(0.2, 0.6) * rate_of(pendulum) * sign[1]), pendulum


def turning(rng):
    """Return a start a little beyond a full turn, and a short rod that goes over the top: g/l is not near g l."""
    pendulum, sign = {**rod(rng), "length": rng.uniform(0.25, 0.6)}, rng.choice([-1, 1])
    return (-sign * rng.uniform(6.5, 7.3), sign * rng.uniform(2.3, 3) * rate_of(pendulum)), pendulum


def quick(rng):
    """Return a small swing of a rod of millimetres, at 35 to 45 rad/s: steps of 1 ms can follow it, of 10 ms cannot.

    In a period the linear motion lags by 6 A^3/16, which is 6e-4 rad or more.
    """
    rate, sign = rng.uniform(35, 45), rng.choice([-1, 1], 2)
    length = rng.uniform(6e-3, 9e-3)
    return rng.uniform(0.085, 0.095, 2) * [1, rate] * sign, {"length": length, "gravity": rate**2 * length}


def motion(rng, start, turns, count, label):
    """Return a motion that lasts `turns` divided by the rate of small motions."""
    state, pendulum = start(rng)
    return Case(uneven(rng, turns / rate_of(pendulum), count), *state, **pendulum).labelled(label)


def motions(*settings):
    return lambda rng: [motion(rng, *settings)]


large_swings = motions(swing, 10, 60, "a large swing, t[0] not 0")
many_periods = motions(swing, 40, 40, "many periods")


def few_times(rng):
    """Return a small swing at a few times, and large ones that must not depend on the times or on earlier calls."""
    first = motion(rng, quick, 6, 4, "a small swing, few times, a rod of few millimetres")
    level = math.copysign(math.pi / 2, first.args[1]), 0.0  # let go level with the hinge
    return [first, *repeated_calls(rng, first, start=level)]


def over_the_top(rng):
    """Return full turns in either sense: from near the bottom and, later and some turns further, from far above it."""
    turns = motion(rng, turning, 9, 40, "a pendulum that goes over the top")
    t, angle, rate = turns.args
    above = -1.2 * angle - math.copysign(6 * math.pi, angle)  # its square exceeds 4 g/l
    return [turns, turns.replace(t[:20] + 3 * (t[-1] - t[0]), above, -rate)]


def weightless(rng):
    """Return a uniform rotation from the bottom, and rest at any angle, without gravity and before t = 0."""
    t, rate = uneven(rng, 8.0, 30, -rng.uniform(9.0, 12.0)), rng.uniform(-0.4, -0.3)
    turns = Case(t, 0.0, rate, **rod(rng, gravity=0.0)).labelled("gravity 0, from the bottom")
    return [turns, turns.replace(t[:2], rng.uniform(0.5, 1), 0.0).labelled("gravity 0, at rest")]


def small_angles(rng):
    """Return arguments of the closed form with any times and starts, and with another rod or gravity."""
    (angle, rate), pendulum = swing(rng)
    t = uneven(rng, 20 / rate_of(pendulum), 50, -7 / rate_of(pendulum))
    starts = {
        "times that start before zero": (t, angle, rate),
        "two times, the first of them zero": (t[:2] - t[0], angle, rate),
        "a pendulum let go at rest": (t, -angle, 0.0),
        "an angle beyond pi": (t, 4.0, rate),
        "a pendulum that starts at the bottom": (t, 0.0, rate),
        "a pendulum at rest at the bottom": (t, 0.0, 0.0),
        **{label: (t[some], angle, rate) for label, some in SOME_TIMES.items()},
    }
    cases = [Case(*start, **pendulum).labelled(label) for label, start in starts.items()]
    others = [cases[0].replace(**{name: 1.4 * value}) for name, value in pendulum.items()]
    return cases + [case.labelled("the pendulum before with another rod or gravity", KEPT) for case in others]


# Paths


def wave(s, start, end, height):
    """Return a path over 0 <= s <= 1 that is no motion of a pendulum."""
    return start + (end - start) * s + height * np.sin(2 * np.pi * s)


def varied_paths(rng, amount):
    """Return pairs of calls, a path varied to both sides by a smooth function with zero ends, and the variation."""
    cases = []
    s = np.linspace(0, 1, 2001)
    changes = [np.sin(np.pi * s), np.sin(2 * np.pi * s) * np.exp(-s), s * (1 - s) * (2 + np.cos(5 * s))]
    starts = (swing, "a motion that swings"), (turning, "a motion that goes round"), (swing, "another path")
    for (start, label), change in zip(starts, rng.permutation(changes), strict=True):
        state, pendulum = start(rng)
        t = s * 2 * np.pi * rng.uniform(1.2, 1.5) / rate_of(pendulum)
        path = reference.simulate(t, *state, **pendulum)[:, 0]
        if label == "another path":
            path = wave(s, state[0], state[0] + rng.uniform(1, 2), rng.uniform(0.3, 0.6))
        case = Case(path, t[1], mass=10 ** rng.uniform(-1, 1), **pendulum).labelled(label)
        both = case.replace(path + amount * change), case.replace(path - amount * change)
        high, low = (reference.action(*varied.args, **varied.kwargs) for varied in both)
        cases.append((both, (high - low) / (2 * amount)))
    return cases


def paths(rng):
    """Return paths between different heights, with gravity and without."""
    s, cases = np.linspace(0, 1, 4001), []
    for share, label in ((1, "a smooth path"), (0, "a smooth path without gravity")):
        pendulum = parameters(rng)
        span = rng.uniform(3, 4) / rate_of(pendulum)
        path = wave(s, rng.uniform(-0.3, 0.3), rng.uniform(2.6, 3.4) * rng.choice([-1, 1]), rng.uniform(0.3, 0.6))
        case = Case(path, span * s[1], **pendulum).labelled(label)
        cases.append(case.replace(gravity=share * pendulum["gravity"]))
    return cases


def plain_paths(rng):
    """Return rest at any angle, the bottom and the top; uniform rotation without gravity; three samples and more."""
    cases = []
    for theta in (rng.uniform(0.3, 2.8), 0.0, math.pi):
        samples, step = 2 * int(rng.integers(200, 300)), 10 ** rng.uniform(-3, -1)
        cases.append(Case(np.full(samples, theta), step, **parameters(rng)).labelled(describe(theta, 0.0, 1.0)))
    # chords in place of arcs are of second order, too; their error (omega step)^2/12 is a tenth of the tolerance
    pendulum, omega, step = parameters(rng, gravity=0.0), rng.uniform(-3, -1), 1e-3
    for samples, few in ((5000, ""), (3, ", three samples")):
        label = f"a pendulum that turns evenly, without gravity{few}"
        cases.append(Case(omega * step * np.arange(samples), step, **pendulum).labelled(label))
    return cases


def periods(label, *edges, below=None):
    """Return a function for amplitudes between successive edges, or by these below an angle; the last rod has 1 m."""

    def drawn(rng):
        rods = [*(rod(rng) for _ in edges[2:]), {"length": 1.0, "gravity": 1.0}]
        sizes = rng.uniform(edges[:-1], edges[1:])
        amplitudes = sizes if below is None else below - sizes
        return [Case(size, **rod).labelled(f"an amplitude {label}") for size, rod in zip(amplitudes, rods, strict=True)]

    return drawn


# with amplitudes of exactly 1 and pi/2
usual_periods = periods("between 0.5 and 2 rad", 0.5, 0.9, 1, 1, 1.4, *[math.pi / 2] * 2, 2)
# the period of small angles, shorter by A^2/16, has an error of 3e-6 or more in this range
least_periods = periods("between 0.007 and 0.01 rad", 0.007, 0.0099)
small_periods = periods("between 0.01 and 0.1 rad", 0.01, 0.03, 0.1)
# There are no wider gaps, because a formula for a range of amplitudes is tried in each. The second term of the series
# has an error of 6e-6 from 0.2 rad on, the third of 1e-6 from 0.41.
smaller_periods = periods("between 0.1 and 0.5 rad", 0.1, 0.2, 0.3, 0.45, 0.5)
larger_periods = periods("between 2 and 3 rad", 2, 2.2, 2.4, 2.6, 2.8, 3.04)
next_to_top = periods("next to pi", 0.001, 0.003, 0.01, 0.03, 0.1, below=math.pi)
tiny_periods = periods("of less than 1e-4 rad", 1e-5, 2e-5, 5e-5, 1e-4)
at_the_top = periods("very close to pi", 1e-5, 3e-5, 1e-4, below=math.pi)
