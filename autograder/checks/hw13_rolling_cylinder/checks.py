"""Hidden checks of hw13. What is right is solved for, with the force, from the balances of momentum about G.

Axes: x down the ramp, y off it; a cylinder that rolls down turns clockwise.
"""

import math
from functools import partial

import numpy as np

from tam570.integrate import solve
from tam570_grader import (
    Failed,
    check,
    expect,
    expect_that,
    given,
    group,
    mistimed,
    number,
    once,
    rows,
    suspect,
    uneven,
)

RESULTS = {
    "acceleration": number,
    "contact_inertia": number,
    "naive_contact_acceleration": number,
    "missing_moment": number,
    "contact_force": group(number, number),
    "energy": number,
    "simulate": rows(2),
}
NEEDS = ("numpy",)
MANUAL = {"b": (2, "why the two methods agree for the centred cylinder and not for the other")}

FORMULA = 1e-9  # of the largest term: solving for the forces costs a few digits of 1e-16; wrong terms are off by .1
# solve_ivp at rtol = atol = 1e-9, whatever its method, stays below 1e-7 on these runs; wrong physics is off by .1.
TRAJECTORY = 1e-6
ENERGY = 5e-6  # the same integrators drift by up to 4e-7 on the longer runs


# The balances, in vectors


def arms(phi, radius, offset):
    """G from the contact C, and its first and second derivatives over phi (G from the ramp's origin moves along)."""
    c, s = offset * math.cos(phi), offset * math.sin(phi)
    return np.array([-s, radius - c]), np.array([radius - c, s]), np.array([s, c])


def clockwise(r, force):
    return r[1] * force[0] - r[0] * force[1]


def weight(mass, gravity, slope):
    return mass * gravity * np.array([math.sin(slope), -math.cos(slope)])


def balanced(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    """(phi'', along, normal): m a = weight + contact force, I phi'' = its moment about G."""
    arm, first, second = (it.tolist() for it in arms(phi, radius, offset))
    from_G = -arm[0], -arm[1]  # to C
    pull = weight(mass, gravity, slope).tolist()
    known = [mass * it * phi_dot**2 - w for it, w in zip(second, pull, strict=True)]  # the force, but for m first phi''
    phi_ddot = clockwise(from_G, known) / (inertia - mass * clockwise(from_G, first))
    along, normal = (mass * it * phi_ddot + rest for it, rest in zip(first, known, strict=True))
    return np.array([phi_ddot, along, normal])


def about_contact(phi, *, mass, radius, offset, inertia):
    arm = arms(phi, radius, offset)[0]
    return inertia + mass * (arm @ arm)


def moment_of_weight(phi, *, mass, radius, offset, slope, gravity, **_):
    return clockwise(arms(phi, radius, offset)[0], weight(mass, gravity, slope))


def total_energy(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    arm, first, _ = arms(phi, radius, offset)
    position = arm + np.array([radius * phi, -radius])  # of G from where the centre is at phi = 0
    speed_squared = first @ first * phi_dot**2
    return (mass * speed_squared + inertia * phi_dot**2) / 2 - weight(mass, gravity, slope) @ position


def missing(phi, phi_dot, *, mass, radius, offset):
    """What is left of I^C phi'' where there is no weight: M_C is zero. It is the same for any inertia."""
    body = {"mass": mass, "radius": radius, "offset": offset, "inertia": mass * radius**2}
    phi_ddot = balanced(phi, phi_dot, slope=0.0, gravity=0.0, **body)[0]
    return -about_contact(phi, **body) * phi_ddot


# Wrong answers that are known


def naive(phi, **cylinder):
    body = {name: cylinder[name] for name in ("mass", "radius", "offset", "inertia")}
    return moment_of_weight(phi, **cylinder) / about_contact(phi, **body)


def with_missing(factor):
    """The acceleration with so many times the missing moment."""

    def acceleration(phi, phi_dot, **cylinder):
        right = balanced(phi, phi_dot, **cylinder)[0]
        return naive(phi, **cylinder) + factor * (right - naive(phi, **cylinder))

    return acceleration


def more_by_slope(phi, times, *, mass, radius, offset, inertia, slope, gravity):
    """What phi'' is larger by with the sine of phi and so many times the slope in the moment of the weight at G."""
    more = mass * gravity * offset * (math.sin(phi + slope) - math.sin(phi + times * slope))
    return more / about_contact(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)


def with_slopes(times):
    """The acceleration with the weight at G in another direction, and at O where it is."""

    def acceleration(phi, phi_dot, **cylinder):
        return balanced(phi, phi_dot, **cylinder)[0] + more_by_slope(phi, times, **cylinder)

    return acceleration


def offset_reversed(function):
    return lambda *args, offset, **rest: function(*args, offset=-offset, **rest)


def acceleration_of(*args, **cylinder):
    return balanced(*args, **cylinder)[0]


def force_of(phi, phi_dot, **cylinder):
    """(along, normal) with the acceleration of another formula."""
    return tuple(balanced(phi, phi_dot, **cylinder)[1:])


def force_from(acceleration, centripetal=1.0, about_centre=1.0):
    """The force for this phi'', with so much of the centripetal part of G's acceleration, and of alpha x r."""

    def contact_force(phi, phi_dot, **cylinder):
        _, first, second = arms(phi, cylinder["radius"], cylinder["offset"])
        centre = np.array([cylinder["radius"], 0.0])
        first = centre + about_centre * (first - centre)
        of_G = first * acceleration(phi, phi_dot, **cylinder) + centripetal * second * phi_dot**2
        m = cylinder["mass"]
        return tuple(m * of_G - weight(m, cylinder["gravity"], cylinder["slope"]))

    return contact_force


def force_by(part):
    """The force with part(m, r, a_G, its share by phi'', phi'', weight) in place of (along, normal)."""

    def contact_force(phi, phi_dot, **cylinder):
        m, r = cylinder["mass"], cylinder["radius"]
        _, first, second = arms(phi, r, cylinder["offset"])
        phi_ddot = acceleration_of(phi, phi_dot, **cylinder)
        by_turning = first * phi_ddot
        pull = weight(m, cylinder["gravity"], cylinder["slope"])
        of_G = by_turning + second * phi_dot**2
        right = m * of_G - pull
        return tuple(
            right if wrong is None else wrong
            for wrong, right in zip(part(m, r, of_G, by_turning, phi_ddot, pull), right, strict=True)
        )

    return contact_force


# (along, normal), None where it is right
WRONG_PARTS = {
    "the acceleration of the centre along the ramp, r phi'', for that of G": lambda m, r, a, turned, turning, w: (
        m * r * turning - w[0],
        None,
    ),
    "a normal force that carries the weight alone, as at rest": lambda m, r, a, turned, turning, w: (None, -w[1]),
    "a force along the ramp that holds the weight alone, as at rest": lambda m, r, a, turned, turning, w: (-w[0], None),
    "the acceleration of G off the ramp without its part with phi''": lambda m, r, a, turned, turning, w: (
        None,
        m * (a - turned)[1] - w[1],
    ),
    "the acceleration of G off the ramp, the wrong sign of its part with phi_dot squared": (
        lambda m, r, a, turned, turning, w: (None, m * (2 * turned - a)[1] - w[1])
    ),
    "the weight left out of the force along the ramp": lambda m, r, a, turned, turning, w: (m * a[0], None),
    "the weight without the cosine of the slope in the normal force": lambda m, r, a, turned, turning, w: (
        None,
        m * a[1] + math.hypot(*w),
    ),
}


def up_the_ramp(*args, **cylinder):
    along, normal = force_of(*args, **cylinder)
    return -along, normal


def with_slope(change, function):
    return lambda *args, slope, **rest: function(*args, slope=change(slope), **rest)


def moved(t, *start, **cylinder):
    """Right states at t, within 1e-9."""

    def rates(_, state):
        return state[1], acceleration_of(*state, **cylinder)

    return solve(rates, t, start, rtol=1e-12, method="python")


def integrated(acceleration):
    """A simulation with a wrong acceleration, or with wrong times, which may run backwards; within 1e-9."""

    def simulate(t, phi, phi_dot, **cylinder):
        from scipy.integrate import solve_ivp

        def rates(_, state):
            return state[1], acceleration(*state, **cylinder)

        # short steps where it interpolates between them
        longest = (t[-1] - t[0]) / 60 if len(t) > 2 else np.inf
        options = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-11, "max_step": longest}
        return solve_ivp(rates, (t[0], t[-1]), [phi, phi_dot], t_eval=t, **options).y.T

    return simulate


def still_without_gravity(*args, **cylinder):
    return acceleration_of(*args, **cylinder) if cylinder["gravity"] else 0.0


def loosely(t, phi, phi_dot, **cylinder):
    """solve_ivp as it is when nothing is said of its tolerances."""
    from scipy.integrate import solve_ivp

    def rates(_, state):
        return state[1], acceleration_of(*state, **cylinder)

    return solve_ivp(rates, (t[0], t[-1]), [phi, phi_dot], t_eval=t).y.T


def rolled(t, *start, **cylinder):
    return integrated(acceleration_of)(t, *start, **cylinder)


def wrapped(least):
    """A simulation with phi wrapped to a turn that starts there."""

    def simulate(t, *start, **cylinder):
        states = rolled(t, *start, **cylinder)
        return np.column_stack([(states[:, 0] - least) % (2 * math.pi) + least, states[:, 1]])

    return simulate


def from_time_zero(t, *start, **cylinder):
    return rolled(t, *rolled(np.array([0.0, t[0]]), *start, **cylinder)[1], **cylinder)


def standing(t, phi, phi_dot, **_):
    return np.tile([phi, phi_dot], (len(t), 1))


# A suspect shows in the first call of a check: where a later call raises, what it shares with the truth is no evidence.
DEGREES = "the slope taken for degrees"
STILL = "no change of phi_dot where there is no gravity"
WRONG_ACCELERATIONS = {
    "M_C = I^C phi'', which leaves out that G is not above C": with_missing(0),
    "half the term that M_C = I^C phi'' lacks": with_missing(0.5),
    "twice the term that M_C = I^C phi'' lacks": with_missing(2),
    "the term that M_C = I^C phi'' lacks, its sign reversed": with_missing(-1),
    "G on the other side of the centre": offset_reversed(acceleration_of),
    DEGREES: with_slope(math.radians, acceleration_of),
    "the moment of the weight at G with sin(phi), where sin(phi + slope) belongs": with_slopes(0),
    "the moment of the weight at G with sin(phi - slope), where sin(phi + slope) belongs": with_slopes(-1),
}
WRONG_SIMULATIONS = {
    **{says: integrated(wrong) for says, wrong in WRONG_ACCELERATIONS.items()},
    "phi wrapped to half a turn to either side": wrapped(-math.pi),
    "phi wrapped to a turn from 0": wrapped(0.0),
}
LOOSE = {"the tolerances that solve_ivp has when none are given": loosely}
STANDS = {"a start at rest, or nearly so, that stays where it is": standing}
ACCELERATION_SUSPECTS = [suspect(says, acceleration=wrong) for says, wrong in WRONG_ACCELERATIONS.items()]


def simulations(wrong, within=1e-4):
    return [suspect(says, within=within, simulate=function) for says, function in wrong.items()]


ANY_TIMES = [
    *simulations(WRONG_SIMULATIONS),
    *mistimed(rolled, from_time_zero),
    *simulations(LOOSE, 1e-6),  # its steps are the same, whoever takes them
]


# Cylinders and motions


def cylinder(draw, **fixed):
    mass, radius = draw.uniform(0.3, 5), draw.uniform(0.2, 3)
    drawn = {
        "mass": mass,
        "radius": radius,
        "offset": radius * draw.uniform(0.3, 0.6),
        "inertia": mass * radius**2 * draw.uniform(0.2, 0.8),
        "slope": draw.uniform(0.15, 1.2),
        "gravity": draw.uniform(1, 20),
    }
    return {**drawn, **fixed}


def usual(cylinder):
    """Size of rates, rad/s."""
    return math.sqrt((cylinder["gravity"] or 5.0) / cylinder["radius"])


def cases(draw, count, **fixed):
    """Angles of several turns, both signs of the rate: (phi, phi_dot, cylinder)."""
    drawn = [cylinder(draw, **fixed) for _ in range(count)]
    return [(draw.uniform(-9, 9), draw.choice([-1, 1]) * draw.uniform(0.5, 2) * usual(c), c) for c in drawn]


QUARTERS = np.array([0, 1, -1, 2]) * math.pi / 2


def plain_cases(draw):
    """As `cases`: phi of no and of quarter turns, at rest or not, on ramps down and up, G off the centre or not."""
    down = cylinder(draw)
    ones = {"mass": 1.0, "radius": 1.0, "offset": 0.5, "inertia": 0.5, "slope": math.pi / 6, "gravity": 1.0}
    return turning([down, {**down, "slope": -down["slope"]}, cylinder(draw, offset=0.0), ones])


def level_cases(draw):
    """The same on level ground and without gravity."""
    return turning([cylinder(draw, slope=0.0), cylinder(draw, gravity=0.0)])


def turning(cylinders):
    return [(angle, sign * usual(c), c) for c in cylinders for angle in QUARTERS for sign in (0.0, 1.0, -1.0)]


ANGLES = ("phi = 0", "phi a quarter turn", "phi a quarter turn back", "phi half a turn")


def kind_of(motion, cylinder, names):
    """What is special comes first; of the parameters only those that the function is given."""
    phi, *rate = motion
    special = {
        "G at the centre": cylinder["offset"] == 0,
        "no gravity": "gravity" in names and cylinder["gravity"] == 0,
        "level ground": "slope" in names and cylinder["slope"] == 0,
        "a ramp upwards": "slope" in names and cylinder["slope"] < 0,
    }
    angles = [name for name, angle in zip(ANGLES, QUARTERS, strict=True) if angle == phi] or ["any angle"]
    signs = {0: "at rest", 1: "phi_dot above 0", -1: "phi_dot below 0"}
    return ", ".join([says for says, it in special.items() if it] + angles + [signs[np.sign(it)] for it in rate])


def calls(of, *names, kind=""):
    """One call for each case, with these of the parameters, and of what kind it is."""
    return [
        given(*motion, **{name: c[name] for name in names}).on(kind or kind_of(motion, c, names)) for *motion, c in of
    ]


def moment_scale(phi, phi_dot, cylinder):
    return cylinder["mass"] * cylinder["radius"] ** 2 * (usual(cylinder) ** 2 + phi_dot**2)


def parts(cylinder, *names):
    return {name: cylinder[name] for name in names}


BODY = ("mass", "radius", "offset", "inertia")
ALL = (*BODY, "slope", "gravity")


# Part a: I^G and I^C


def judge_accelerations(student, of, hint):
    asked = calls(of, *ALL)
    for found, call, (phi, phi_dot, c) in zip(student.acceleration.many(asked), asked, of, strict=True):
        expect(
            found,
            balanced(phi, phi_dot, **c)[0],
            within=FORMULA,
            scale=acceleration_scale(phi, phi_dot, c),
            of="phi''",
            unit="of the size of its terms",
            kind=call.kind,
            hint=hint,
            at=(phi, phi_dot, c),
        )


def acceleration_scale(phi, phi_dot, c):
    return moment_scale(phi, phi_dot, c) / about_contact(phi, **parts(c, *BODY))


def hint_of_rates(student, of):
    """Which terms are wrong: the same places are asked at rest."""
    still = [(phi, 0.0, c) for phi, _, c in of]
    try:
        found = student.acceleration.many(calls(still, *ALL))
    except Failed:
        return "what is it at rest?"
    errors = [
        abs(value - acceleration_of(*motion, **c)) / acceleration_scale(*motion, c)
        for value, (*motion, c) in zip(found, still, strict=True)
    ]
    if max(errors) <= FORMULA:
        return "at rest it is right: differentiate the position of G twice, and mind the terms in phi_dot squared"
    return "at rest it is wrong, too: look at the moment of the weight and at the inertia"


@check(points=0.5, part="a")
def centred_cylinder_rolls_by_both_methods(student, draw):
    """With G at the centre, acceleration and naive_contact_acceleration are both right."""
    of = cases(draw, 8, offset=0.0)
    judge_accelerations(student, of, "balance momentum about G: friction alone turns it")
    asked = calls(at_rest(of), *ALL)
    found = student.naive_contact_acceleration.many(asked)
    for value, call, (phi, phi_dot, c) in zip(found, asked, of, strict=True):
        right = balanced(phi, phi_dot, **c)[0]
        expect(
            value / right,
            1,
            within=FORMULA,
            of="phi'' from M_C = I^C phi''",
            unit="of itself",
            kind=call.kind,
            at=(phi, c),
        )


@check(points=1.5, part="a", suspects=ACCELERATION_SUSPECTS)
def acceleration_balances_momentum_about_G(student, draw):
    """acceleration: the force of the ramp that G's acceleration needs gives, about G, the moment I^G phi''."""
    of = cases(draw, 20)
    judge_accelerations(student, of, lambda: hint_of_rates(student, of))
    judge_accelerations(student, plain_cases(draw), "which terms are zero there?")


@check(points=0.5, part="a", after=acceleration_balances_momentum_about_G)
def acceleration_level_and_without_gravity(student, draw):
    """acceleration: on level ground, and without gravity."""
    judge_accelerations(student, cases(draw, 5, slope=0.0), "is anything divided by the slope?")
    weightless = cases(draw, 5, gravity=0.0)
    judge_accelerations(student, weightless, "without weight it still does not turn uniformly")
    judge_accelerations(student, level_cases(draw), "which terms are zero?")


def at_rest(of):
    return [(phi, c) for phi, _, c in of]


CONTACT_INERTIA_SUSPECTS = [
    suspect(
        "the height of G above the ramp for its distance from C",
        contact_inertia=lambda phi, *, mass, radius, offset, inertia: (
            inertia + mass * (radius - offset * math.cos(phi)) ** 2
        ),
    ),
    suspect(
        "the inertia about the centre", contact_inertia=lambda phi, **c: c["inertia"] + c["mass"] * c["offset"] ** 2
    ),
    suspect(
        "the distance from C to the centre, where that to G belongs",
        contact_inertia=lambda phi, **c: c["inertia"] + c["mass"] * c["radius"] ** 2,
    ),
    suspect(
        "that of phi = 0 at every phi: G is as far from C there as r - e",
        contact_inertia=lambda phi, **c: about_contact(0.0, **c),
    ),
    suspect(
        "the distance from C to G by r^2 + e^2, which it is where O G is along the ramp",
        contact_inertia=lambda phi, *, mass, radius, offset, inertia: inertia + mass * (radius**2 + offset**2),
    ),
    suspect(
        "the given inertia taken as that about the centre",
        contact_inertia=lambda phi, **c: about_contact(phi, **c) - c["mass"] * c["offset"] ** 2,
    ),
    suspect("G on the other side of the centre", contact_inertia=offset_reversed(about_contact)),
]


@check(points=1, part="a", suspects=CONTACT_INERTIA_SUSPECTS)
def contact_inertia_by_the_parallel_axis_theorem(student, draw):
    """contact_inertia: I^G plus the mass times the distance from C to G squared."""
    for of in (
        at_rest(cases(draw, 12)) + at_rest(cases(draw, 3, offset=0.0)),
        at_rest((plain_cases(draw) + level_cases(draw))[::3]),
    ):
        asked = calls(of, *BODY)
        for found, call, (phi, c) in zip(student.contact_inertia.many(asked), asked, of, strict=True):
            expect(
                found / about_contact(phi, **parts(c, *BODY)),
                1,
                within=FORMULA,
                of="I^C",
                unit="of itself",
                kind=call.kind,
                at=(phi, c),
                hint="how far is G from the contact, at this phi?",
            )


NAIVE_SUSPECTS = [
    suspect("G on the other side of the centre", naive_contact_acceleration=offset_reversed(naive)),
    suspect(
        "the moment of a weight at the centre, where it acts at G",
        naive_contact_acceleration=lambda phi, **c: (
            c["mass"] * c["gravity"] * c["radius"] * math.sin(c["slope"]) / about_contact(phi, **parts(c, *BODY))
        ),
    ),
    suspect(
        "the moment of the weight at G with sin(phi - slope), where sin(phi + slope) belongs",
        naive_contact_acceleration=lambda phi, **c: naive(phi, **c) + more_by_slope(phi, -1, **c),
    ),
    suspect(
        "phi measured from the vertical, where it is measured from the normal of the ramp",
        naive_contact_acceleration=lambda phi, **c: naive(phi - c["slope"], **c),
    ),
    suspect(DEGREES, naive_contact_acceleration=with_slope(math.radians, naive)),
    suspect(
        "I^G + m r^2 for I^C, which is that of a G at the centre",
        naive_contact_acceleration=lambda phi, **c: (
            moment_of_weight(phi, **c) / (c["inertia"] + c["mass"] * c["radius"] ** 2)
        ),
    ),
    suspect("I^G for I^C", naive_contact_acceleration=lambda phi, **c: moment_of_weight(phi, **c) / c["inertia"]),
]


@check(points=0.75, part="a", suspects=NAIVE_SUSPECTS)
def naive_acceleration_is_the_moment_over_the_inertia(student, draw):
    """naive_contact_acceleration: the moment of the weight about C over I^C, at any angle."""
    for of in (
        at_rest(cases(draw, 10)) + at_rest(cases(draw, 3, slope=0.0)) + at_rest(cases(draw, 2, gravity=0.0)),
        at_rest((plain_cases(draw) + level_cases(draw))[::3]),
    ):
        asked = calls(of, *ALL)
        results = student.naive_contact_acceleration.many(asked)
        for found, call, (phi, c) in zip(results, asked, of, strict=True):
            scale = moment_scale(phi, 0.0, c) / about_contact(phi, **parts(c, *BODY))
            expect(
                found,
                naive(phi, **c),
                within=FORMULA,
                scale=scale,
                of="phi'' from M_C = I^C phi''",
                unit="of the size of its terms",
                kind=call.kind,
                at=(phi, c),
                hint="M_C is the moment of the weight, which acts at G; I^C is that of this phi",
            )


# Part b: what is missing, the force, the energy, the motion


def missing_suspect(says, wrong):
    return suspect(says, missing_moment=wrong)


MISSING_SUSPECTS = [
    missing_suspect("half the term", lambda *args, **c: missing(*args, **c) / 2),
    missing_suspect("twice the term: the whole rate of I^C times phi'", lambda *args, **c: 2 * missing(*args, **c)),
    missing_suspect("the sign reversed", lambda *args, **c: -missing(*args, **c)),
    missing_suspect("phi' where its square belongs", lambda phi, rate, **c: missing(phi, rate, **c) / (rate or 1.0)),
    missing_suspect(
        "phi' times its size, where its square belongs, which has no sign",
        lambda phi, rate, **c: math.copysign(1.0, rate) * missing(phi, rate, **c),
    ),
    missing_suspect("the cosine of phi for the sine", lambda phi, rate, **c: missing(phi + math.pi / 2, rate, **c)),
    missing_suspect(
        "the size of the sine of phi, where its sign matters: G may be on either side",
        lambda *args, **c: abs(missing(*args, **c)),
    ),
]


@check(points=1.25, part="b", suspects=MISSING_SUSPECTS)
def missing_moment_makes_it_right(student, draw):
    """missing_moment: with it, I^C phi'' + missing_moment = M_C has the phi'' of the balances."""
    for of in (cases(draw, 20), plain_cases(draw) + level_cases(draw)):
        asked = calls(of, "mass", "radius", "offset")
        found = student.missing_moment.many(asked)
        for value, call, (phi, phi_dot, c) in zip(found, asked, of, strict=True):
            expect(
                value,
                missing(phi, phi_dot, **parts(c, "mass", "radius", "offset")),
                within=FORMULA,
                scale=moment_scale(phi, phi_dot, c),
                of="the missing moment",
                unit="of m r^2 (g/r + phi_dot^2)",
                kind=call.kind,
                at=(phi, phi_dot, c),
                hint="what is the acceleration of the point of the cylinder that touches the ramp?",
            )


FORCE_SUSPECTS = [
    suspect("the friction positive up the ramp", contact_force=up_the_ramp),
    suspect("normal first, along second", contact_force=lambda *args, **c: force_of(*args, **c)[::-1]),
    suspect(
        "the acceleration of G without its terms in phi_dot squared",
        contact_force=force_from(acceleration_of, centripetal=0.0),
    ),
    suspect(
        "the acceleration of G without alpha x r, its turning about the centre",
        contact_force=force_from(acceleration_of, about_centre=0.0),
    ),
    suspect("G on the other side of the centre", contact_force=offset_reversed(force_of)),
    suspect(DEGREES, contact_force=with_slope(math.radians, force_of)),
    *(suspect(says, contact_force=force_by(wrong)) for says, wrong in WRONG_PARTS.items()),
    *(
        suspect(f"{says}, for the acceleration", contact_force=force_from(wrong))
        for says, wrong in WRONG_ACCELERATIONS.items()
    ),
]


def judge_forces(student, of, hint, kind=""):
    asked = calls(of, *ALL, kind=kind)
    for found, call, (phi, phi_dot, c) in zip(student.contact_force.many(asked), asked, of, strict=True):
        scale = moment_scale(phi, phi_dot, c) / c["radius"]
        right = force_of(phi, phi_dot, **c)
        off = np.abs(np.subtract(found, right)) > FORMULA * scale
        expect(
            found,
            right,
            within=FORMULA,
            scale=scale,
            of="the contact force",
            unit="of m (g + r phi_dot^2)",
            kind=call.kind,
            hint=PARTS.get(tuple(off), hint),
            at=(phi, phi_dot, c),
        )


DOWN = "along is positive down the ramp: on which part does friction act?"
# whether along and normal are off
PARTS = {
    (True, False): "normal is right, along is not: m times the acceleration of G down the ramp, less m g sin(slope)",
    (False, True): "along is right, normal is not: G is accelerated off the ramp too, by phi'' and by phi_dot squared, "
    "and of its weight m g cos(slope) presses",
}


@check(points=1.25, part="b", suspects=FORCE_SUSPECTS)
def contact_force_accelerates_G(student, draw):
    """contact_force: with the weight it is the mass times the acceleration of G; (along, normal)."""
    for fixed in ({}, {"offset": 0.0}):
        slow = [(phi, rate / 5, c) for phi, rate, c in cases(draw, 8, **fixed)]
        judge_forces(student, pressed(slow), DOWN)
    judge_forces(student, pressed(plain_cases(draw)), "which terms are zero there?")


def pressed(of, on=True):
    """Those in which the weight presses the cylinder on the ramp, or those in which it must be pulled."""
    return [(*motion, c) for *motion, c in of if (force_of(*motion, **c)[1] > 0) == on]


def never_pulled(*args, **cylinder):
    along, normal = force_of(*args, **cylinder)
    return along, max(normal, 0.0)


PULL_SUSPECTS = [suspect("a normal force below zero cut off to zero", contact_force=never_pulled)]


@check(points=0.25, part="b", after=contact_force_accelerates_G, suspects=PULL_SUSPECTS)
def contact_force_may_pull(student, draw):
    """contact_force: contact is kept in fast rolling too, where the ramp must pull, and without gravity."""
    hint = "contact is kept: the force is what keeping it needs"
    fast = [(phi / 9 + math.pi, 4 * rate, c) for phi, rate, c in cases(draw, 8)]  # G is high: it must be pulled
    pulled = pressed(plain_cases(draw), on=False)
    judge_forces(student, fast + pulled, hint, kind="a normal force below zero")
    judge_forces(student, cases(draw, 5, gravity=0.0), hint)
    judge_forces(student, level_cases(draw), hint)


def potential_from(level):
    """The energy with the potential zero elsewhere: `level` above where it belongs, in the cylinder's numbers."""
    return lambda *args, **c: total_energy(*args, **c) - c["mass"] * c["gravity"] * level(c)


def potential_with(cosine):
    """The energy with cosine(phi, slope) in the height of G below the centre, where cos(phi + slope) belongs."""

    def energy(phi, rate, **c):
        more = math.cos(phi + c["slope"]) - cosine(phi, c["slope"])
        return total_energy(phi, rate, **c) + c["mass"] * c["gravity"] * c["offset"] * more

    return energy


ENERGY_SUSPECTS = [
    suspect(
        "the height of G with cos(phi - slope), where cos(phi + slope) belongs",
        energy=potential_with(lambda phi, slope: math.cos(phi - slope)),
    ),
    suspect(
        "the height of G with cos(phi) cos(slope), where cos(phi + slope) belongs",
        energy=potential_with(lambda phi, slope: math.cos(phi) * math.cos(slope)),
    ),
    suspect(
        "the potential zero with G where it is at phi = 0",
        energy=potential_from(lambda c: -c["offset"] * math.cos(c["slope"])),
    ),
    suspect("the potential zero on the ramp", energy=potential_from(lambda c: -c["radius"] * math.cos(c["slope"]))),
    suspect(
        "the centre's speed for that of G",
        energy=lambda phi, rate, **c: (
            total_energy(phi, 0.0, **c) + (c["mass"] * c["radius"] ** 2 + c["inertia"]) * rate**2 / 2
        ),
    ),
    suspect(
        "the kinetic energy without that of G",
        energy=lambda phi, rate, **c: total_energy(phi, 0.0, **c) + c["inertia"] * rate**2 / 2,
    ),
    suspect("G on the other side of the centre", energy=offset_reversed(total_energy)),
    suspect(DEGREES, energy=with_slope(math.radians, total_energy)),
]


@check(points=1, part="b", suspects=ENERGY_SUSPECTS)
def energy_of_G_and_of_turning(student, draw):
    """energy: of the motion of G, of the turning, and of the height of G."""
    for of in (cases(draw, 12) + cases(draw, 3, gravity=0.0), plain_cases(draw) + level_cases(draw)):
        asked = calls(of, *ALL)
        for found, call, (phi, phi_dot, c) in zip(student.energy.many(asked), asked, of, strict=True):
            expect(
                found,
                total_energy(phi, phi_dot, **c),
                within=FORMULA,
                scale=9 * moment_scale(phi, phi_dot, c),
                of="the energy",
                unit="of its largest term",
                kind=call.kind,
                at=(phi, phi_dot, c),
                hint="where is G, and how high above the centre's place at phi = 0?",
            )


@once
def runs(draw, count):
    """Two calls to simulate, and what is right for each: rolling down, and rocking in a hollow."""
    rolling = cylinder(draw, slope=draw.uniform(0.2, 0.5))
    # fast enough to pass every top with energy to spare
    start = draw.uniform(-2, 2), draw.uniform(3, 4) * usual(rolling)
    two = [(rolling, start, "a cylinder that rolls down")]
    rocking = cylinder(draw, slope=draw.uniform(0.05, 0.15))
    rest = math.asin(rocking["radius"] * math.sin(rocking["slope"]) / rocking["offset"]) - rocking["slope"]
    start = rest + draw.choice([-1, 1]) * draw.uniform(0.5, 0.9), -draw.uniform(0.1, 0.3) * usual(rocking)
    two.append((rocking, start, "a cylinder that rocks"))
    cases = []
    for c, start, kind in two:
        t = uneven(draw, 8 / usual(c), count)
        cases.append((given(t, *start, **c).on(kind), moved(t, *start, **c), usual(c)))
    return cases


def judge_runs(student, cases, hint):
    found = student.simulate.many([call for call, *_ in cases])
    judged = []
    for states, (call, expected, rate) in zip(found, cases, strict=True):
        far = max(1.0, np.ptp(expected[:, 0]))
        scale = np.array([far, rate * far])
        judged.append((states / scale, expected / scale, call, scale))
    for run in sorted(judged, key=error_of_run, reverse=True):  # partial points: worst first
        states, expected, call, _ = run
        moves = np.ptp(expected, axis=0).max() > 3e-3  # more than has partial points
        stands = len(states) == 2 and moves and np.array_equal(*states)
        expect_that(not stands, "row 1 is the start again", kind=call.kind, at=call)
        expect(
            states,
            expected,
            within=TRAJECTORY,
            of="phi, or phi_dot in its scale,",
            unit="of the distance rolled",
            t=call.args[0],
            kind=call.kind,
            at=call,
            partial={1e-3: 0.5},
            hint=partial(hint_of_rows, student, run, hint),
        )


JOINABLE = 3e-2  # straight lines between the steps of a tight integration are off by less, to choose the words
JOINED = (
    "asked for alone, its worst time comes out far better: are the rows the integrator's own at t (t_eval, or "
    "dense_output), or joined by straight lines?"
)


def joined(student, states, expected, call, scale):
    """Whether the worst row is right where its time is the last, at which every integrator ends a step."""
    t, *start = call.args
    errors = np.max(np.abs(states - expected), axis=1)
    row = int(np.argmax(errors))
    # a loose tolerance is off by less
    if row in (0, len(t) - 1) or not 10 * TRAJECTORY < errors[row] < JOINABLE:
        return False
    try:
        again = student.simulate(t[[0, row]], *start, **call.kwargs)
    except Failed:
        return False
    return bool(np.max(np.abs(again[-1] / scale - expected[row])) <= TRAJECTORY)


def hint_of_rows(student, run, otherwise):
    """Whether the rows stop changing, as they do where a simulation ends, are those of small rocking, or joined."""
    states, _, call, _ = run
    if call.kind in SPANS and np.max(np.abs(states[:, 0] - linear(*call.args, **call.kwargs)[:, 0])) <= TRAJECTORY:
        return "it is the small rocking of the linear equation, and the motion is not small"
    if len(states) > 2 and np.array_equal(states[-1], states[-2]):
        return "it stops: contact is kept, and the motion goes on, even where the ramp must pull"
    return JOINED if joined(student, *run) else otherwise


def error_of_run(run):
    return np.max(np.abs(run[0] - run[1]))


@check(points=1, part="b", suspects=ANY_TIMES)
def simulate_rolls_and_rocks(student, draw):
    """simulate: rolling down and rocking, row i at t[i], row 0 the given state."""
    judge_runs(student, runs(draw, 200), "put `acceleration` into an integrator; is its tolerance tight?")


@check(points=0.25, part="b", after=simulate_rolls_and_rocks, suspects=ANY_TIMES)
def simulate_needs_no_dense_times(student, draw):
    """simulate: the same motion when only a few times are asked for."""
    few = runs(draw, 8)  # not fewer: odeint takes no more than 500 steps from one to the next unless told to
    judge_runs(student, few, "the steps of the integration are not those of t")
    judge_runs(student, [heavy_side(draw)], "the steps of the integration are not those of t; is the tolerance tight?")
    judge_runs(student, plain_runs(draw), "row 0 is the start, row 1 the other time")


@once
def heavy_side(draw):
    """As one of `runs`, for three times: between the first two a heavy side comes down, quickly, and goes up again.

    This takes short steps there, and in all fewer than the 500 of odeint.
    """
    c = cylinder(draw, slope=0.0)
    c["offset"] = c["radius"] * draw.uniform(0.84, 0.86)
    c["inertia"] = c["mass"] * c["radius"] ** 2 * draw.uniform(0.055, 0.065)
    start = math.pi + draw.uniform(-0.2, 0.2), draw.choice([-1, 1]) * draw.uniform(0.5, 0.55) * usual(c)
    first, last = uneven(draw, 6 / usual(c), 2)
    t = np.array([first, last - 0.4 / usual(c), last])
    call = given(t, *start, **c).on("few times, a cylinder with a heavy side")
    return call, moved(t, *start, **c), usual(c)


OFF_LOWEST = "two times, let go at rest on level ground"
NEAR_LOWEST = "two times, let go at rest on level ground, close to where it would stay"
SPANS = {OFF_LOWEST: 6, NEAR_LOWEST: 15}  # in 1/usual(c), where it is not 2


@once
def plain_runs(draw):
    """As `runs`, for two times: let go at rest, up a ramp, with G at the centre, and where nothing moves.

    The last has the times and the start of the first: what is kept from call to call must not be the answer.
    """
    starts = (
        (cylinder(draw), 0.0, 0.0, "two times, let go at rest at phi = 0"),
        (cylinder(draw, slope=-draw.uniform(0.2, 0.5)), 0.0, 1.0, "two times, up a ramp"),
        (cylinder(draw, offset=0.0), 0.0, -1.0, "two times, G at the centre"),
        (cylinder(draw, slope=0.0), 0.0, 0.0, "a cylinder at rest, G at its lowest, where it stays"),
        # by the linear equation these two are off by 3e-3 and 3e-4; BDF at 1e-9 by 9e-8
        (cylinder(draw, slope=0.0), draw.choice([-0.19, 0.19]), 0.0, OFF_LOWEST),
        (cylinder(draw, slope=0.0), draw.choice([-0.08, 0.08]), 0.0, NEAR_LOWEST),
    )
    cases = []
    for c, angle, rate, kind in starts:
        t, start = uneven(draw, SPANS.get(kind, 2) / usual(c), 2), (angle, rate * usual(c))
        cases.append((given(t, *start, **c).on(kind), moved(t, *start, **c), usual(c)))
    (t, *start), c = cases[0][0].args, cases[0][0].kwargs
    c = {**c, "slope": c["slope"] / 2}
    kind = "two times, let go at rest at phi = 0, and another ramp"
    return [*cases, (given(t, *start, **c).on(kind), moved(t, *start, **c), usual(c))]


@once
def small_rocking(draw):
    """A call with a small start on level ground, and the linear solution."""
    c = cylinder(draw, slope=0.0)
    k = rocking_rate(c)
    t, amplitude = uneven(draw, 25 / k, 60), draw.uniform(1, 2) * 1e-3
    call = given(t, amplitude, 0.0, **c).on("small rocking on level ground")
    return call, linear(t, 1.0, 0.0, **c) / [1.0, k], [amplitude, amplitude * k]


def rocking_rate(c):
    """Of small rocking on level ground: the inertia is that about C at phi = 0."""
    return math.sqrt(c["mass"] * c["gravity"] * c["offset"] / about_contact(0.0, **parts(c, *BODY)))


def linear(t, amplitude, _, **cylinder):
    """Small rocking on level ground, let go at rest."""
    k = rocking_rate(cylinder)
    angle = k * (t - t[0])
    return np.column_stack([amplitude * np.cos(angle), -amplitude * k * np.sin(angle)])


ROCKING = 5e-4  # of the amplitude: solve_ivp at 1e-9 is off by 4e-5, the square of the amplitude by 3e-5


@check(points=0.25, part="b", after=simulate_rolls_and_rocks, suspects=simulations(STANDS))
def simulate_rocks_at_the_linear_frequency(student, draw):
    """simulate: small rocking on level ground has the frequency of the linear equation."""
    call, expected, scale = small_rocking(draw)
    expect(
        student.simulate.many([call])[0] / scale,
        expected,
        within=ROCKING,
        of="phi or phi_dot",
        unit="of its amplitude",
        t=call.args[0],
        kind=call.kind,
        at=call,
        hint="is the tolerance absolute, and too coarse for a small motion?",
    )


@check(
    points=0.5,
    part="b",
    after=simulate_rolls_and_rocks,
    suspects=simulations({STILL: integrated(still_without_gravity)}),
)
def simulate_keeps_the_energy(student, draw):
    """simulate: the energy stays what it was over many turns, with and without gravity."""
    runs = (({"gravity": 0.0}, "many turns without gravity"), ({"slope": 0.0}, "many turns on level ground"))
    judged = [(*energies(student.on(kind), draw, fixed, kind), kind) for fixed, kind in runs]
    for found, expected, t, rates, at, kind in sorted(judged, key=error_of_run, reverse=True):
        uniform = "phi_dot never changes: G is accelerated, and not by the weight alone"
        steps = "a step of fixed length, or a fixed number of them, does not do for every duration"
        expect(
            found,
            expected,
            within=ENERGY,
            of="the energy",
            unit="of m r^2 (g/r + phi_dot^2) at the start",
            t=t,
            kind=kind,
            at=at,
            partial={1e-4: 0.6, 1e-2: 0.3},
            hint=steps if np.ptp(rates) else uniform,
        )


def energies(student, draw, fixed, kind):
    """The energies of a long run, and what they should be, both in the scale of the start; t, phi_dot, the input."""
    c = cylinder(draw, **fixed)
    t, start = uneven(draw, 50 / usual(c), 150), (draw.uniform(-2, 2), 3 * usual(c))
    states = student.simulate(t, *start, **c)
    # the start's energy takes G over every top at no less than 0.5 usual(c)
    rolls = np.all(np.diff(states[:, 0]) > 0.25 * usual(c) * np.diff(t))
    expect_that(rolls, "the cylinder does not roll on", kind=kind, at=(start, c))
    scale = moment_scale(*start, c)
    found = np.array([total_energy(*state, **c) for state in states]) / scale
    expected = np.full(len(t), total_energy(*start, **c) / scale)
    return found, expected, t, states[:, 1], (start, c)
