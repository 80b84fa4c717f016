"""Hidden checks of hw13."""

import numpy as np

from tam570_grader import Column, Failed, Invariant, agree, check, follow, group, number, rows, stays

from . import cases, right

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
ROCKING = 5e-4  # of the amplitude: solve_ivp at 1e-9 is off by 4e-5, the square of the amplitude by 3e-5


def moment(case, _=None):
    """m r^2 (g/r + phi_dot^2), whatever of it the function is given."""
    rate2 = sum(rate**2 for rate in case.args[1:2]) + cases.usual(case.kwargs) ** 2
    return case.kwargs["mass"] * case.kwargs["radius"] ** 2 * rate2


def turning(case, _=None):
    """The angular acceleration that the terms make."""
    return moment(case) / right.contact_inertia(case.args[0], *(case.kwargs[name] for name in cases.BODY))


def force(case, _=None):
    return moment(case) / case.kwargs["radius"]


TURNING = {"within": FORMULA, "of": "phi''", "unit": "rad/s^2", "scale": turning}


def hint_of_rates(function):
    """Which terms are wrong: the same place is asked at rest."""

    def hint(case, *_):
        still = case.but(case.args[0], 0.0)
        try:
            found = function.aside(still)
        except Failed:
            return "What is it at rest?"
        if abs(found - right.acceleration(*still.args, **still.kwargs)) <= FORMULA * turning(still):
            return "At rest it is right: differentiate the position of G twice, and mind the terms in phi_dot squared."
        return "At rest it is wrong, too: look at the moment of the weight and at the inertia."

    return hint


@check(points=0.5, part="a")
def centred_cylinder_rolls_by_both_methods(student, draw):
    """With G at the centre, acceleration and naive_contact_acceleration are both right."""
    calls = cases.rolling(draw, 8, offset=0.0)
    hint = "Balance momentum about G: friction alone turns it."
    agree(student.acceleration, right.acceleration, calls, **TURNING, hint=hint)
    known = {"of": "phi'' from M_C = I^C phi''", "unit": "rad/s^2"}
    both = student.naive_contact_acceleration, right.naive_contact_acceleration
    agree(*both, cases.at_rest(calls), within=FORMULA, **known)


@check(points=1.5, part="a")
def acceleration_balances_momentum_about_G(student, draw):
    """acceleration: the force of the ramp that G's acceleration needs gives, about G, the moment I^G phi''."""
    calls = cases.rolling(draw, 20) + cases.plain(draw)
    agree(student.acceleration, right.acceleration, calls, **TURNING, hint=hint_of_rates(student.acceleration))


@check(points=0.5, part="a", after=acceleration_balances_momentum_about_G)
def acceleration_level_and_without_gravity(student, draw):
    """acceleration: on level ground, and without gravity."""
    flat, weightless = cases.rolling(draw, 5, slope=0.0), cases.rolling(draw, 5, gravity=0.0)
    hint = "Without weight it still does not turn uniformly; is anything divided by the slope?"
    agree(student.acceleration, right.acceleration, flat + weightless + cases.level(draw), **TURNING, hint=hint)


@check(points=1, part="a")
def contact_inertia_by_the_parallel_axis_theorem(student, draw):
    """contact_inertia: I^G plus the mass times the distance from C to G squared."""
    drawn = cases.rolling(draw, 12) + cases.rolling(draw, 3, offset=0.0)
    calls = cases.at_rest(drawn + cases.plain(draw) + cases.level(draw), *cases.BODY)
    hint = "How far is G from the contact, at this phi?"
    known = {"of": "I^C", "unit": "kg m^2", "hint": hint}
    agree(student.contact_inertia, right.contact_inertia, calls, within=FORMULA, **known)


@check(points=0.75, part="a")
def naive_acceleration_is_the_moment_over_the_inertia(student, draw):
    """naive_contact_acceleration: the moment of the weight about C over I^C, at any angle."""
    flat, weightless = cases.rolling(draw, 3, slope=0.0), cases.rolling(draw, 2, gravity=0.0)
    drawn = cases.rolling(draw, 10) + flat + weightless + cases.plain(draw) + cases.level(draw)
    hint = "M_C is the moment of the weight, which acts at G; I^C is that of this phi."
    known = {**TURNING, "of": "phi'' from M_C = I^C phi''", "hint": hint}
    agree(student.naive_contact_acceleration, right.naive_contact_acceleration, cases.at_rest(drawn), **known)


@check(points=1.25, part="b")
def missing_moment_makes_it_right(student, draw):
    """missing_moment: with it, I^C phi'' + missing_moment = M_C has the phi'' of the balances."""
    drawn = cases.rolling(draw, 20) + cases.plain(draw) + cases.level(draw)
    calls = cases.of(drawn, "mass", "radius", "offset")
    hint = "What is the acceleration of the point of the cylinder that touches the ramp?"
    known = {"of": "the missing moment", "unit": "N m", "scale": moment, "hint": hint}
    agree(student.missing_moment, right.missing_moment, calls, within=FORMULA, **known)


def part_of_force(case, found, expected):
    """Which of along and normal is off."""
    along, normal = np.abs(np.subtract(found, expected)) > FORMULA * force(case)
    if along and normal:
        return "Along is positive down the ramp: on which part does friction act?"
    if along:
        return "Normal is right, along is not: m times the acceleration of G down the ramp, less m g sin(slope)."
    return "Along is right, normal is not: G is accelerated off the ramp too, by phi'' and by phi_dot squared."


FORCE = {"within": FORMULA, "of": ("the force along the ramp", "the normal force"), "unit": ("N", "N"), "scale": force}


@check(points=1.25, part="b")
def contact_force_accelerates_G(student, draw):
    """contact_force: with the weight it is the mass times the acceleration of G; (along, normal)."""
    drawn = cases.rolling(draw, 8) + cases.rolling(draw, 8, offset=0.0)
    slow = [call.but(call.args[0], call.args[1] / 5) for call in drawn]
    calls = cases.pressed(slow + cases.plain(draw))
    agree(student.contact_force, right.contact_force, calls, **FORCE, hint=part_of_force)


@check(points=0.25, part="b", after=contact_force_accelerates_G)
def contact_force_may_pull(student, draw):
    """contact_force: contact is kept in fast rolling too, where the ramp must pull, and without gravity."""
    hint = "Contact is kept: the force is what keeping it needs."
    calls = cases.pulled(draw) + cases.rolling(draw, 5, gravity=0.0) + cases.level(draw)
    agree(student.contact_force, right.contact_force, calls, **FORCE, hint=hint)


@check(points=1, part="b")
def energy_of_G_and_of_turning(student, draw):
    """energy: of the motion of G, of the turning, and of the height of G."""
    weightless = cases.rolling(draw, 3, gravity=0.0)
    calls = cases.rolling(draw, 12) + weightless + cases.plain(draw) + cases.level(draw)
    hint = "Where is G, and how high above the centre's place at phi = 0?"
    known = {"of": "the energy", "unit": "J", "scale": lambda case, _: 9 * moment(case), "hint": hint}
    agree(student.energy, right.energy, calls, within=FORMULA, **known)


def rolled(case, states):
    """The angle that it turns, a radian at least."""
    return max(1.0, np.ptp(states[:, 0]))


MOTION = (
    Column("phi", "rad", [0], turns=True, scale=rolled),
    Column("phi_dot", "rad/s", [1], scale=lambda case, states: cases.usual(case.kwargs) * rolled(case, states)),
)
SMALL_MOTION = (Column("phi", "rad", [0]), Column("phi_dot", "rad/s", [1]))
KEPT = Invariant(
    "the energy",
    "of m r^2 (g/r + phi_dot^2)",
    right.energy_of_rows,
    lambda case, states: moment(case.but(*states[0], *case.args[2:])),
    ENERGY,
)


@check(points=1, part="b")
def simulate_rolls_and_rocks(student, draw):
    """simulate: rolling down and rocking, row i at t[i], row 0 the given state."""
    hint = "Do you integrate `acceleration`? Contact is kept, and the motion goes on, even where the ramp must pull."
    follow(student.simulate, right.motion, cases.runs(draw, 200), MOTION, within=TRAJECTORY, hint=hint, keeps=KEPT)


@check(points=0.25, part="b", after=simulate_rolls_and_rocks)
def simulate_needs_no_dense_times(student, draw):
    """simulate: the same motion when only a few times are asked for, whatever was asked before."""
    hint = "Your own steps are not those of t: is the tolerance tight?"
    small = "However small the rocking, the other terms are there."
    follow(student.simulate, right.motion, cases.few_times(draw), MOTION, within=TRAJECTORY, hint=hint)
    near = cases.near_lowest(draw)
    follow(student.simulate, right.motion, near, MOTION, within=TRAJECTORY, hint=small, loose=False)


@check(points=0.25, part="b", after=simulate_rolls_and_rocks)
def simulate_rocks_at_the_linear_frequency(student, draw):
    """simulate: small rocking on level ground has the frequency of the linear equation."""
    hint = "Is the tolerance absolute, and too coarse for a small motion?"
    calls = [cases.small_rocking(draw)]
    follow(student.simulate, right.small_rocking, calls, SMALL_MOTION, within=ROCKING, hint=hint)


@check(points=0.5, part="b", after=simulate_rolls_and_rocks)
def simulate_keeps_the_energy(student, draw):
    """simulate: the energy stays what it was over many turns, with and without gravity."""
    share = {1e-4: 0.6, 1e-2: 0.3}
    hint = "A step of fixed length, or a fixed number of them, does not do for every duration."
    stays(student.simulate, right.motion, cases.many_turns(draw), KEPT, MOTION, partial=share, hint=hint)
