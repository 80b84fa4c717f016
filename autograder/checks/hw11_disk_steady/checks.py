"""Hidden checks of hw11. What is right is found from the balance of moments in vectors, solved for the unknown.

Axes: x towards the centre of the circle, z up, y such that z turns towards x about +y, as the lean grows.
"""

import math
from functools import partial

import numpy as np

from tam570_grader import check, expect, expect_that, given, group, number, once, suspect

RESULTS = {
    "rolling_precession": number,
    "rolling_spin": number,
    "rolling_track_radius": number,
    "sliding_spin": number,
    "sliding_track_radius": number,
    "common_precession": number,
    "contact_force": group(number, number),
    "moment_residual": number,
    "settling_energy": number,
}
NEEDS = ("numpy",)
MANUAL = {"d": (2, "which of these motions a shuddering coin follows, and why")}

# Formulas agree to a few roundings, 1e-15; a root finder at its usual tolerance of 1e-12 loses two digits
# where the root is flat. Wrong physics is off by a tenth.
WITHIN = 1e-9
X, Y, Z = np.eye(3)


# The balance of moments about G


def axle(lean):
    return math.cos(lean) * X - math.sin(lean) * Z


def rim(lean, radius):
    """From the contact to G."""
    return radius * (math.sin(lean) * X + math.cos(lean) * Z)


def angular_velocity(lean, precession, spin):
    """Precession about z, and about the axle what is missing to the total spin."""
    n = axle(lean)
    return precession * Z + (spin - precession * n @ Z) * n


def residual(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    """Moment of the contact force about G minus Omega z x H."""
    A, C = inertia
    n, omega = axle(lean), angular_velocity(lean, precession, spin)
    H = A * omega + (C - A) * (omega @ n) * n
    moment = np.cross(-rim(lean, radius), inward * X + normal * Z)
    return float((moment - precession * np.cross(Z, H)) @ Y)


def rolling_force(lean, precession, spin, mass, radius, gravity):
    """Towards the centre and upwards: G moves at omega x (contact to G), and Omega turns that velocity."""
    velocity = np.cross(angular_velocity(lean, precession, spin), rim(lean, radius))
    force = mass * (precession * np.cross(Z, velocity) + gravity * Z)
    return float(force @ X), float(force @ Z)


def sliding_force(lean, precession, spin, mass, radius, gravity):
    return 0.0, mass * gravity


def unbalanced(lean, precession, spin, force, *, mass, radius, inertia, gravity):
    """The residual under the force that the motion needs."""
    needed = force(lean, precession, spin, mass, radius, gravity)
    return residual(lean, precession, spin, *needed, mass=mass, radius=radius, inertia=inertia)


# Its solutions: the residual is linear in the spin, and in the square of Omega along a family of given track


def balanced_spin(lean, precession, force=rolling_force, **disk):
    at_rest, turning = (unbalanced(lean, precession, spin, force, **disk) for spin in (0.0, 1.0))
    return at_rest / (at_rest - turning)


def spin_scale(lean, precession, force=rolling_force, *, mass, radius, inertia, gravity):
    """Size of the two terms that add up to the spin."""
    still = {"mass": mass, "radius": radius, "inertia": inertia, "gravity": 0.0}
    per_spin = [unbalanced(lean, precession, spin, force, **still) for spin in (0.0, 1.0)]
    terms = mass * gravity * radius + inertia[0] * precession**2
    return terms / abs(per_spin[1] - per_spin[0])


def track_of(lean, precession, spin, radius):
    """Rolling: the velocity omega x (contact to G) is that of a point that goes round with Omega."""
    velocity = np.cross(angular_velocity(lean, precession, spin), rim(lean, radius)) @ Y
    return rim(lean, radius) @ X - velocity / precession


def spin_on_track(lean, precession, track_radius, radius):
    """The spin is the one whose track is right; the track's radius is linear in it."""
    r0, r1 = (track_of(lean, precession, spin, radius) for spin in (0.0, 1.0))
    return (track_radius - r0) / (r1 - r0)


def resistance(lean, spin, force, **disk):
    """What balances the weight's moment at Omega = 1 with that spin; without the weight steep leans cost no digits."""
    return -unbalanced(lean, 1.0, spin, force, **{**disk, "gravity": 0.0})


def root(square):
    """Wrong variants may have none."""
    return math.sqrt(square) if square >= 0.0 else math.nan


def balanced_precession(lean, track_radius, *, force=rolling_force, **disk):
    """Omega with weight - resistance Omega^2 = 0."""
    weight = disk["mass"] * disk["gravity"] * disk["radius"] * math.sin(lean)
    spin = spin_on_track(lean, 1.0, track_radius, disk["radius"])
    return root(weight / resistance(lean, spin, force, **disk))


def rolling_track(lean, precession, **disk):
    return track_with(balanced_spin)(lean, precession, **disk)


def track_with(spin):
    return lambda lean, precession, **disk: track_of(lean, precession, spin(lean, precession, **disk), disk["radius"])


def sliding(lean, precession, **disk):
    return balanced_spin(lean, precession, sliding_force, **disk)


def common(lean, *, mass, radius, inertia, gravity):
    """Omega of the members of both families: no spin, and the weight's moment alone; upright it is a limit."""
    lean = lean or 1e-5  # the lean enters by its square
    disk = {"mass": mass, "radius": radius, "inertia": inertia, "gravity": gravity}
    weight = mass * gravity * radius * math.sin(lean)
    return root(weight / resistance(lean, 0.0, sliding_force, **disk))


def turning_energy(lean, precession, inertia):
    """Kinetic energy of a disk whose centre is at rest and that has no spin."""
    A, C = inertia
    n, omega = axle(lean), angular_velocity(lean, precession, 0.0)
    return 0.5 * (A * omega @ omega + (C - A) * (omega @ n) ** 2)


def potential(lean, *, mass, radius, inertia, gravity):
    return mass * gravity * rim(lean, radius) @ Z


def settling_kinetic_energy(lean, **disk):
    return turning_energy(lean, common(lean, **disk), disk["inertia"])


def energy_with(kinetic):
    return lambda lean, **disk: kinetic(lean, common(lean, **disk), disk["inertia"]) + potential(lean, **disk)


settled = energy_with(turning_energy)


# Wrong answers to name

TO_CENTRE = "R measured to G; it is the radius of the track of the contact point"
RELATIVE = "the spin relative to the turning frame taken for the total spin"
NO_MA2 = "m a^2 missing: the force that keeps G on its circle has a moment about G too"
SWAPPED = "A and C swapped: A is about a diameter, C about the axle"
REVERSED = "the sign turned round"
SPIN_ALONE = "the angular momentum of the spin alone: Omega turns the disk about its diameter too"
THIN = "A and C of a thin uniform disk for those given"
HALF = "C/2 for A, as of a thin disk"
UNIT_SIZE = "a mass and a radius of 1 for those given"
UNSIGNED = "the precession taken without its sign"
DEGREES = "the lean taken for degrees"
SINE = "sin(lean) for tan(lean) in the moment of the weight: the cosine divides that term too"


def swapped(right):
    return lambda *args, **disk: right(*args, **{**disk, "inertia": disk["inertia"][::-1]})


def spin_alone(right):
    """Nothing about the diameter."""
    return lambda *args, **disk: right(*args, **{**disk, "inertia": (0.0, disk["inertia"][1])})


def thin(right):
    """As if every disk were uniform and thin."""

    def wrong(*args, mass, radius, inertia, **rest):
        return right(*args, mass=mass, radius=radius, inertia=uniform_disk(None, mass * radius**2), **rest)

    return wrong


def half_of_c(right):
    def wrong(*args, inertia, **rest):
        return right(*args, inertia=(inertia[1] / 2, inertia[1]), **rest)

    return wrong


def unit_size(right):
    return lambda *args, **disk: right(*args, **{**disk, "mass": 1.0, "radius": 1.0})


def unsigned(right):
    return lambda lean, precession, **disk: right(lean, abs(precession), **disk)


def in_degrees(right):
    return lambda lean, *args, **disk: right(math.radians(lean), *args, **disk)


def sine_for_tangent(right):
    """As if gravity were less by the cosine of the lean."""
    return lambda lean, *args, gravity, **disk: right(lean, *args, gravity=gravity * math.cos(lean), **disk)


def reversed_sign(right):
    return lambda *args, **disk: -right(*args, **disk)


def about_contact(right):
    """A + m a^2 for A."""

    def wrong(*args, mass, radius, inertia, **rest):
        moved = (inertia[0] + mass * radius**2, inertia[1])
        return right(*args, mass=mass, radius=radius, inertia=moved, **rest)

    return wrong


def with_ma2(right):
    """C + m a^2 for C."""

    def wrong(*args, mass, radius, inertia, **rest):
        moved = (inertia[0], inertia[1] + mass * radius**2)
        return right(*args, mass=mass, radius=radius, inertia=moved, **rest)

    return wrong


def relative_spin(force):
    """The spin relative to the frame that goes round with Omega."""
    return lambda lean, precession, **disk: balanced_spin(lean, precession, force, **disk) - precession * axle(lean) @ Z


def by_relative_spin(right):
    """As if the spin given were relative to that frame."""
    return lambda lean, precession, spin, *force, **disk: right(
        lean, precession, spin + precession * axle(lean) @ Z, *force, **disk
    )


def precession_to_centre(lean, track_radius, **disk):
    """a spin = Omega R, m Omega^2 R for the force."""
    return balanced_precession(lean, track_radius + rim(lean, disk["radius"]) @ X, **disk)


def precession_with_relative_spin(lean, track_radius, *, mass, radius, inertia, gravity):
    """C times the relative spin Omega R / a in the angular momentum, the force right."""
    A, C = inertia
    c, s = math.cos(lean), math.sin(lean)
    per_square = c * (C * track_radius / radius + mass * radius * (track_radius - radius * s) + A * s)
    return root(mass * gravity * radius * s / per_square)


def precession_without_ma2(lean, track_radius, **disk):
    return balanced_precession(lean, track_radius, force=sliding_force, **disk)


def track_to_centre(lean, precession, **disk):
    return rolling_track(lean, precession, **disk) - rim(lean, disk["radius"]) @ X


def track_by_relative_spin(lean, precession, **disk):
    return rolling_track(lean, precession, **disk) + rim(lean, disk["radius"]) @ X


def force_of_spin(lean, precession, spin, *, mass, radius, gravity):
    return mass * radius * spin**2, mass * gravity


def plain_force(*motion, **disk):
    """As a formula gives it: zero where nothing turns, not the rounding of two vectors' products."""
    inward, normal = rolling_force(*motion, **disk)
    return round(inward, 12), normal


def force_normal_first(*motion, **disk):
    return plain_force(*motion, **disk)[::-1]


def residual_of_rolling(lean, precession, spin, inward, normal, *, mass, radius, inertia):
    """The inward force of steady rolling, whatever force is given."""
    needed, _ = rolling_force(lean, precession, spin, mass, radius, 0.0)
    return residual(lean, precession, spin, needed, normal, mass=mass, radius=radius, inertia=inertia)


def force_with(inwards):
    """The normal force right, the inward one inwards(right, lean)."""

    def wrong(lean, *motion, **disk):
        inward, normal = plain_force(lean, *motion, **disk)
        return inwards(inward, lean), normal

    return wrong


def force_on_the_track(lean, precession, spin, **disk):
    """m Omega^2 R."""
    return plain_force(lean, precession, spin - precession * axle(lean) @ Z, **disk)


def force_of_weight_along_the_disk(lean, *motion, **disk):
    inward, normal = plain_force(lean, *motion, **disk)
    return inward, normal * math.cos(lean)


def force_without_weight(*motion, **disk):
    return plain_force(*motion, **{**disk, "gravity": 0.0})


def residual_of_outward_force(lean, precession, spin, inward, normal, **disk):
    return residual(lean, precession, spin, -inward, normal, **disk)


# The draws


def uniform_disk(draw, size):
    return 0.25 * size, 0.5 * size


def hoop(draw, size):
    return 0.5 * size, size


def wheel(draw, size):
    C = draw.uniform(0.2, 1.1) * size
    return C * draw.uniform(0.6, 1.3), C


def roller(draw, size):
    """Long: A larger than C + m a^2."""
    C = draw.uniform(0.3, 0.9) * size
    return (C + size) * draw.uniform(1.5, 3.0), C


def coin(draw, size):
    """Its moments are so small, 1e-6 N m, that many a threshold takes them for zero."""
    return uniform_disk(draw, size)


KINDS = {
    uniform_disk: "a thin uniform disk",
    hoop: "a hoop",
    wheel: "a wheel",
    roller: "a long roller",
    coin: "a disk as small as a coin",
}
THIN_KINDS = KINDS[uniform_disk], KINDS[coin]
WHEELS = (uniform_disk, hoop, wheel)


def a_disk(draw, kind):
    mass, radius = 10 ** draw.uniform(-1, 1), 10 ** draw.uniform(-1.5, 0)
    if kind is coin:
        mass, radius = draw.uniform(2e-3, 6e-3), draw.uniform(8e-3, 12e-3)
    inertia = kind(draw, mass * radius**2)
    return {"mass": mass, "radius": radius, "inertia": inertia, "gravity": draw.uniform(1.6, 25.0)}


def only(disk, *names):
    return {name: disk[name] for name in names}


def a_lean(draw):
    return draw.choice([-1, 1]) * draw.uniform(0.1, 1.35)


def usual(disk):
    """Size of precessions and spins, rad/s."""
    return math.sqrt(disk["gravity"] / disk["radius"])


def usual_force(disk):
    """Size of forces for a unit of mass, m/s^2."""
    return disk["gravity"] or 10.0


def telling(case):
    """Sorts first what tells a suspect from the truth: where a call raises, the ones before it alone are compared."""
    call, _, _, kind = case
    motion = call.args[:2]
    if kind == AGAIN:
        return 3, False
    return (2, False) if 0.0 in motion else (int(motion[-1] > 0.0), kind in THIN_KINDS)


def agree(function, cases, *, of, unit, hint=""):
    """The student's function gives what is right in every case: (call, what is right, scale, kind).

    hint : where to look, or a function of what is found and what is right that says so
    """
    order = sorted(range(len(cases)), key=lambda index: telling(cases[index]))
    asked = [call.on(kind) for call, _, _, kind in cases]
    found = dict(zip(order, function.many([asked[index] for index in order]), strict=True))
    for index, (call, right, scale, kind) in enumerate(cases):
        expect(
            found[index],
            right,
            within=WITHIN,
            scale=scale,
            of=of,
            unit=unit,
            at=call,
            kind=kind,
            hint=partial(hint, found[index], right) if callable(hint) else hint,
        )


SMALL_LEAN = 5e-5  # rad; what it changes is far above any tolerance
STEEP_LEANS = 1.55, math.pi / 2 - 1e-4  # rad; at the second, rounding costs four digits of sixteen
STEEP = "a disk that lies almost flat"
LITTLE_GRAVITY = 1e-2  # m/s^2, of an asteroid: little, and not none
LITTLE = "very little gravity"
AGAIN = "the same arguments as before, but for those of the disk"


def spins(motions, force):
    """The cases of spins of these (lean, precession, disk, kind)."""
    return [
        (
            given(lean, precession, **disk),
            balanced_spin(lean, precession, force, **disk),
            spin_scale(lean, precession, force, **disk),
            kind,
        )
        for lean, precession, disk, kind in motions
    ]


@once
def members(draw, force):
    """Spins at leans and precessions of both signs."""
    motions = []
    for make in (*WHEELS * 4, coin):
        disk, lean = a_disk(draw, make), a_lean(draw)
        precession = draw.choice([-1, 1]) * usual(disk) * draw.uniform(0.3, 3)
        motions.append((lean, precession, disk, KINDS[make]))
    (lean, precession, *_), (_, _, other, _) = motions[:2]
    return spins([*motions, (lean, precession, other, AGAIN)], force)


UNIT = {"mass": 1.0, "radius": 1.0, "inertia": (0.25, 0.5), "gravity": 1.0}  # a thin uniform disk


@once
def plain_members(draw, force):
    """The same for upright disks, without gravity, and for whole numbers."""
    cases = []
    for make in WHEELS:
        disk, precession = a_disk(draw, make), draw.choice([-1, 1]) * draw.uniform(0.5, 5)
        still = {**disk, "gravity": 0.0}
        cases += [(0.0, precession, disk, "an upright disk"), (a_lean(draw), precession, still, "no gravity")]
        cases.append((0.0, precession, still, "an upright disk without gravity"))
    cases.append((draw.choice([-1, 1]) * SMALL_LEAN, precession, disk, "an almost upright disk"))
    cases += [(sign * STEEP_LEANS[0], precession, disk, STEEP) for sign in (1, -1)]
    little = {**disk, "gravity": LITTLE_GRAVITY}
    cases.append((a_lean(draw), usual(little), little, LITTLE))
    cases += [(sign * math.pi / 4, turn, UNIT, "whole numbers") for sign in (1, -1) for turn in (1.0, -1.0)]
    return spins(cases, force)


def smallest_track(lean, *, mass, radius, inertia, gravity):
    """Track radius at which Omega would be infinite."""
    return radius * math.sin(lean) * (1 - inertia[0] / (inertia[1] + mass * radius**2))


@once
def tracks(draw):
    """Precessions on tracks, lean and track radius positive."""
    ways = []
    for make in WHEELS * 4:
        disk, lean = a_disk(draw, make), draw.uniform(0.1, 1.35)
        track = smallest_track(lean, **disk) + disk["radius"] * draw.uniform(0.3, 6)
        ways.append((lean, track, disk, KINDS[make]))
    lean, track, disk, _ = ways[0]
    ways.append((lean, track, {**disk, "gravity": 2 * disk["gravity"]}, AGAIN))
    cases = [(given(*way, **disk), balanced_precession(*way, **disk), kind) for *way, disk, kind in ways]
    return [(call, right, right, kind) for call, right, kind in cases]


@once
def whirls(draw):
    """Leans, precessions, spins and disks without any relation, steady or not."""
    disks = [(a_disk(draw, make), KINDS[make]) for make in (*WHEELS * 4, coin)]
    found = [(draw.uniform(-1.4, 1.4), *(usual(disk) * draw.uniform(-3, 3, 2)), disk, kind) for disk, kind in disks]
    (*motion, _, _), (*_, disk, _) = found[:2]
    steep = [(sign * STEEP_LEANS[0], *motion[1:], disk, STEEP) for sign in (1, -1)]
    return [*found, *steep, (*motion, disk, AGAIN)]


@once
def plain_whirls(draw):
    """Motions in which something is zero: lean, spin, gravity; not the precession, for a circle has one.

    Where there is none the disk rolls straight, which is asked apart.
    """
    cases = []
    for make in WHEELS:
        disk = a_disk(draw, make)
        precession, spin = usual(disk) * draw.uniform(0.3, 3, 2) * draw.choice([-1, 1], 2)
        lean, still = a_lean(draw), {**disk, "gravity": 0.0}
        cases += [
            (0.0, precession, spin, disk, "an upright disk"),
            (lean, precession, 0.0, disk, "no spin"),
            (lean, precession, spin, still, "no gravity"),
        ]
    return [*cases, (math.pi / 4, 1.0, 1.0, UNIT, "whole numbers"), (-math.pi / 4, -1.0, 1.0, UNIT, "whole numbers")]


# (a) Rolling


@check(
    points=1.25,
    part="a",
    suspects=[
        suspect(RELATIVE, rolling_spin=relative_spin(rolling_force)),
        suspect(NO_MA2, rolling_spin=sliding),
        suspect(SWAPPED, rolling_spin=swapped(balanced_spin)),
        suspect(REVERSED, rolling_spin=reversed_sign(balanced_spin)),
        suspect(SPIN_ALONE, rolling_spin=spin_alone(balanced_spin)),
        suspect(THIN, rolling_spin=thin(balanced_spin)),
        suspect(HALF, rolling_spin=half_of_c(balanced_spin)),
        suspect(UNIT_SIZE, rolling_spin=unit_size(balanced_spin)),
        suspect(UNSIGNED, rolling_spin=unsigned(balanced_spin)),
        suspect(SINE, rolling_spin=sine_for_tangent(balanced_spin)),
        suspect(DEGREES, rolling_spin=in_degrees(balanced_spin)),
    ],
)
def rolling_spin_balances_the_moments(student, draw):
    """rolling_spin is the total spin that keeps lean and precession steady, leaning inwards or outwards."""
    agree(
        student.rolling_spin,
        members(draw, rolling_force),
        of="the spin",
        unit="of its largest term",
        hint="moment of the contact force about G = Omega z x H",
    )


@check(points=0.25, part="a", after=rolling_spin_balances_the_moments)
def rolling_spin_holds_upright_and_without_gravity(student, draw):
    """rolling_spin holds for an upright disk and for no gravity."""
    agree(
        student.rolling_spin,
        plain_members(draw, rolling_force),
        of="the spin",
        unit="of its largest term",
        hint="which of its terms are zero there?",
    )


@check(
    points=1,
    part="a",
    suspects=[
        suspect(TO_CENTRE, rolling_track_radius=track_to_centre),
        suspect(
            "the radius without its sign", rolling_track_radius=lambda *args, **disk: abs(rolling_track(*args, **disk))
        ),
        suspect(
            "a sin(lean) taken off where it is to be added",
            rolling_track_radius=lambda lean, *args, **disk: (
                rolling_track(lean, *args, **disk) - 2 * rim(lean, disk["radius"]) @ X
            ),
        ),
        suspect(RELATIVE, rolling_track_radius=track_by_relative_spin),
        suspect(SWAPPED, rolling_track_radius=swapped(rolling_track)),
        suspect(NO_MA2, rolling_track_radius=track_with(sliding)),
        suspect(SPIN_ALONE, rolling_track_radius=spin_alone(rolling_track)),
        suspect(THIN, rolling_track_radius=thin(rolling_track)),
        suspect(HALF, rolling_track_radius=half_of_c(rolling_track)),
        suspect(UNIT_SIZE, rolling_track_radius=track_with(unit_size(balanced_spin))),
        suspect(UNSIGNED, rolling_track_radius=track_with(unsigned(balanced_spin))),
        suspect(SINE, rolling_track_radius=sine_for_tangent(rolling_track)),
        suspect(DEGREES, rolling_track_radius=in_degrees(rolling_track)),
    ],
)
def rolling_track_has_the_contact_at_rest(student, draw):
    """rolling_track_radius is the radius, with its sign, of the contact point's track."""
    for drawn in (members, plain_members):
        agree(
            student.rolling_track_radius,
            contact_tracks(drawn(draw, rolling_force)),
            of="the radius of the track",
            unit="of its largest term",
            hint="the point of the disk on the ground has no velocity",
        )


def contact_tracks(cases_of_spin):
    """The cases of track radii made of those of spins."""
    cases = []
    for call, spin, size, kind in cases_of_spin:
        (lean, precession), radius = call.args, call.kwargs["radius"]
        scale = radius * (1 + size / abs(precession))
        cases.append((call, track_of(lean, precession, spin, radius), scale, kind))
    return cases


@check(
    points=1.25,
    part="a",
    suspects=[
        suspect(TO_CENTRE, rolling_precession=precession_to_centre),
        suspect(RELATIVE, rolling_precession=precession_with_relative_spin),
        suspect(SWAPPED, rolling_precession=swapped(balanced_precession)),
        suspect(NO_MA2, rolling_precession=precession_without_ma2),
        suspect(REVERSED, rolling_precession=reversed_sign(balanced_precession)),
        suspect(SPIN_ALONE, rolling_precession=spin_alone(balanced_precession)),
        suspect(THIN, rolling_precession=thin(balanced_precession)),
        suspect(HALF, rolling_precession=half_of_c(balanced_precession)),
        suspect(SINE, rolling_precession=sine_for_tangent(balanced_precession)),
        suspect(DEGREES, rolling_precession=in_degrees(balanced_precession)),
    ],
)
def rolling_precession_balances_the_moments(student, draw):
    """rolling_precession keeps the lean steady on the given track."""
    agree(
        student.rolling_precession,
        tracks(draw),
        of="the precession",
        unit="of itself",
        hint="put the rolling condition into the balance of moments about G",
    )


@check(points=0.5, part="a", after=rolling_precession_balances_the_moments)
def rolling_precession_holds_on_tracks_of_any_sign(student, draw):
    """rolling_precession holds with the contact beyond the centre, for a roller, for a coin, and almost flat."""
    mirrored = [
        (given(*(-x for x in call.args), **call.kwargs), right, right, "lean and track radius both negative")
        for call, right, _, _ in tracks(draw)[:4]
    ]
    disk, lean = a_disk(draw, roller), draw.uniform(0.2, 1.2)
    right = balanced_precession(lean, 0.0, **disk)
    still = (given(lean, 0.0, **disk), right, right, "a long roller whose contact rests")
    track = smallest_track(lean, **disk) * draw.uniform(0.2, 0.8)
    right = balanced_precession(lean, track, **disk)
    beyond = [
        (
            given(sign * lean, sign * track, **disk),
            right,
            right,
            "a long roller whose contact lies beyond the centre of the circle",
        )
        for sign in (1, -1)
    ]
    disk, lean = a_disk(draw, coin), draw.uniform(0.2, 1.2)
    track = smallest_track(lean, **disk) + disk["radius"] * draw.uniform(0.3, 0.6)
    right = balanced_precession(lean, track, **disk)
    small = (given(lean, track, **disk), right, right, KINDS[coin])
    steep = [almost_flat(lean, tracks(draw)[0][0].kwargs) for lean in STEEP_LEANS]
    agree(
        student.rolling_precession,
        [*mirrored, still, *beyond, small, *steep],
        of="the precession",
        unit="of itself",
        hint="which sign must the moment of the weight have?",
    )


def almost_flat(lean, disk):
    track = smallest_track(lean, **disk) + disk["radius"]
    right = balanced_precession(lean, track, **disk)
    return given(lean, track, **disk), right, right, STEEP


@check(points=0.5, part="a", after=rolling_precession_balances_the_moments)
def rolling_precession_is_zero_where_nothing_turns_it(student, draw):
    """rolling_precession is 0 without gravity, for an upright disk on a track that is no point, and only there."""
    plain, signed = [], []
    for make in WHEELS:
        disk, R = a_disk(draw, make), draw.uniform(2, 5)  # m, wider than any smallest track
        lean, still = draw.uniform(0.2, 1.2), {**disk, "gravity": 0.0}
        plain.append((given(lean, R, **still), 0.0, 1.0, "no gravity"))
        little = {**disk, "gravity": LITTLE_GRAVITY}
        plain.append((given(lean, R, **little), balanced_precession(lean, R, **little), 1.0, LITTLE))
        right = balanced_precession(SMALL_LEAN, R, **disk)
        for sign, word in ((1, "positive"), (-1, "negative")):
            plain += [
                (given(0.0, sign * track, **disk), 0.0, 1.0, f"an upright disk and a {word} track radius{size}")
                for track, size in ((R, ""), (0.05 * disk["radius"], ", far below the radius of the disk"))
            ]
            signed += [
                (given(-sign * lean, sign * R, **still), 0.0, 1.0, "no gravity, and a lean away from the centre"),
                (given(sign * SMALL_LEAN, sign * R, **disk), right, 1.0, "an almost upright disk"),
            ]
    for cases in (plain, signed):
        agree(student.rolling_precession, cases, of="the precession", unit="rad/s")


@check(points=0.75, part="a", after=rolling_precession_balances_the_moments)
def rolling_precession_refuses_what_does_not_exist(student, draw):
    """rolling_precession raises ValueError where no steady rolling exists, or every Omega would do."""
    for make in WHEELS:
        disk, lean = a_disk(draw, make), draw.uniform(0.2, 1.2)
        wide, tight = (disk["radius"] * draw.uniform(0.5, 5), smallest_track(lean, **disk) * draw.uniform(0.1, 0.9))
        refused = (
            (-lean, wide, "a disk that leans away from the centre"),
            (lean, -wide, "a disk that leans away from the centre, seen in a mirror"),
            (lean, tight, "a track too tight for the lean"),
            (0.0, 0.0, "an upright disk on a point, where every Omega will do"),
            (-SMALL_LEAN, wide, "a disk that leans away from the centre by very little"),
        )
        for *call, kind in refused:
            refuses(student, *call, kind, disk)
    for lean in (ROUNDED_NOWHERE, -ROUNDED_NOWHERE):
        kind = "a roller that turns on a point, its lean tiny but not zero, where Omega drops out"
        refuses(student, lean, 0.0, kind, long_hoop(draw))


ROUNDED_NOWHERE = 2.0**-30  # rad; it is its own sine and tangent, and its cosine is one


def long_hoop(draw):
    """A = C + m a^2, with which no Omega bears the weight on a point; powers of two, so that no formula is rounded."""
    mass, radius, gravity = 2.0 ** draw.integers([-1, -3, 1], [3, 1, 5])
    size = mass * radius**2
    return {"mass": mass, "radius": radius, "inertia": (2 * size, size), "gravity": gravity}


def refuses(student, lean, track, kind, disk):
    expect_that(
        student.on(kind).rolling_precession.refuses(lean, track, **disk),
        "rolling_precession does not raise ValueError",
        kind=kind,
        at=(lean, track, disk),
        hint="what would Omega^2 be?",
    )


# (b) Sliding


@check(
    points=0.75,
    part="b",
    suspects=[
        suspect(RELATIVE, sliding_spin=relative_spin(sliding_force)),
        suspect("the spin of the rolling disk", sliding_spin=balanced_spin),
        suspect(SWAPPED, sliding_spin=swapped(sliding)),
        suspect(SPIN_ALONE, sliding_spin=spin_alone(sliding)),
        suspect(THIN, sliding_spin=thin(sliding)),
        suspect(HALF, sliding_spin=half_of_c(sliding)),
        suspect(UNSIGNED, sliding_spin=unsigned(sliding)),
        suspect(SINE, sliding_spin=sine_for_tangent(sliding)),
        suspect(DEGREES, sliding_spin=in_degrees(sliding)),
    ],
)
def sliding_spin_balances_the_moments(student, draw):
    """sliding_spin is the total spin that keeps lean and precession steady where only the normal force acts."""
    agree(
        student.sliding_spin,
        members(draw, sliding_force),
        of="the spin",
        unit="of its largest term",
        hint="which part of the contact force is gone?",
    )
    agree(
        student.sliding_spin,
        plain_members(draw, sliding_force),
        of="the spin",
        unit="of its largest term",
        hint="which of its terms are zero there?",
    )


@check(
    points=0.5,
    part="b",
    suspects=[
        suspect(TO_CENTRE, sliding_track_radius=lambda lean, *, radius: 0.0),
        suspect("the cosine of the lean", sliding_track_radius=lambda lean, *, radius: radius * math.cos(lean)),
        suspect(REVERSED, sliding_track_radius=lambda lean, *, radius: -radius * math.sin(lean)),
        suspect(
            "the lean taken without its sign", sliding_track_radius=lambda lean, *, radius: radius * math.sin(abs(lean))
        ),
        suspect(DEGREES, sliding_track_radius=in_degrees(lambda lean, *, radius: rim(lean, radius) @ X)),
    ],
)
def sliding_track_is_around_the_resting_centre(student, draw):
    """sliding_track_radius is the contact's distance from the vertical through G, signed as R is."""
    leans = [*(a_lean(draw) for _ in range(10)), 0.0]
    leans += [leans[0], STEEP_LEANS[0], -STEEP_LEANS[0]]
    radii = 10 ** draw.uniform(-1.5, 1, len(leans))
    cases = [
        (given(lean, radius=a), rim(lean, a) @ X, a, SIGNS[np.sign(lean)]) for lean, a in zip(leans, radii, strict=True)
    ]
    cases.sort(key=lambda case: list(SIGNS.values()).index(case[3]))  # a sign is named if it is what matters
    agree(student.sliding_track_radius, cases, of="the radius of the track", unit="of the disk's", hint="where is G?")


SIGNS = {1: "a lean inwards", -1: "a negative lean", 0: "an upright disk"}


# (c) Both


def other_gravities(call):
    """(lean, disk, kind): the lean of this call with another gravity, and its negative with very little of it."""
    (lean,), disk = call.args, call.kwargs
    again, little = ({**disk, "gravity": g} for g in (2 * disk["gravity"], LITTLE_GRAVITY))
    return [(lean, again, AGAIN), (-lean, little, LITTLE)]


def steep_leans(disk):
    """The same for disks that lie almost flat."""
    return [(sign * lean, disk, STEEP) for lean in STEEP_LEANS for sign in (1, -1)]


@check(
    points=0.75,
    part="c",
    suspects=[
        suspect(SWAPPED, common_precession=swapped(common)),
        suspect("A + m a^2 taken for A, as if G moved", common_precession=about_contact(common)),
        suspect(THIN, common_precession=thin(common)),
        suspect(HALF, common_precession=half_of_c(common)),
        suspect(DEGREES, common_precession=in_degrees(common)),
    ],
)
def common_precession_is_in_both_families(student, draw):
    """common_precession is that of the motions which roll and slide at once."""
    cases = []
    for make in (*WHEELS * 3, coin):
        disk, lean = a_disk(draw, make), a_lean(draw)
        right = common(lean, **disk)
        cases.append((given(lean, **disk), right, right, KINDS[make]))
    right = common(math.pi / 4, **UNIT)
    cases += [(given(sign * math.pi / 4, **UNIT), right, right, "whole numbers") for sign in (1, -1)]
    for lean, disk, kind in other_gravities(cases[0][0]):
        right = common(lean, **disk)
        cases.append((given(lean, **disk), right, right, kind))
    agree(
        student.common_precession,
        cases,
        of="the precession",
        unit="of itself",
        hint="both tracks must be the same circle: what is the spin then?",
    )


@check(points=0.25, part="c", after=common_precession_is_in_both_families)
def common_precession_has_a_limit_upright(student, draw):
    """common_precession at lean 0 is its limit, next to 0 it is near, and almost flat it holds."""
    for lean in (0.0, 1e-9, -1e-9):
        disk = a_disk(draw, wheel)
        right, kind = common(1e-4, **disk), "an upright disk" if lean == 0.0 else "an almost upright disk"
        expect(
            student.on(kind).common_precession(lean, **disk),
            right,
            scale=right,
            of="the precession",
            within=1e-7,  # the lean enters by its square, 1e-8
            unit="of itself",
            at=(lean, disk),
            kind=kind,
            hint="cancel the sine first",
        )
    for lean, steep, kind in steep_leans(disk):
        right = common(lean, **steep)
        expect(
            student.on(kind).common_precession(lean, **steep),
            right,
            within=WITHIN,
            scale=right,
            of="the precession",
            unit="of itself",
            at=(lean, steep),
            kind=kind,
        )


@check(
    points=0.5,
    part="c",
    suspects=[
        suspect(RELATIVE, contact_force=by_relative_spin(rolling_force)),
        suspect("m a spin^2 for the mass times the centripetal acceleration", contact_force=force_of_spin),
        suspect("the sign of the inward force turned round", contact_force=force_with(lambda inward, lean: -inward)),
        suspect("the inward force taken without its sign", contact_force=force_with(lambda inward, lean: abs(inward))),
        suspect(
            "the cosine of the lean in the inward force, which is horizontal",
            contact_force=force_with(lambda inward, lean: inward * math.cos(lean)),
        ),
        suspect("no inward force, as on the disk that slides", contact_force=force_with(lambda inward, lean: 0.0)),
        suspect("R, of the contact's track, for the radius of the circle of G", contact_force=force_on_the_track),
        suspect("no weight in the normal force", contact_force=force_without_weight),
        suspect(
            "the cosine of the lean in the normal force, which is vertical",
            contact_force=force_of_weight_along_the_disk,
        ),
        suspect("the normal force first; the inward force is asked first", contact_force=force_normal_first),
    ],
)
def contact_force_moves_the_centre(student, draw):
    """contact_force gives the mass its centripetal acceleration and carries its weight."""
    cases = []
    for lean, precession, spin, disk, kind in whirls(draw) + plain_whirls(draw):
        disk = only(disk, "mass", "radius", "gravity")
        scale = disk["mass"] * (disk["gravity"] + disk["radius"] * (abs(precession * spin) + precession**2))
        right = rolling_force(lean, precession, spin, **disk)
        cases.append((given(lean, precession, spin, **disk), right, scale, kind))
    agree(student.contact_force, cases, of="the force", unit="of the forces at work", hint=wrong_force)


@check(points=0.25, part="c", after=contact_force_moves_the_centre)
def contact_force_of_straight_rolling(student, draw):
    """contact_force: an upright disk without precession rolls straight on, and the ground carries its weight."""
    disk = only(a_disk(draw, wheel), "mass", "radius", "gravity")
    weight = disk["mass"] * disk["gravity"]
    for spin, kind in ((usual(disk), "straight rolling, upright"), (0.0, "an upright disk at rest")):
        found = student.on(kind).contact_force(0.0, 0.0, spin, **disk)
        expect(
            found,
            (0.0, weight),
            within=WITHIN,
            scale=weight,
            of="the force",
            unit="of the weight",
            kind=kind,
            at=(spin, disk),
            hint="nothing there goes round",
        )


def wrong_force(found, right):
    """Which part of the force is wrong, and where it comes from."""
    inward, normal = np.isclose(found, right)
    if normal and not inward:
        return "only the inward force is: G moves on a circle; what is its radius, and G's speed?"
    if inward and not normal:
        return "only the normal force is: how does the height of G change?"
    return "(inward, normal): F = m a of G, which moves on a circle"


@check(
    points=0.75,
    part="c",
    suspects=[
        suspect(RELATIVE, moment_residual=by_relative_spin(residual)),
        suspect(SWAPPED, moment_residual=swapped(residual)),
        suspect(REVERSED, moment_residual=reversed_sign(residual)),
        suspect(SPIN_ALONE, moment_residual=spin_alone(residual)),
        suspect(THIN, moment_residual=thin(residual)),
        suspect(HALF, moment_residual=half_of_c(residual)),
        suspect("C + m a^2 for C: the moments are about G, and the force is given", moment_residual=with_ma2(residual)),
        suspect("the inward force of steady rolling, not the one given", moment_residual=residual_of_rolling),
        suspect("the moment of the inward force turned round", moment_residual=residual_of_outward_force),
    ],
)
def moment_residual_is_moment_minus_rate(student, draw):
    """moment_residual is the moment about G less the rate of angular momentum, for any motion and force."""
    cases = []
    whirling = whirls(draw) + plain_whirls(draw)
    straight = [(lean, 0.0, spin, disk, "no precession") for lean, _, spin, disk, _ in whirling[-6:]]
    for lean, precession, spin, disk, kind in whirling + straight:
        inward, normal = disk["mass"] * usual_force(disk) * draw.uniform(-2, 2, 2)
        if len(cases) % 5 == 4:
            inward, kind = 0.0, f"{kind}, no inward force"
        disk = only(disk, "mass", "radius", "inertia")
        scale = disk["radius"] * (abs(inward) + abs(normal)) + sum(disk["inertia"]) * (precession**2 + spin**2)
        motion = (lean, precession, spin, inward, normal)
        cases.append((given(*motion, **disk), residual(*motion, **disk), scale, kind))
    call, _, scale, _ = cases[0]
    other = {**call.kwargs, "inertia": tuple(2 * it for it in call.kwargs["inertia"])}
    cases.append((given(*call.args, **other), residual(*call.args, **other), 2 * scale, AGAIN))
    agree(
        student.moment_residual,
        cases,
        of="the residual",
        unit="of its terms",
        hint="Omega z x H: which parts of H go round?",
    )


# (d) The shuddering coin


@check(
    points=0.75,
    part="d",
    suspects=[
        suspect("the potential energy alone", settling_energy=potential),
        suspect(
            "Omega, about the vertical, for the rate at which the disk turns about its diameter",
            settling_energy=energy_with(lambda lean, p, inertia: 0.5 * inertia[0] * p**2),
        ),
        suspect(
            HALF,
            settling_energy=energy_with(lambda lean, p, inertia: turning_energy(lean, p, (inertia[1] / 2, inertia[1]))),
        ),
        suspect("the kinetic energy alone", settling_energy=settling_kinetic_energy),
        suspect(
            "the potential 0 where G of the upright disk is; it is 0 with G on the ground",
            settling_energy=lambda lean, **disk: settled(lean, **disk) - potential(0.0, **disk),
        ),
        suspect(
            "the sine for the cosine: the lean is measured from the vertical",
            settling_energy=lambda lean, **disk: settled(lean, **disk) * math.tan(lean),
        ),
    ],
)
def settling_energy_adds_up(student, draw):
    """settling_energy is the kinetic and potential energy of the motion that rolls and slides at once."""
    cases = []
    for make in (*WHEELS * 3, coin):
        disk, lean = a_disk(draw, make), a_lean(draw)
        scale = disk["mass"] * disk["gravity"] * disk["radius"]
        cases.append((given(lean, **disk), settled(lean, **disk), scale, KINDS[make]))
        if len(cases) % 3 == 1:
            cases.append((given(0.0, **disk), settled(0.0, **disk), scale, "an upright disk"))
    call, *_ = cases[0]
    for lean, disk, kind in [*other_gravities(call), *steep_leans(call.kwargs)]:
        scale = disk["mass"] * disk["gravity"] * disk["radius"]
        cases.append((given(lean, **disk), settled(lean, **disk), scale, kind))
    agree(
        student.settling_energy,
        cases,
        of="the energy",
        unit="of m g a",
        hint="G is at rest; about which axis does the disk turn?",
    )
