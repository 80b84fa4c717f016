"""Hidden inputs of hw14: disks, hoops and wheels in any motion, and plain motions that tell what random ones do not."""

import copy
import math

import numpy as np

from tam570_grader import given, in_turn, once, uneven

from . import right

SHAPES = {"a thin uniform disk": (0.25, 0.5), "a hoop": (0.5, 1.0), "a wheel": None}
AGAIN = "the same motion of another disk"
PLAIN = {  # of the rates of yaw, tilt, roll
    "a disk at rest": (0, 0, 0),
    "a disk that only rolls": (0, 0, 1),
    "a disk that only yaws": (1, 0, 0),
    "a disk that only tilts": (0, 1, 0),
    "a steady tilt": (1, 0, 1),
    "no roll": (1, 1, 0),
}


def a_disk(draw, shape="a wheel"):
    mass, radius = 10 ** draw.uniform(-1, 1), 10 ** draw.uniform(-1, 0)
    C = draw.uniform(0.2, 1.1)
    A, C = SHAPES[shape] or (C * draw.uniform(0.6, 1.3), C)
    size = mass * radius**2
    return {"mass": mass, "radius": radius, "inertia": (A * size, C * size), "gravity": draw.uniform(1.6, 25.0)}


def a_state(draw, disk, tilt, rates=()):
    """An Euler state; without rates, which are of the usual size, they are random."""
    place, (yaw, roll) = draw.uniform(-2, 2, 2), draw.uniform(-4, 4, 2)
    return np.array([*place, yaw, tilt, roll, *(right.usual(disk) * np.array(rates or draw.uniform(-2, 2, 3)))])


def instants(draw):
    """Euler states of any motion, and plain ones: at rest, upright, without yaw or roll, whole numbers, far away."""
    disks = ((shape, a_disk(draw, shape)) for shape in [*SHAPES] * 4)
    cases = [given(a_state(draw, disk, draw.uniform(0.3, 2.8)), **disk).on(shape) for shape, disk in disks]
    cases.append(cases[-1].but(gravity=0.0).on("no gravity"))
    disk, rates = a_disk(draw), draw.uniform(0.5, 2, 3) * draw.choice([-1, 1], 3)
    for kind, some in PLAIN.items():
        for tilt, how in ((right.RIGHT, "upright"), (draw.uniform(0.4, 1.4), "tilted"), (2.0, "tilted")):
            state = a_state(draw, disk, tilt, (*rates * some,))
            cases.append(given(state + 0.0, **disk).on(f"{kind}, {how}"))
    far = given(a_state(draw, disk, 1.0) + [300, -200, 0, 0, 0, 0, 0, 0], **disk).on("a disk far from the origin")
    whole = np.array([0, 0, 0, math.pi / 4, 0, 1, 1, 1])
    ones = given(whole, mass=1.0, radius=1.0, inertia=(0.25, 0.5), gravity=1.0).on("whole numbers, at the origin")
    return [*cases, ones, far]


def resting_first(draw):
    return sorted(instants(draw), key=lambda case: "at rest" not in case.kind)


def flat_and_upright(draw):
    """Nearly flat disks, and one that spins upright on a point."""
    disk = a_disk(draw)
    flat = [given(a_state(draw, disk, tilt), **disk).on("a nearly flat disk") for tilt in (1e-3, math.pi - 1e-3)]
    upright = given(a_state(draw, disk, right.RIGHT, (draw.uniform(0.5, 2), 0, 0)), **disk)
    return [*flat, upright.on("an upright disk that spins on a point")]


def timed(cases):
    """For the functions that are given a time, too."""
    return lambda draw: [one.behind(0.0) for one in cases(draw)]


def by_matrix(cases):
    """The same with matrix states in the place of Euler states, the last argument."""
    return lambda draw: [
        one.but(*one.args[:-1], right.matrix_state(one.args[-1], one.kwargs["radius"])) for one in cases(draw)
    ]


# Motions


@once
def motions(draw, count, span, samples):
    """Motions that stay away from the flat, a wheel's and, of two, a hoop's without gravity; span of sqrt(a/g)."""
    found: list[object] = []
    while len(found) < count:
        disk = a_disk(draw, ["a wheel", "a hoop"][len(found)])
        disk["gravity"] *= not found
        state = a_state(draw, disk, draw.uniform(0.8, 2.3))
        state[7] += 2 * right.usual(disk) * np.sign(state[7])
        # what needs t[0] > 0 gives one result
        t = uneven(draw, span / right.usual(disk), samples, draw.uniform(-3, -0.5) if found else draw.uniform(0.5, 3))
        if stays_up(t, state, disk):
            found.append(given(t, state, **disk).on("a motion without gravity" if found else "a general motion"))
    return found


def long_motion(draw):
    """The same each time that a check asks for it."""
    return motions(copy.deepcopy(draw), 1, 6.0, 4)


def stays_up(t, state, disk):
    try:
        states = right.simulate_euler(np.linspace(t[0], t[-1], 100), state, rtol=1e-5, **disk)
    except ArithmeticError:
        return False
    return np.sin(states[:, 3]).min() > 0.4


def simulated(draw):
    """Motions; few times, let go to fall almost flat, rolling or spinning upright, at rest; one argument changed."""
    general, disk, found = motions(draw, 2, 3.0, 60), a_disk(draw, "a thin uniform disk"), []
    for tilt, rates, kind in (
        (0.2, (0, 0, 0), "let go at rest and nearly flat"),
        (right.RIGHT, (0, 0, 3), "rolling straight, upright"),
        (right.RIGHT, (3, 0, 0), "spinning upright on a point"),
    ):
        t = draw.uniform(0.5, 3) + np.array([0.0, 0.2, 0.6]) / right.usual(disk)
        found.append(given(t, a_state(draw, disk, tilt, rates), **disk).on(f"few times, a disk {kind}"))
    still = found[0].but(gravity=0.0).on("few times, a disk at rest without gravity, where it stays")
    return [*general, *found, still, *in_turn(draw, found[0], gravity=0.8 * disk["gravity"])]


# Steady and nearly upright


def steady(draw):
    """Leans, precessions and spins, steady or not, and some with a zero."""
    disks = ((shape, a_disk(draw, shape)) for shape in [*SHAPES] * 4)
    cases = [
        given(draw.uniform(-1.4, 1.4), *(right.usual(disk) * draw.uniform(-2, 2, 2)), **disk).on(shape)
        for shape, disk in disks
    ]
    first, second = cases[:2]
    lean, precession, spin = abs(first.args[0]) + 0.1, *first.args[1:]
    plain = {
        "exactly upright": (0.0, precession, spin),
        "no precession": (lean, 0.0, spin),
        "no spin": (-lean, precession, 0.0),
        "a disk let go at rest": (lean, 0.0, 0.0),
        "straight rolling upright": (0.0, 0.0, spin),
        "spinning upright on a point": (0.0, precession, 0.0),
    }
    cases += [first.but(*motion).on(kind) for kind, motion in plain.items()]
    return [*cases, first.but(gravity=0.0).on("no gravity"), first.but(**second.kwargs).on(AGAIN)]


def wheels(draw):
    """Disks alone."""
    cases = [given(**a_disk(draw, shape)).on(shape) for shape in [*SHAPES] * 2]
    return [*cases, cases[-1].but(gravity=0.0).on("a wheel without gravity")]


def speeds(draw):
    """From rest to four times the critical speed; one without gravity."""
    cases = []
    for disk, ratio in zip(wheels(draw)[:-1], (0.0, 0.5, 0.95, 1.05, 2.0, 4.0), strict=True):
        pace = f"{'slower' if ratio < 1 else 'faster'} than the critical speed" if ratio else "at rest"
        cases.append(disk.but(ratio * right.critical_speed(**disk.kwargs)).on(f"{disk.kind}, {pace}"))
    return [*cases, cases[4].but(gravity=0.0).on("a hoop without gravity"), cases[5].but(**cases[1].kwargs).on(AGAIN)]


def pictures(draw):
    """Cases of the same disk and number of sides; five always, for a star of five sides is as regular."""
    for sides in (int(draw.integers(7, 30)), 3, 4, 5, 6):
        disk, kind = a_disk(draw), f"{sides} sides" if sides < 7 else "many sides"
        states = [a_state(draw, disk, tilt) for tilt in (0.7, 1.3, 2.5, right.RIGHT)]
        yield [given(state, radius=disk["radius"], sides=sides).on(kind) for state in states]
