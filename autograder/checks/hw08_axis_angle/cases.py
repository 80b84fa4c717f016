"""Hidden inputs of hw08: axes of any length, angles of any size, and what has no direction."""

import math

import numpy as np

from tam570_grader import given

Z_AXIS = given(np.array([0.0, 0.0, 1.0]), 0.0).on("the z axis, no turn")
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
    "an infinite axis": (np.inf, 0.0, 1.0),
    "an axis with minus infinity": (0.0, -np.inf, 0.0),
}
SERIES = 3e-5, 9e-5, 1e-4, 9e-4, 1e-3, 9e-3, 3e-2  # where series of one term or two are used, and lose digits


def vectors(draw):
    """Arguments of skew."""
    random = [given(draw.normal(size=3) * 10 ** draw.uniform(-3, 3)).on("a v of random numbers") for _ in range(8)]
    along = [given(-v).on("a v along a coordinate axis") for v in np.eye(3)]
    return [*random, *along, given(np.zeros(3)).on("a v of zeros")]


def axes(draw, count):
    """Axes of lengths from .1 to 10, some in coordinate planes and one on an axis."""
    found = draw.normal(size=(count, 3)) * 10 ** draw.uniform(-1, 1, (count, 1))
    found[::3, draw.integers(3)] = 0.0
    found[0] = np.roll([found[0, 0] + found[0, 1], 0.0, 0.0], draw.integers(3))
    return found


def turns(draw):
    """Random turns; about axes next to coordinate axes, for which an arccos of what is 1 but for 1e-16 takes them."""
    angles = draw.uniform(-4 * np.pi, 4 * np.pi, 15)
    about = [("a random axis and angle", axis) for axis in axes(draw, 13)]
    about += [("an axis 1e-8 from a coordinate axis", np.array(axis)) for axis in ((1e-8, 0.0, 1.0), (1.0, -1e-8, 0.0))]
    return [given(axis, angle).on(kind) for (kind, axis), angle in zip(about, angles, strict=True)]


def plain_turns(draw):
    """No turn, quarter, half and whole turns about axes of whole numbers."""
    return [
        given(draw.integers(1, 4) * axis, angle).on(f"{turn} about {way}")
        for way, known in WAYS.items()
        for axis in known
        for turn, angle in TURNS.items()
    ]


def angles_by_size(draw):
    """Kind of angle: angles."""
    signs = draw.choice([-1, 1], 4)
    return {
        "an angle of 1e-12, 1e-9 or 3e-6": (-1e-12, 1e-12, -1e-9, 1e-9, -3e-6, 3e-6),
        "an angle from 1e-8 to 1": (*10 ** draw.uniform(-8, 0, 4) * signs, *SERIES, *(-angle for angle in SERIES)),
        "an angle next to a half turn, or a whole turn": (np.pi - 1e-9, 1e-9 - np.pi, 2 * np.pi),
        "an angle from 100 to 1e6": tuple(10 ** draw.uniform(2, 6, 4) * signs),
    }


def turns_by_size(draw, lengths=((1.0, ""),) * 4):
    """Turns for each kind of angle, about axes that are so many times as long."""
    return [
        [given(size * axis, angle).on(kind + long) for axis, angle in zip(axes(draw, len(angles)), angles, strict=True)]
        for (size, long), (kind, angles) in zip(lengths, angles_by_size(draw).items(), strict=True)
    ]


def lengths(draw):
    """Lengths of axes, long and short in turn, and their names; beyond 1e150 the square of a length overflows."""
    powers = draw.uniform((50, -50, 10, -100), (100, -20, 50, -50))
    return [(10.0**power, f", a very {'long' if power > 0 else 'short'} axis") for power in powers]


def of_any_length(draw):
    n, angle = draw.normal(size=3), draw.uniform(0.5, 3)
    return [given(length * n, angle).on(f"any angle{long}") for length, long in lengths(draw)]


def of_vectors(draw, turns):
    """The turns, each of a vector of its own."""
    return [turn.behind(draw.normal(size=3) * 10 ** draw.uniform(-2, 2)) for turn in turns]


def vectors_by_size(draw):
    return [of_vectors(draw, turns) for turns in turns_by_size(draw, lengths(draw))]


def turned_vectors(draw):
    """Random vectors, vectors along the axis, and none."""
    random, plain = of_vectors(draw, turns(draw) + plain_turns(draw)), plain_turns(draw)
    along = [turn.behind(-2.0 * turn.args[0]).on("a vector along the axis") for turn in plain[::5]]
    return [*random, *along, plain[1].behind(np.zeros(3)).on("the zero vector")]


def no_axes(draw):
    """(axis, angle): first of an axis, then of what is none, without a turn either."""
    angle = draw.uniform(0.5, 3)
    refused = [given(np.array(axis), angle).on(kind) for kind, axis in NO_AXES.items()]
    still = [case.but(case.args[0], 0.0).on(f"{case.kind}, no turn") for case in refused[:2]]
    return [Z_AXIS, *refused, *still]


def vectors_about_no_axes(draw):
    calls = of_vectors(draw, no_axes(draw))
    return calls + [case.but(np.zeros(3)).on(f"{case.kind}, the zero vector") for case in calls[1:3]]
