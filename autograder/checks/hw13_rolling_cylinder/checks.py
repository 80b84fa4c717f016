"""Hidden checks of hw13."""

from functools import partial

import numpy as np

from tam570_grader import Assignment, check
from tam570_grader.checks.compare import Column, compare_with, is_right
from tam570_grader.checks.diagrams import compare_diagrams
from tam570_grader.checks.returns import free_body_diagram, group, number, rows
from tam570_grader.checks.trajectory import Invariant, OwnRates, check_conserved, compare_trajectory

from . import cases, reference

FORMULA = 1e-9  # of the largest term: solving for the forces costs a few digits of 1e-16; wrong terms make .1
# solve_ivp at rtol = atol = 1e-9, with any method, has errors below 1e-7 on these runs; wrong physics makes .1.
TRAJECTORY = 1e-6
ENERGY = 5e-6  # the same integrators drift by up to 4e-7 on the longer run
# of the angle turned; solve_ivp at 1e-9 has an error below 1e-4, states at other times of 3e-2 or more
COARSELY = 1e-3
SHARES = {1e-4: 0.6, 1e-2: 0.3}  # {drift of the energy: share of the points}
ROCKING = 5e-4  # of the amplitude: solve_ivp at 1e-9 has an error of 4e-5, the linear equation of 3e-5

compare = compare_with(reference, tolerance=FORMULA)
compare_motions = compare_with(reference, by=compare_trajectory, tolerance=TRAJECTORY)


def rate2(case, _=None):
    """Return g/r + phi_dot^2, as far as the case has these."""
    return sum(rate**2 for rate in case.args[1:2]) + cases.usual(case.kwargs) ** 2


def moment(case, _=None):
    return case.kwargs["mass"] * case.kwargs["radius"] ** 2 * rate2(case)


def force(case, _=None):
    return moment(case) / case.kwargs["radius"]


def rolled(case, states):
    """Return the angle that the cylinder turns, at least a radian."""
    return max(1.0, np.ptp(states[:, 0]))


MOTION = (
    Column("phi", "rad", [0], turns=True, scale=rolled),
    Column("phi_dot", "rad/s", [1], scale=lambda case, states: cases.usual(case.kwargs) * rolled(case, states)),
)
ANGLES = (Column("phi", "rad", [0]), Column("phi_dot", "rad/s", [1]))
RATES = OwnRates("acceleration", reference, lambda t, row: tuple(row))
KEPT = Invariant(
    "the energy",
    "of m r^2 (g/r + phi_dot^2)",
    lambda rows, **cylinder: reference.energy(*rows.T, **cylinder),
    lambda case, states: moment(case.replace(*states[0], *case.args[2:])),
    ENERGY,
)


@check("free_body_diagram", points=0.5)
def forces_on_the_cylinder(student, rng):
    """every force on the cylinder, where it acts and along what."""
    compare_diagrams(student.free_body_diagram, reference, cases.diagrams(rng))


def part_of_force(student, case, result, expected):
    """Return which of along and normal is wrong."""
    along, normal = np.abs(np.subtract(result, expected)) > FORMULA * force(case)
    if along and normal:
        if not is_right(student.acceleration, reference, [case]):
            return "Both parts are wrong, and acceleration is wrong there, too: look there first."
        return "Both parts are wrong, and acceleration is right: force and weight make m times the acceleration of G."
    if along:
        return "Normal is right, along is not: m times the acceleration of G down the ramp, less m g sin(slope)."
    return "Along is right, normal is not: m times the acceleration of G off the ramp, plus m g cos(slope)."


def of_pull(student, case, result, expected):
    if result[1] >= 0 > expected[1]:
        return "Assume that the cylinder never lifts off: which force does that need?"
    return part_of_force(student, case, result, expected)


ANY_DURATION = "Are there too few steps for this duration, or is the tolerance loose?"


@check("acceleration", points=0.5)
def centred_cylinder_rolls_by_both_methods(student, rng):
    """with G at the centre it is right, and naive_contact_acceleration too."""
    compare(student.acceleration, cases.centred(rng, 2), hint="Balance momentum about G: only friction turns it.")
    compare(student.naive_contact_acceleration, cases.centred(rng, 2))


@check("acceleration", points=1.5)
def acceleration_balances_momentum_about_G(student, rng):
    """the force that G's acceleration needs has, about G, the moment I^G phi''."""
    at_rest = "At rest it is wrong, too: look at the moment of the weight and at the inertia."
    moving = "At rest it is right: differentiate the position of G twice, and mind the terms in phi_dot squared."
    calls = [*cases.plain(rng), *cases.rolling(rng, 3)]  # those at rest are judged first
    compare(student.acceleration, calls, hint=lambda case, *_: moving if case.args[1] else at_rest)


@check("acceleration", points=0.5, after=acceleration_balances_momentum_about_G)
def acceleration_level_and_without_gravity(student, rng):
    """on level ground, and without gravity."""
    calls = [*cases.flat(rng, 2), *cases.weightless(rng, 2), *cases.level(rng)]
    level = "On level ground only the offset of G makes it turn faster or slower."
    weightless = "Without gravity it turns uniformly only if G is at the centre."
    compare(student.acceleration, calls, hint=lambda case, *_: level if case.kwargs["gravity"] else weightless)


@check("contact_inertia", points=1)
def contact_inertia_by_the_parallel_axis_theorem(student, rng):
    """I^G plus the mass times the distance from C to G squared."""
    calls = [*cases.rolling(rng, 3), *cases.centred(rng, 1), *cases.plain(rng), *cases.level(rng)]
    compare(student.contact_inertia, calls, hint="How far is G from the contact, at this phi?")


@check("naive_contact_acceleration", points=0.75)
def naive_acceleration_is_the_moment_over_the_inertia(student, rng):
    """the moment of the weight about C over I^C, at any angle."""
    calls = [*cases.rolling(rng, 3), *cases.plain(rng), *cases.level(rng)]
    hint = "M_C is the moment of the weight, which acts at G; I^C depends on phi."
    compare(student.naive_contact_acceleration, calls, hint=hint)


@check("missing_moment", points=1.25, part="b")
def missing_moment_makes_it_right(student, rng):
    """with it, I^C phi'' + missing_moment = M_C has the phi'' of the balances."""
    hint = "What is the acceleration of the point of the cylinder that touches the ramp?"
    compare(student.missing_moment, [*cases.rolling(rng, 3), *cases.plain(rng)], hint=hint)


@check("contact_force", points=1.25, part="b")
def contact_force_accelerates_G(student, rng):
    """with the weight it is the mass times the acceleration of G; (along, normal)."""
    compare(student.contact_force, cases.slow(rng), hint=partial(part_of_force, student))


@check("contact_force", points=0.25, part="b", after=contact_force_accelerates_G)
def contact_force_may_pull(student, rng):
    """contact is kept where the ramp must pull, and without gravity."""
    calls = [*cases.pulled(rng), *cases.weightless(rng, 2), *cases.level(rng)]
    compare(student.contact_force, calls, hint=partial(of_pull, student))


@check("energy", points=1, part="b")
def energy_of_G_and_of_turning(student, rng):
    """of the motion of G, of the turning, and of the height of G."""
    calls = [*cases.rolling(rng, 3), *cases.weightless(rng, 1), *cases.plain(rng), *cases.level(rng)]
    compare(student.energy, calls, hint="Where is G, and how high above the centre's place at phi = 0?")


@check("simulate", points=0.75, part="b")
def simulate_rolls_and_rocks(student, rng):
    """rolling down and rocking, row i at t[i], row 0 the given state."""
    compare_motions(student.simulate, cases.runs(rng), keeps=KEPT)


@check("simulate", points=0.25, part="b", after=simulate_rolls_and_rocks)
def simulate_needs_no_dense_times(student, rng):
    """the same motion when few times are asked for."""
    compare_motions(student.simulate, cases.few_times(rng))
    hint = "However small the rocking, the other terms are there: do you linearise, or is the tolerance loose?"
    compare_motions(student.simulate, cases.near_lowest(rng), hint=hint, near_miss_credit=False)


@check("simulate", points=0.25, part="b", after=simulate_rolls_and_rocks)
def simulate_rocks_at_the_linear_frequency(student, rng):
    """small rocking on level ground has the frequency of the linear equation."""
    hint = "Is the tolerance absolute, and too coarse for a small motion?"
    motions = cases.small_rocking(rng)
    compare_trajectory(student.simulate, reference.small_rocking, motions, ANGLES, tolerance=ROCKING, hint=hint)


@check("simulate", points=0.25, part="b", after=simulate_rolls_and_rocks)
def simulate_keeps_the_energy(student, rng):
    """the energy stays what it was over many turns."""
    turns = cases.many_turns(rng)
    check_conserved(student.simulate, reference, turns, KEPT, coarsely=COARSELY, partial=SHARES, hint=ANY_DURATION)


ASSIGNMENT = Assignment(
    returns={
        "acceleration": number.described("phi''", "rad/s^2", rate2),
        "contact_inertia": number.described("I^C", "kg m^2"),
        "naive_contact_acceleration": number.described("phi'' from M_C = I^C phi''", "rad/s^2", rate2),
        "missing_moment": number.described("the missing moment", "N m", moment),
        "contact_force": group(
            *(number.described(quantity, "N", force) for quantity in ("the force along the ramp", "the normal force"))
        ),
        "energy": number.described("the energy", "J", lambda case, _: 9 * moment(case)),
        "simulate": rows(2, columns=MOTION, rates=RATES),
        "free_body_diagram": free_body_diagram(2),
    },
    forbidden={},
    needs=("numpy",),
)
