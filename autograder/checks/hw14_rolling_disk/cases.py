"""Hidden inputs of hw14: disks, hoops and wheels in random motion, and plain motions for other mistakes."""

import math

import numpy as np

from tam570_grader import Case, repeated_calls, uneven

from . import reference

SHAPES = {"a thin uniform disk": (0.25, 0.5), "a hoop": (0.5, 1.0), "a wheel": None}
AGAIN = "the same motion of another disk"
PLAIN = {  # {label: (factors of the rates of yaw, tilt, roll; tilts)}
    "a disk at rest": ((0, 0, 0), (reference.RIGHT, 0.9)),
    "a disk that only rolls": ((0, 0, 1), (reference.RIGHT, 2.0)),
    "a disk that only yaws": ((1, 0, 0), (reference.RIGHT, 0.6)),
    "a disk that only tilts": ((0, 1, 0), (1.3,)),
    "a steady tilt": ((1, 0, 1), (2.6,)),
    "no roll": ((1, 1, 0), (1.2,)),
}


def a_disk(rng, shape="a wheel"):
    mass, radius = 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(-1, 0)
    C = rng.uniform(0.2, 1.1)
    A, C = SHAPES[shape] or (C * rng.uniform(0.6, 1.3), C)
    size = mass * radius**2
    return {"mass": mass, "radius": radius, "inertia": (A * size, C * size), "gravity": rng.uniform(1.6, 25.0)}


def a_state(rng, disk, tilt, rates=()):
    """Return an Euler state; `rates` are in units of the usual size, and random by default."""
    position, (yaw, roll) = rng.uniform(-2, 2, 2), rng.uniform(-4, 4, 2)
    return np.array([*position, yaw, tilt, roll, *(reference.usual(disk) * np.array(rates or rng.uniform(-2, 2, 3)))])


def instants(rng):
    """Return Euler states of any motion, and plain ones: at rest, upright, without yaw or roll, integers, far away."""
    disks = [(shape, a_disk(rng, shape)) for shape in SHAPES]
    cases = [Case(a_state(rng, disk, rng.uniform(0.3, 2.8)), **disk).labelled(shape) for shape, disk in disks]
    cases.append(cases[-1].replace(gravity=0.0).labelled("no gravity"))
    disk, rates = a_disk(rng), rng.uniform(0.5, 2, 3) * rng.choice([-1, 1], 3)
    for label, (factors, tilts) in PLAIN.items():
        for tilt in tilts:
            state = a_state(rng, disk, tilt, (*rates * factors,))
            way = "upright" if tilt == reference.RIGHT else "tilted"
            cases.append(Case(state + 0.0, **disk).labelled(f"{label}, {way}"))
    far = a_state(rng, disk, 1.0) + [300, -200, 15, 0, -15, 0, 0, 0]
    state = np.array([0, 0, 0, math.pi / 4, 0, 1, 1, 1])
    ones = Case(state, mass=1.0, radius=1.0, inertia=(0.25, 0.5), gravity=1.0).labelled("whole numbers, at the origin")
    return [*cases, ones, Case(far, **disk).labelled("far from the origin, after turns of yaw and roll")]


def flat_and_upright(rng):
    """Return nearly flat disks, and one that spins upright on a point."""
    disk = a_disk(rng)
    flat = [Case(a_state(rng, disk, tilt), **disk).labelled("a nearly flat disk") for tilt in (1e-3, math.pi - 1e-3)]
    upright = Case(a_state(rng, disk, reference.RIGHT, (rng.uniform(0.5, 2), 0, 0)), **disk)
    return [*flat, upright.labelled("an upright disk that spins on a point")]


def timed(rng, cases_of):
    """Return these cases with a time before the state."""
    return [case.with_leading(0.0) for case in cases_of(rng)]


def by_matrix(rng, cases_of, *more):
    """Return these cases with matrix states in place of Euler states, the last argument."""
    return [
        case.replace(*case.args[:-1], reference.matrix_state(case.args[-1], case.kwargs["radius"]))
        for case in cases_of(rng, *more)
    ]


# Motions


def a_motion(rng, span, samples):
    """Return a wheel's motion that stays away from the flat; span of sqrt(a/g)."""
    disk = a_disk(rng)
    t = uneven(rng, span / reference.usual(disk), samples, rng.uniform(0.5, 3))
    while True:
        state = a_state(rng, disk, rng.uniform(0.8, 2.3))
        state[7] += 2 * reference.usual(disk) * np.sign(state[7])
        if stays_up(t, state, disk):
            return [Case(t, state, **disk).labelled("a general motion")]


def long_motion(rng):
    return a_motion(rng, 4.5, 4)


def stays_up(t, state, disk):
    try:
        states = reference.simulate_euler(np.linspace(t[0], t[-1], 100), state, rtol=1e-5, **disk)
    except ArithmeticError:
        return False
    return np.sin(states[:, 3]).min() > 0.4


def simulated(rng):
    """Return a general motion; few times, a start at rest that falls almost flat; changed calls."""
    (motion,) = a_motion(rng, 2.0, 16)
    disk = motion.kwargs
    t = rng.uniform(0.5, 3) + np.array([0.0, 0.2, 0.6]) / reference.usual(disk)
    flat = Case(t, a_state(rng, disk, 0.2, (0, 0, 0)), **disk).labelled("few times, a disk let go at rest, nearly flat")
    other_times, _, other_disk = repeated_calls(rng, flat, gravity=disk["gravity"] / 2)
    return [motion, flat, other_times, other_disk]


# Steady and nearly upright


def steady(rng):
    """Return leans, precessions and spins, steady or not, and some with a zero."""
    disks = [(shape, a_disk(rng, shape)) for shape in SHAPES]
    cases = [
        Case(rng.uniform(-1.4, 1.4), *(reference.usual(disk) * rng.uniform(0.2, 2, 2) * signs), **disk).labelled(shape)
        for (shape, disk), signs in zip(disks, ((1, 1), (-1, 1), (1, -1)), strict=True)
    ]
    first, second = cases[:2]
    lean, precession, spin = abs(first.args[0]) + 0.1, *first.args[1:]
    plain = {
        "exactly upright": (0.0, precession, spin),
        "no precession": (lean, 0.0, spin),
        "no spin": (-lean, -precession, 0.0),
        "a disk let go at rest": (lean, 0.0, 0.0),
        "straight rolling upright": (0.0, 0.0, spin),
        "spinning upright on a point": (0.0, precession, 0.0),
    }
    cases += [first.replace(*motion).labelled(label) for label, motion in plain.items()]
    return [*cases, first.replace(gravity=0.0).labelled("no gravity"), first.replace(**second.kwargs).labelled(AGAIN)]


def wheels(rng):
    """Return disks without a motion."""
    shapes = (*SHAPES, [*SHAPES][-1])  # two wheels, so that a mistake that is wrong for these alone is named, too
    cases = [Case(**a_disk(rng, shape)).labelled(shape) for shape in shapes]
    return [*cases, cases[-1].replace(gravity=0.0).labelled("a wheel without gravity")]


def speeds(rng):
    """Return speeds from rest to twice the critical speed; without gravity; the same speed of another disk."""
    cases, disks = [], wheels(rng)
    for disk, ratio in zip([*disks[:3], disks[0]], (0.0, 0.5, 1.05, 2.0), strict=True):
        pace = f"{'slower' if ratio < 1 else 'faster'} than the critical speed" if ratio else "at rest"
        cases.append(disk.replace(ratio * reference.critical_speed(**disk.kwargs)).labelled(f"{disk.label}, {pace}"))
    weightless = cases[1].replace(gravity=0.0).labelled("a hoop without gravity")
    return [*cases, weightless, cases[3].replace(**disks[2].kwargs).labelled(AGAIN)]


def pictures(rng):
    """Yield cases of the same disk and number of sides; five always, because a star of five sides is as regular."""
    for sides in (int(rng.integers(7, 30)), 3, 4, 5, 6):
        disk, label = a_disk(rng), f"{sides} sides" if sides < 7 else "many sides"
        states = [a_state(rng, disk, tilt) for tilt in (rng.uniform(0.6, 2.5), reference.RIGHT)]
        states[1][4] += 15
        yield [Case(state, radius=disk["radius"], sides=sides).labelled(label) for state in states]
