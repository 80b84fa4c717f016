"""Hidden inputs of hw11: disks, hoops, wheels, rollers and coins, leaning in- and outwards, upright and almost flat."""

import itertools
import math

import numpy as np

from tam570_grader import KEPT, Case

from . import reference

UNIFORM, HOOP, WHEEL, ROLLER = "a thin uniform disk", "a hoop", "a wheel", "a long roller"
COIN = "a thin disk as small as a coin"  # its moments, 1e-6 N m, are so small that many thresholds take them for zero
WHEELS = UNIFORM, HOOP, WHEEL
UNIT = {"mass": 1.0, "radius": 1.0, "inertia": (0.25, 0.5), "gravity": 1.0}  # a thin uniform disk
SMALL_LEAN = 5e-5  # rad; its effect is far above any tolerance
STEEP_LEANS = 1.55, math.pi / 2 - 1e-4  # rad; at the second, rounding costs four of sixteen digits
STEEP = "a disk that lies almost flat"
LITTLE_GRAVITY = 1e-2  # m/s^2, of an asteroid: little, but not zero
LITTLE = "very little gravity"
AGAIN = "the arguments before with another disk or gravity"


def a_disk(rng, label):
    """Return a random disk; a long roller has A larger than C + m a^2."""
    mass, radius = 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(-1.5, 0)
    if label == COIN:
        mass, radius = rng.uniform(2e-3, 6e-3), rng.uniform(8e-3, 12e-3)
    A, C = (0.5, 1.0) if label == HOOP else (0.25, 0.5)  # over m a^2
    if label == WHEEL:
        C = rng.uniform(0.2, 1.1)
        A = C * rng.uniform(0.6, 1.3)
    if label == ROLLER:
        C = rng.uniform(0.3, 0.9)
        A = (C + 1) * rng.uniform(1.5, 3.0)
    size = mass * radius**2
    return {"mass": mass, "radius": radius, "inertia": (A * size, C * size), "gravity": rng.uniform(1.6, 25.0)}


def disks(rng, *labels):
    """Return (label, disk) pairs, each drawn when it is requested."""
    return ((label, a_disk(rng, label)) for label in labels)


def a_lean(rng):
    return rng.choice([-1, 1]) * rng.uniform(0.1, 1.35)


def usual(disk):
    """Return the scale of precessions and spins, rad/s."""
    return math.sqrt(disk["gravity"] / disk["radius"])


def telling_first(cases):
    """Sort cases, the informative ones first: if a call raises, only those before it are compared."""

    def rank(case):
        motion = case.args[:2]
        special = 2 * (0.0 in motion) + 3 * (case.label == AGAIN)
        return special, "hoop" in case.label, motion[-1] > 0, "thin" in case.label  # for a hoop C - m a^2 is zero

    return sorted(cases, key=rank)


def members(rng):
    """Return leans and precessions of both signs."""
    signs = itertools.cycle((1, -1))
    cases = [
        Case(a_lean(rng), next(signs) * usual(disk) * rng.uniform(0.3, 3), **disk).labelled(label)
        for label, disk in disks(rng, *WHEELS, COIN)
    ]
    return telling_first([*cases, cases[0].replace(**cases[1].kwargs).labelled(AGAIN, KEPT)])


def plain_members(rng):
    """Return upright disks, no gravity, almost flat disks, and integers."""
    disk = a_disk(rng, WHEEL)
    upright = Case(0.0, rng.choice([-1, 1]) * rng.uniform(0.5, 5), **disk).labelled("an upright disk")
    little = {**disk, "gravity": LITTLE_GRAVITY}
    cases = [
        upright,
        upright.replace(a_lean(rng), gravity=0.0).labelled("no gravity"),
        upright.replace(gravity=0.0).labelled("an upright disk without gravity"),
        upright.replace(rng.choice([-1, 1]) * SMALL_LEAN).labelled("an almost upright disk"),
        *(upright.replace(sign * STEEP_LEANS[0]).labelled(STEEP) for sign in (1, -1)),
        Case(a_lean(rng), usual(little), **little).labelled(LITTLE),
        *(Case(sign * math.pi / 4, -1.0, **UNIT).labelled("whole numbers") for sign in (1, -1)),
    ]
    return telling_first(cases)


def tracks(rng):
    """Return leans and track radii, both positive."""
    cases = []
    for label, disk in disks(rng, *WHEELS):
        lean = rng.uniform(0.1, 1.35)
        track = reference.smallest_track(lean, **disk) + disk["radius"] * rng.uniform(0.3, 6)
        cases.append(Case(lean, track, **disk).labelled(label))
    return telling_first([*cases, cases[0].replace(gravity=2 * cases[0].kwargs["gravity"]).labelled(AGAIN, KEPT)])


def tracks_of_any_sign(rng):
    label = "lean and track radius both negative"
    mirrored = [case.replace(*(-x for x in case.args)).labelled(label) for case in tracks(rng)[:2]]
    disk, lean = a_disk(rng, ROLLER), rng.uniform(0.2, 1.2)
    still = Case(lean, 0.0, **disk).labelled("a long roller whose contact rests")
    track = reference.smallest_track(lean, **disk) * rng.uniform(0.2, 0.8)
    label = "a long roller whose contact lies beyond the centre of the circle"
    beyond = [still.replace(sign * lean, sign * track).labelled(label) for sign in (1, -1)]
    disk, lean = a_disk(rng, COIN), rng.uniform(0.2, 1.2)
    track = disk["radius"] * math.sin(lean) * rng.uniform(0.9, 0.97)  # G is beyond the centre; the smallest is 5/6
    small, flat = Case(lean, track, **disk).labelled(COIN), a_disk(rng, UNIFORM)
    steep = [
        Case(lean, reference.smallest_track(lean, **flat) + flat["radius"], **flat).labelled(STEEP)
        for lean in STEEP_LEANS
    ]
    return [*mirrored, still, *beyond, small, *steep]


def straight_tracks(rng):
    """Return tracks on which nothing turns the disk, or very little."""
    disk = a_disk(rng, WHEEL)
    R = rng.uniform(2, 5)  # m, wider than any smallest track
    case = Case(rng.uniform(0.2, 1.2), R, **disk)
    little = case.replace(gravity=LITTLE_GRAVITY).labelled(LITTLE)
    plain, signed = [case.replace(gravity=0.0).labelled("no gravity"), little], []
    for sign, word in ((1, "positive"), (-1, "negative")):
        upright = f"an upright disk and a {word} track radius"
        small = case.replace(0.0, sign * 0.05 * disk["radius"])
        plain += [
            case.replace(0.0, sign * R).labelled(upright),
            small.labelled(f"{upright}, far below the radius of the disk"),
        ]
        outwards = case.replace(-sign * case.args[0], sign * R, gravity=0.0)
        signed.append(outwards.labelled("no gravity, and a lean away from the centre"))
        signed.append(case.replace(sign * 1e-4 * SMALL_LEAN, sign * R).labelled("an almost upright disk"))
    return plain + signed


def impossible_tracks(rng):
    disk, lean = a_disk(rng, WHEEL), rng.uniform(0.2, 1.2)
    wide = disk["radius"] * rng.uniform(0.5, 5)
    tight = reference.smallest_track(lean, **disk) * rng.uniform(0.1, 0.9)
    outwards = "a disk that leans away from the centre"
    tracks = [
        (-lean, wide, outwards),
        (lean, -wide, f"{outwards}, seen in a mirror"),
        (lean, tight, "a track too tight for the lean"),
        (0.0, 0.0, "an upright disk on a point, where every Omega will do"),
        (-SMALL_LEAN, wide, f"{outwards} by very little"),
    ]
    cases = [Case(*track, **disk).labelled(label) for *track, label in tracks]
    label = "a roller that turns on a point, its lean tiny but not zero, where Omega drops out"
    for lean in (2.0**-30, -(2.0**-30)):  # equals its sine and tangent; its cosine is one
        # A = C + m a^2, for which no Omega bears the weight on a point; powers of two, so that no formula is rounded
        mass, radius, gravity = 2.0 ** rng.integers([-1, -3, 1], [3, 1, 5])
        inertia = 2 * mass * radius**2, mass * radius**2
        cases.append(Case(lean, 0.0, mass=mass, radius=radius, inertia=inertia, gravity=gravity).labelled(label))
    return cases


def sliding_tracks(rng):
    """Return sliding tracks, leans inwards first, so that a sign is named if it matters."""
    leans = [*(a_lean(rng) for _ in range(2)), 0.0]
    leans = sorted([*leans, leans[0], STEEP_LEANS[0], -STEEP_LEANS[0]], key=lambda lean: (lean == 0, lean < 0))
    signs = {1: "a lean inwards", -1: "a negative lean", 0: "an upright disk"}
    radii = 10 ** rng.uniform(-1.5, 1, len(leans))
    return [Case(lean, radius=a).labelled(signs[np.sign(lean)]) for lean, a in zip(leans, radii, strict=True)]


def settled(rng):
    """Return cases with a lean alone."""
    cases = [Case(a_lean(rng), **disk).labelled(label) for label, disk in disks(rng, *WHEELS, COIN)]
    wheel = cases[2]  # no thin disk
    cases += [Case(sign * math.pi / 4, **UNIT).labelled("whole numbers") for sign in (1, -1)]
    repeated = wheel.replace(gravity=2 * wheel.kwargs["gravity"]).labelled(AGAIN, KEPT)
    return [*cases, repeated, wheel.replace(-wheel.args[0], gravity=LITTLE_GRAVITY).labelled(LITTLE)]


def next_to_upright(rng):
    labels = {0.0: "an upright disk", 1e-9: "an almost upright disk", -1e-9: "an almost upright disk"}
    return [Case(lean, **a_disk(rng, WHEEL)).labelled(label) for lean, label in labels.items()]


def steep(rng):
    disk = a_disk(rng, WHEEL)
    return [Case(sign * lean, **disk).labelled(STEEP) for lean in STEEP_LEANS for sign in (1, -1)]


def whirls(rng):
    """Return leans, precessions, spins and disks without any relation, steady or not; and some with a zero."""
    cases = [
        Case(rng.uniform(-1.4, 1.4), *(usual(disk) * rng.uniform(-3, 3, 2)), **disk).labelled(label)
        for label, disk in disks(rng, *WHEELS, COIN)
    ]
    cases += [cases[0].replace(sign * STEEP_LEANS[0]).labelled(STEEP) for sign in (1, -1)]
    cases.append(cases[0].replace(**cases[1].kwargs).labelled(AGAIN, KEPT))
    for _, disk in disks(rng, WHEEL):
        case = Case(a_lean(rng), *(usual(disk) * rng.uniform(0.3, 3, 2) * rng.choice([-1, 1], 2)), **disk)
        cases += [case.replace(0.0).labelled("an upright disk"), case.replace(gravity=0.0).labelled("no gravity")]
        cases.append(case.replace(*case.args[:2], 0.0).labelled("no spin"))
    both = [Case(sign * math.pi / 4, sign * 1.0, sign * 1.0, **UNIT) for sign in (1, -1)]
    return [*cases, *(case.labelled("whole numbers") for case in both)]


def under_forces(rng):
    """Return motions under forces of any size, also without precession, and without an inward force."""
    whirling = whirls(rng)
    motions = whirling + [case.replace(case.args[0], 0.0).labelled("no precession") for case in whirling[-4:]]
    cases = []
    for index, case in enumerate(motions):
        inward, normal = case.kwargs["mass"] * (case.kwargs["gravity"] or 10.0) * rng.uniform(-2, 2, 2)
        if index % 5 == 4:
            case, inward = case.labelled(f"{case.label}, no inward force"), 0.0
        cases.append(case.replace(*case.args, inward, normal))
    other = tuple(2 * moment for moment in cases[0].kwargs["inertia"])
    return telling_first([*cases, cases[0].replace(inertia=other).labelled(AGAIN, KEPT)])


def straight_rolling(rng):
    disk = a_disk(rng, WHEEL)
    spins = {"straight rolling, upright": usual(disk), "an upright disk at rest": 0.0}
    return [Case(0.0, 0.0, spin, **disk).labelled(label) for label, spin in spins.items()]
