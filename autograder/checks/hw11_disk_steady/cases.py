"""Hidden inputs of hw11: disks, hoops, wheels, rollers and coins, leaning in- and outwards, upright and almost flat."""

import math

import numpy as np

from tam570_grader import given

from . import right

UNIFORM, HOOP, WHEEL, ROLLER = "a thin uniform disk", "a hoop", "a wheel", "a long roller"
COIN = "a thin disk as small as a coin"  # its moments are so small, 1e-6 N m, that many a threshold sees zero
WHEELS = UNIFORM, HOOP, WHEEL
UNIT = {"mass": 1.0, "radius": 1.0, "inertia": (0.25, 0.5), "gravity": 1.0}  # a thin uniform disk
SMALL_LEAN = 5e-5  # rad; what it changes is far above any tolerance
STEEP_LEANS = 1.55, math.pi / 2 - 1e-4  # rad; at the second, rounding costs four digits of sixteen
STEEP = "a disk that lies almost flat"
LITTLE_GRAVITY = 1e-2  # m/s^2, of an asteroid: little, and not none
LITTLE = "very little gravity"
AGAIN = "the arguments before with another disk or gravity"


def a_disk(draw, kind):
    """A long roller has A larger than C + m a^2."""
    mass, radius = 10 ** draw.uniform(-1, 1), 10 ** draw.uniform(-1.5, 0)
    if kind == COIN:
        mass, radius = draw.uniform(2e-3, 6e-3), draw.uniform(8e-3, 12e-3)
    A, C = (0.5, 1.0) if kind == HOOP else (0.25, 0.5)  # over m a^2
    if kind == WHEEL:
        C = draw.uniform(0.2, 1.1)
        A = C * draw.uniform(0.6, 1.3)
    if kind == ROLLER:
        C = draw.uniform(0.3, 0.9)
        A = (C + 1) * draw.uniform(1.5, 3.0)
    size = mass * radius**2
    return {"mass": mass, "radius": radius, "inertia": (A * size, C * size), "gravity": draw.uniform(1.6, 25.0)}


def disks(draw, *kinds):
    """Each is drawn when it is asked for."""
    return ((kind, a_disk(draw, kind)) for kind in kinds)


def a_lean(draw):
    return draw.choice([-1, 1]) * draw.uniform(0.1, 1.35)


def usual(disk):
    """Size of precessions and spins, rad/s."""
    return math.sqrt(disk["gravity"] / disk["radius"])


def telling_first(cases):
    """What tells mistakes from the truth comes first: where a call raises, only the ones before it are compared."""

    def place(case):
        motion = case.args[:2]
        special = 2 * (0.0 in motion) + 3 * (case.kind == AGAIN)
        return special, motion[-1] > 0, "thin" in case.kind

    return sorted(cases, key=place)


def members(draw):
    """Leans and precessions of both signs."""
    cases = [
        given(a_lean(draw), draw.choice([-1, 1]) * usual(disk) * draw.uniform(0.3, 3), **disk).on(kind)
        for kind, disk in disks(draw, *WHEELS * 4, COIN)
    ]
    return telling_first([*cases, cases[0].but(**cases[1].kwargs).on(AGAIN)])


def plain_members(draw):
    """Upright disks, without gravity, almost flat, and whole numbers."""
    cases = []
    for _, disk in disks(draw, *WHEELS):
        upright = given(0.0, draw.choice([-1, 1]) * draw.uniform(0.5, 5), **disk).on("an upright disk")
        cases += [upright, upright.but(a_lean(draw), gravity=0.0).on("no gravity")]
        cases.append(upright.but(gravity=0.0).on("an upright disk without gravity"))
    cases.append(upright.but(draw.choice([-1, 1]) * SMALL_LEAN).on("an almost upright disk"))
    cases += [upright.but(sign * STEEP_LEANS[0]).on(STEEP) for sign in (1, -1)]
    little = {**disk, "gravity": LITTLE_GRAVITY}
    cases.append(given(a_lean(draw), usual(little), **little).on(LITTLE))
    whole = [(sign * math.pi / 4, turn) for sign in (1, -1) for turn in (1.0, -1.0)]
    return telling_first([*cases, *(given(*motion, **UNIT).on("whole numbers") for motion in whole)])


def tracks(draw):
    """Leans and track radii, both positive."""
    cases = []
    for kind, disk in disks(draw, *WHEELS * 4):
        lean = draw.uniform(0.1, 1.35)
        track = right.smallest_track(lean, **disk) + disk["radius"] * draw.uniform(0.3, 6)
        cases.append(given(lean, track, **disk).on(kind))
    return telling_first([*cases, cases[0].but(gravity=2 * cases[0].kwargs["gravity"]).on(AGAIN)])


def tracks_of_any_sign(draw):
    kind = "lean and track radius both negative"
    mirrored = [case.but(*(-x for x in case.args)).on(kind) for case in tracks(draw)[:4]]
    disk, lean = a_disk(draw, ROLLER), draw.uniform(0.2, 1.2)
    still = given(lean, 0.0, **disk).on("a long roller whose contact rests")
    track = right.smallest_track(lean, **disk) * draw.uniform(0.2, 0.8)
    kind = "a long roller whose contact lies beyond the centre of the circle"
    beyond = [still.but(sign * lean, sign * track).on(kind) for sign in (1, -1)]
    disk, lean = a_disk(draw, COIN), draw.uniform(0.2, 1.2)
    track = right.smallest_track(lean, **disk) + disk["radius"] * draw.uniform(0.3, 0.6)
    small, flat = given(lean, track, **disk).on(COIN), a_disk(draw, UNIFORM)
    steep = [given(lean, right.smallest_track(lean, **flat) + flat["radius"], **flat).on(STEEP) for lean in STEEP_LEANS]
    return [*mirrored, still, *beyond, small, *steep]


def straight_tracks(draw):
    """Where nothing turns the disk; and where very little does."""
    plain, signed = [], []
    for _, disk in disks(draw, *WHEELS):
        R = draw.uniform(2, 5)  # m, wider than any smallest track
        case = given(draw.uniform(0.2, 1.2), R, **disk)
        plain += [case.but(gravity=0.0).on("no gravity"), case.but(gravity=LITTLE_GRAVITY).on(LITTLE)]
        for sign, word in ((1, "positive"), (-1, "negative")):
            upright = f"an upright disk and a {word} track radius"
            small = case.but(0.0, sign * 0.05 * disk["radius"])
            plain += [case.but(0.0, sign * R).on(upright), small.on(f"{upright}, far below the radius of the disk")]
            outwards = case.but(-sign * case.args[0], sign * R, gravity=0.0)
            signed.append(outwards.on("no gravity, and a lean away from the centre"))
            signed.append(case.but(sign * SMALL_LEAN, sign * R).on("an almost upright disk"))
    return plain + signed


def impossible_tracks(draw):
    cases = []
    for _, disk in disks(draw, *WHEELS):
        lean = draw.uniform(0.2, 1.2)
        wide, tight = disk["radius"] * draw.uniform(0.5, 5), right.smallest_track(lean, **disk) * draw.uniform(0.1, 0.9)
        outwards = "a disk that leans away from the centre"
        places = [
            (-lean, wide, outwards),
            (lean, -wide, f"{outwards}, seen in a mirror"),
            (lean, tight, "a track too tight for the lean"),
            (0.0, 0.0, "an upright disk on a point, where every Omega will do"),
            (-SMALL_LEAN, wide, f"{outwards} by very little"),
        ]
        cases += [given(*place, **disk).on(kind) for *place, kind in places]
    kind = "a roller that turns on a point, its lean tiny but not zero, where Omega drops out"
    for lean in (2.0**-30, -(2.0**-30)):  # its own sine and tangent, and its cosine is one
        # A = C + m a^2, with which no Omega bears the weight on a point; powers of two, so that no formula is rounded
        mass, radius, gravity = 2.0 ** draw.integers([-1, -3, 1], [3, 1, 5])
        inertia = 2 * mass * radius**2, mass * radius**2
        cases.append(given(lean, 0.0, mass=mass, radius=radius, inertia=inertia, gravity=gravity).on(kind))
    return cases


def sliding_tracks(draw):
    """A lean inwards first: a sign is named if it is what matters."""
    leans = [*(a_lean(draw) for _ in range(10)), 0.0]
    leans = sorted([*leans, leans[0], STEEP_LEANS[0], -STEEP_LEANS[0]], key=lambda lean: (lean == 0, lean < 0))
    signs = {1: "a lean inwards", -1: "a negative lean", 0: "an upright disk"}
    radii = 10 ** draw.uniform(-1.5, 1, len(leans))
    return [given(lean, radius=a).on(signs[np.sign(lean)]) for lean, a in zip(leans, radii, strict=True)]


def settled(draw):
    """A lean alone."""
    cases = [given(a_lean(draw), **disk).on(kind) for kind, disk in disks(draw, *WHEELS * 3, COIN)]
    first = cases[0]
    cases += [given(sign * math.pi / 4, **UNIT).on("whole numbers") for sign in (1, -1)]
    again = first.but(gravity=2 * first.kwargs["gravity"]).on(AGAIN)
    return [*cases, again, first.but(-first.args[0], gravity=LITTLE_GRAVITY).on(LITTLE)]


def next_to_upright(draw):
    kinds = {0.0: "an upright disk", 1e-9: "an almost upright disk", -1e-9: "an almost upright disk"}
    return [given(lean, **a_disk(draw, WHEEL)).on(kind) for lean, kind in kinds.items()]


def steep(draw):
    disk = a_disk(draw, WHEEL)
    return [given(sign * lean, **disk).on(STEEP) for lean in STEEP_LEANS for sign in (1, -1)]


def whirls(draw):
    """Leans, precessions, spins and disks without any relation, steady or not; and some with a zero."""
    cases = [
        given(draw.uniform(-1.4, 1.4), *(usual(disk) * draw.uniform(-3, 3, 2)), **disk).on(kind)
        for kind, disk in disks(draw, *WHEELS * 4, COIN)
    ]
    cases += [cases[0].but(sign * STEEP_LEANS[0]).on(STEEP) for sign in (1, -1)]
    cases.append(cases[0].but(**cases[1].kwargs).on(AGAIN))
    for _, disk in disks(draw, *WHEELS):
        case = given(a_lean(draw), *(usual(disk) * draw.uniform(0.3, 3, 2) * draw.choice([-1, 1], 2)), **disk)
        cases += [case.but(0.0).on("an upright disk"), case.but(gravity=0.0).on("no gravity")]
        cases.append(case.but(*case.args[:2], 0.0).on("no spin"))
    whole = [given(sign * math.pi / 4, sign * 1.0, 1.0, **UNIT).on("whole numbers") for sign in (1, -1)]
    return cases + whole


def under_forces(draw):
    """Motions under forces of any size, without precession too, and without an inward force."""
    whirling = whirls(draw)
    motions = whirling + [case.but(case.args[0], 0.0).on("no precession") for case in whirling[-6:]]
    cases = []
    for index, case in enumerate(motions):
        inward, normal = case.kwargs["mass"] * (case.kwargs["gravity"] or 10.0) * draw.uniform(-2, 2, 2)
        if index % 5 == 4:
            case, inward = case.on(f"{case.kind}, no inward force"), 0.0
        cases.append(case.but(*case.args, inward, normal))
    other = tuple(2 * it for it in cases[0].kwargs["inertia"])
    return telling_first([*cases, cases[0].but(inertia=other).on(AGAIN)])


def straight_rolling(draw):
    disk = a_disk(draw, WHEEL)
    kinds = {"straight rolling, upright": usual(disk), "an upright disk at rest": 0.0}
    return [given(0.0, 0.0, spin, **disk).on(kind) for kind, spin in kinds.items()]
