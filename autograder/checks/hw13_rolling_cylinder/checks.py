"""Hidden checks of hw13."""

import numpy as np

from tam570_grader import Column, Failed, Invariant, agree, check, follow, group, law, number, rows

from . import cases, right

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
RESULTS = {
    "acceleration": number.called("phi''", "rad/s^2", turning),
    "contact_inertia": number.called("I^C", "kg m^2"),
    "naive_contact_acceleration": number.called("phi'' from M_C = I^C phi''", "rad/s^2", turning),
    "missing_moment": number.called("the missing moment", "N m", moment),
    "contact_force": group(
        number.called("the force along the ramp", "N", force), number.called("the normal force", "N", force)
    ),
    "energy": number.called("the energy", "J", lambda case, _: 9 * moment(case)),
    "simulate": rows(2, columns=MOTION),
}


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


def part_of_force(case, found, expected):
    """Which of along and normal is off."""
    along, normal = np.abs(np.subtract(found, expected)) > FORMULA * force(case)
    if along and normal:
        return "Along is positive down the ramp: on which part does friction act?"
    if along:
        return "Normal is right, along is not: m times the acceleration of G down the ramp, less m g sin(slope)."
    return "Along is right, normal is not: G is accelerated off the ramp too, by phi'' and by phi_dot squared."


# Where to look
BOTH = "Balance momentum about G: friction alone turns it."
UNWEIGHTED = "Without weight it still does not turn uniformly; is anything divided by the slope?"
WEIGHT_ACTS_AT_G = "M_C is the moment of the weight, which acts at G; I^C is that of this phi."
CONTACT_POINT = "What is the acceleration of the point of the cylinder that touches the ramp?"
CONTACT_IS_KEPT = "Contact is kept: the force is what keeping it needs."
HEIGHT_OF_G = "Where is G, and how high above the centre's place at phi = 0?"
GOES_ON = "Do you integrate `acceleration`? Contact is kept, and the motion goes on, even where the ramp must pull."
ANY_DURATION = "A step of fixed length, or a fixed number of them, does not do for every duration."


@check(points=0.5, part="a")
def centred_cylinder_rolls_by_both_methods(student, draw):
    """With G at the centre, acceleration and naive_contact_acceleration are both right."""
    calls = cases.rolling(8, offset=0.0)(draw)
    agree(student.acceleration, right, calls, within=FORMULA, hint=BOTH)
    agree(student.naive_contact_acceleration, right, cases.at_rest(lambda _: calls)(draw), within=FORMULA)


@check(points=1.5, part="a")
def acceleration_balances_momentum_about_G(student, draw):
    """acceleration: the force of the ramp that G's acceleration needs gives, about G, the moment I^G phi''."""
    calls = cases.rolling(20)(draw) + cases.plain(draw)
    agree(student.acceleration, right, calls, within=FORMULA, hint=hint_of_rates(student.acceleration))


acceleration_level_and_without_gravity = acceleration_balances_momentum_about_G.then(
    "acceleration: on level ground, and without gravity.", points=0.5, part="a"
).agrees(right.acceleration, cases.flat(5), cases.weightless(5), cases.level, within=FORMULA, hint=UNWEIGHTED)
contact_inertia_by_the_parallel_axis_theorem = law(
    "contact_inertia: I^G plus the mass times the distance from C to G squared.", points=1, part="a"
).agrees(right.contact_inertia, cases.bodies, within=FORMULA, hint="How far is G from the contact, at this phi?")
naive_acceleration_is_the_moment_over_the_inertia = law(
    "naive_contact_acceleration: the moment of the weight about C over I^C, at any angle.", points=0.75, part="a"
).agrees(right.naive_contact_acceleration, cases.resting, within=FORMULA, hint=WEIGHT_ACTS_AT_G)
missing_moment_makes_it_right = law(
    "missing_moment: with it, I^C phi'' + missing_moment = M_C has the phi'' of the balances.", points=1.25, part="b"
).agrees(right.missing_moment, cases.unweighed, within=FORMULA, hint=CONTACT_POINT)
contact_force_accelerates_G = law(
    "contact_force: with the weight it is the mass times the acceleration of G; (along, normal).", points=1.25, part="b"
).agrees(right.contact_force, cases.slow, within=FORMULA, hint=part_of_force)
contact_force_may_pull = contact_force_accelerates_G.then(
    "contact_force: contact is kept in fast rolling, where the ramp must pull, and without gravity.",
    points=0.25,
    part="b",
).agrees(right.contact_force, cases.pulled, cases.weightless(5), cases.level, within=FORMULA, hint=CONTACT_IS_KEPT)
energy_of_G_and_of_turning = law(
    "energy: of the motion of G, of the turning, and of the height of G.", points=1, part="b"
).agrees(
    right.energy, cases.rolling(12), cases.weightless(3), cases.plain, cases.level, within=FORMULA, hint=HEIGHT_OF_G
)
simulate_rolls_and_rocks = law(
    "simulate: rolling down and rocking, row i at t[i], row 0 the given state.", points=1, part="b"
).follows(right.simulate, cases.dense_runs, within=TRAJECTORY, hint=GOES_ON, keeps=KEPT)


@check(points=0.25, part="b", after=simulate_rolls_and_rocks)
def simulate_needs_no_dense_times(student, draw):
    """simulate: the same motion when only a few times are asked for, whatever was asked before."""
    hint = "Your own steps are not those of t: is the tolerance tight?"
    small = "However small the rocking, the other terms are there."
    follow(student.simulate, right, cases.few_times(draw), within=TRAJECTORY, hint=hint)
    follow(student.simulate, right, cases.near_lowest(draw), within=TRAJECTORY, hint=small, gradual=False)


@check(points=0.25, part="b", after=simulate_rolls_and_rocks)
def simulate_rocks_at_the_linear_frequency(student, draw):
    """simulate: small rocking on level ground has the frequency of the linear equation."""
    hint = "Is the tolerance absolute, and too coarse for a small motion?"
    calls = [cases.small_rocking(draw)]
    follow(student.simulate, right.small_rocking, calls, SMALL_MOTION, within=ROCKING, hint=hint)


SHARES = {1e-4: 0.6, 1e-2: 0.3}  # of the drift of the energy
simulate_keeps_the_energy = simulate_rolls_and_rocks.then(
    "simulate: the energy stays what it was over many turns, with and without gravity.", points=0.5, part="b"
).keeps(KEPT, right=right.simulate, cases=cases.many_turns, partial=SHARES, hint=ANY_DURATION)
