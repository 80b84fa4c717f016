"""Hidden inputs of hw12: random beads and wires, and plain ones for mistakes that random ones do not show."""

import math

import numpy as np

from tam570_grader import Case, in_symbols, repeated_calls, uneven

ANY = "a random bead and wire"
SYMBOLS = ("x", "v", "m", "c", "g")
STEEP = 25.0  # m, on a wire of 10/m: not so far that a difference of energies loses its digits
NEXT_TO_BOTTOM = 1e-5  # times 1/c: a solution that takes the wire for level there leaves a term out


def bead(rng):
    """Return a random state on a flat or a steep place."""
    curvature, gravity = 10 ** rng.uniform(-1, 1), rng.uniform(1, 25)
    x = 10 ** rng.uniform(-2, 0.6) / curvature * rng.choice([-1, 1])
    v = rng.uniform(0.4, 2) * math.sqrt(gravity / curvature) * rng.choice([-1, 1])
    mass = 10 ** rng.uniform(-1, 1)
    return Case(x, v, mass=mass, curvature=curvature, gravity=gravity).labelled(ANY)


def usual(rng):
    """Return random cases and integers; nothing is zero, where a right formula may be 0/0."""
    ones = Case(1.0, 1.0, mass=1.0, curvature=1.0, gravity=1.0).labelled(ANY)
    return [*(bead(rng) for _ in range(4)), ones, ones.replace(-1.0), ones.replace(1.0, -1.0)]


def symbols(rng):
    """Return values for symbols, two of them random; each takes as long as ten calls with numbers."""
    return in_symbols(usual(rng)[::2], *SYMBOLS)


def beads(rng):
    """Return beads at rest, at the bottom, or both; random ones; on a steep place; also without gravity."""
    cases = usual(rng)
    x, v = map(abs, cases[0].args)
    states = {
        "a bead at rest": [(x, 0.0), (-x, 0.0)],
        "a bead at the bottom": [(0.0, v), (0.0, -v)],
        "a bead at rest at the bottom": [(0.0, 0.0)],
    }
    plain = [cases[0].replace(*state).labelled(label) for label in states for state in states[label]]
    weightless = [case.replace(gravity=0.0) for case in (plain[0], plain[3], plain[4], cases[0])]
    steep = cases[0].replace(math.copysign(STEEP, cases[0].args[0]), curvature=10.0).labelled("a steep place")
    return [*plain, *cases, steep, *(case.labelled(_weighed(case.label, 0)) for case in weightless)]


def places(rng):
    """Return cases of a function of the place alone."""
    return [*beads(rng), *next_to_bottom(rng)]


def next_to_bottom(rng):
    case = bead(rng)
    small = NEXT_TO_BOTTOM / case.kwargs["curvature"]
    near = [case.replace(small), case.replace(-small, gravity=0.0)]
    return [case.labelled(_weighed("a bead next to the bottom", case.kwargs["gravity"])) for case in near]


def nearly_at_rest(rng):
    """Return a slow bead next to the bottom, whose energy is tiny, but not zero."""
    case = bead(rng)
    x, v = NEXT_TO_BOTTOM / case.kwargs["curvature"], NEXT_TO_BOTTOM * case.args[1]
    return [case.replace(x, v).labelled("a bead next to the bottom")]


def _weighed(label, gravity):
    return label if gravity else f"{label}, without gravity"


def ride(rng, low, high, count, turns, label, start=None, decade=0.7):
    """Return a motion with an amplitude of low to high, in units of 1/c, for `turns` over the rate of small motions.

    start : the place, relative to the amplitude, and the speed, relative to the largest; default: random
    """
    wire = {"curvature": 10 ** rng.uniform(-decade, decade), "gravity": rng.uniform(1, 25)}
    size, rate = rng.uniform(low, high) / wire["curvature"], math.sqrt(2 * wire["gravity"] * wire["curvature"])
    if start is None:
        angle = rng.uniform(0.5, 1.2) * rng.choice([-1, 1])
        start = math.sin(angle), math.cos(angle) * rng.choice([-1, 1])
    x = size * start[0]
    v = size * rate * start[1] / math.hypot(1, 2 * wire["curvature"] * x)
    return Case(uneven(rng, turns / rate, count), x, v, **wire).labelled(label)


def rides(*settings):
    return lambda rng: [ride(rng, *settings)]


wide = rides(0.4, 1.0, 25, 15.0, "an amplitude near 1/c")
steep = rides(5.0, 8.0, 10, 45.0, "an amplitude of several 1/c")
many_periods = rides(0.4, 1.0, 15, 50.0, "many periods")
# The linear oscillation has an error of 2e-3; an absolute tolerance of 1e-9 m makes 1e-6.
close = rides(0.02, 0.025, 2, 5.0, "two times, the bead let go at rest, close to the bottom", (1.0, 0.0), 0.3)


def few_times(rng):
    """Return three times, with most of the run and its sharp turns between two of them; two times, at rest."""
    sharp = ride(rng, 4.3, 5.0, 2, 21.0, "a few times, far apart")
    first, last = sharp.args[0]
    between = last - 1.5 / math.sqrt(2 * sharp.kwargs["gravity"] * sharp.kwargs["curvature"])
    label = "two times, a bead at rest at the bottom, where it stays"
    return [sharp.replace(np.array([first, between, last])), ride(rng, 0.4, 1.0, 2, 5.0, label, (0.0, 0.0))]


def weightless(rng):
    """Return a motion with gravity; the same at other times; from the same start, on another wire without gravity."""
    case = ride(rng, 0.4, 1.0, 5, 3.0, "an amplitude near 1/c")
    other_times, _, other_wire = repeated_calls(rng, case, gravity=0.0)
    return [case, other_times, other_wire]


def periods(label, low, high, count, decades=(-1, 1)):
    """Return a function for amplitudes in units of 1/c, by their powers of ten; decades of the curvature."""

    def case(rng):
        curvature, size = 10 ** rng.uniform(*decades), 10 ** rng.uniform(low, high)
        return Case(size / curvature, curvature=curvature, gravity=rng.uniform(1, 25)).labelled(label)

    return lambda rng: [case(rng) for _ in range(count)]


usual_periods = periods("an amplitude near 1/c", -0.7, -0.2, 4)
tiny_periods = periods("an amplitude of a hundred-thousandth of 1/c", -5, -5, 2, (0.5, 1))
small_periods = periods("an amplitude of some thousandths of 1/c", -3, -2, 2)
large_periods = periods("an amplitude of many 1/c", 1, 2, 2)
largest_period = periods("an amplitude of many 1/c", 2, 2, 1)
