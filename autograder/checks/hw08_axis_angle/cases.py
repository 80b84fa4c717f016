"""Hidden inputs of hw08: axes of any length, angles of any size, and axes without a direction."""

import itertools
import math

import numpy as np

from tam570_grader import Case

Z_AXIS = Case(np.array([0.0, 0.0, 1.0]), 0.0).labelled("the z axis, no turn")
TURNS = {
    "no turn": 0.0,
    "a quarter turn": math.pi / 2,
    "a half turn": math.pi,
    "a quarter turn back": -math.pi / 2,
    "a half turn back": -math.pi,
    "a whole turn": 2 * math.pi,
}
WAYS = {"a coordinate axis": [*np.eye(3), *-np.eye(3)], "a diagonal": [np.array([1.0, 0.0, -1.0]), -np.ones(3)]}
NO_AXES = {
    "the zero axis": (0.0, 0.0, 0.0),
    "an axis with a NaN": (0.0, np.nan, 1.0),
    "an axis with minus infinity": (0.0, -np.inf, 0.0),  # code that refuses it refuses infinity, too
}
SERIES = 3e-5, 9e-5, 1e-4, 9e-4, 1e-3, 9e-3, 3e-2  # sizes at which series of one term or two are used, and lose digits


def vectors(rng):
    """Return arguments of skew."""
    random = [Case(rng.normal(size=3) * 10 ** rng.uniform(-3, 3)).labelled("a v of random numbers") for _ in range(3)]
    along = [Case(-v).labelled("a v along a coordinate axis") for v in np.eye(3)]
    return [*random, *along, Case(np.zeros(3)).labelled("a v of zeros")]


def axes(rng, count):
    """Return axes of lengths from .1 to 10, some in coordinate planes and one along a coordinate axis."""
    axes = rng.normal(size=(count, 3)) * 10 ** rng.uniform(-1, 1, (count, 1))
    axes[::3, rng.integers(3)] = 0.0
    axes[0] = np.roll([axes[0, 0] + axes[0, 1], 0.0, 0.0], rng.integers(3))
    return axes


def turns(rng):
    """Return random turns, and turns about axes that an arccos of 1 - 1e-16 takes for coordinate axes."""
    angles = rng.uniform(-4 * np.pi, 4 * np.pi, 7)
    about = [("a random axis and angle", axis) for axis in axes(rng, 5)]
    about += [("an axis 1e-8 from a coordinate axis", np.array(axis)) for axis in ((1e-8, 0.0, 1.0), (1.0, -1e-8, 0.0))]
    return [Case(axis, angle).labelled(label) for (label, axis), angle in zip(about, angles, strict=True)]


def plain_turns(rng):
    """Return no turn, quarter, half and whole turns, one about each axis of integers."""
    directions = [(axis, way) for way, axes in WAYS.items() for axis in axes]
    return [
        Case(rng.integers(1, 4) * axis, angle).labelled(f"{turn} about {way}")
        for (turn, angle), (axis, way) in zip(itertools.cycle(TURNS.items()), directions, strict=False)
    ]


def angles_by_size(rng):
    """Return {label: angles}."""
    signs = np.resize([-1, 1], len(SERIES)) * rng.choice([-1, 1])
    return {
        "an angle from 1e-12 to 3e-6": (-1e-12, 1e-9, -9e-7, 3e-6),
        "an angle from 1e-8 to 1": (*10 ** rng.uniform((-8, -4), (-4, 0)) * [1, -1], *signs * SERIES),
        "an angle next to a half turn, or a whole turn": (np.pi - 1e-9, 1e-9 - np.pi, 2 * np.pi),
        "an angle from 100 to 1e6": (*10 ** rng.uniform((2, 4), (4, 6)) * signs[:2],),
    }


def turns_by_size(rng, lengths=((1.0, ""),) * 4):
    """Return turns by each size of angle, about axes of these lengths."""
    return [
        [
            Case(size * axis, angle).labelled(label + long)
            for axis, angle in zip(axes(rng, len(angles)), angles, strict=True)
        ]
        for (size, long), (label, angles) in zip(lengths, angles_by_size(rng).items(), strict=True)
    ]


def lengths(rng):
    """Return (length, name) of axes, long and short in turn; 1e80 to the fourth overflows, 1e-85 to the fourth is 0."""
    powers = rng.uniform((80, -50, 10, -100), (100, -20, 50, -85))
    return [(10.0**power, f", a very {'long' if power > 0 else 'short'} axis") for power in powers]


def of_any_length(rng):
    n, angle = rng.normal(size=3), rng.uniform(0.5, 3)
    sizes = [*lengths(rng), ((1 + 5e-11) / np.linalg.norm(n), ", an axis that is 1 long but for 5e-11")]
    return [Case(length * n, angle).labelled(f"any angle{long}") for length, long in sizes]


def of_vectors(rng, turns):
    """Return the turns, each with a random vector to turn."""
    return [turn.with_leading(rng.normal(size=3) * 10 ** rng.uniform(-2, 2)) for turn in turns]


def vectors_by_size(rng):
    sizes = [of_vectors(rng, turns) for turns in turns_by_size(rng, lengths(rng))]
    near_unit = of_any_length(rng)[-1]
    short = near_unit.with_leading(rng.normal(size=3) * 1e-12).labelled("a very short vector")
    sizes[1] += [*of_vectors(rng, [near_unit]), short]
    return sizes


def turned_vectors(rng):
    """Return random vectors, vectors along the axis, and the zero vector."""
    random, plain = of_vectors(rng, turns(rng) + plain_turns(rng)), plain_turns(rng)
    along = [turn.with_leading(-2.0 * turn.args[0]).labelled("a vector along the axis") for turn in plain[1::3]]
    return [*random, *along, plain[1].with_leading(np.zeros(3)).labelled("the zero vector")]


def no_axes(rng):
    """Return (axis, angle): first with an axis, then with none, also for no turn."""
    angle = rng.uniform(0.5, 3)
    refused = [Case(np.array(axis), angle).labelled(label) for label, axis in NO_AXES.items()]
    still = [case.replace(case.args[0], 0.0).labelled(f"{case.label}, no turn") for case in refused[:2]]
    return [Z_AXIS, *refused, *still]


def vectors_about_no_axes(rng):
    calls = of_vectors(rng, no_axes(rng))
    return calls + [case.replace(np.zeros(3)).labelled(f"{case.label}, the zero vector") for case in calls[1:3]]
