"""Hidden checks of hw05."""

import numpy as np

from tam570_grader import Assignment, check, expect
from tam570_grader.checks.compare import Column, absolute, check_domain, compare_with
from tam570_grader.checks.diagrams import compare_diagrams
from tam570_grader.checks.returns import array, free_body_diagram, number, rows
from tam570_grader.checks.trajectory import Invariant, OwnRates, compare_invariants, compare_trajectory

from . import cases, reference

FORMULA = 1e-9  # a few rounding errors make 1e-15, a linear system 1e-14
FOLLOWED = 1e-4  # solve_ivp at rtol = atol = 1e-9 has an error of 3e-8 (LSODA) or less in a swing
# of m g l: in the 100 s the same solvers lose 2e-6 of it at most (BDF, if the force uses the given l for the distance
# from the hinge, which has changed between the rows)
ENERGY = 5e-5
CONSTRAINT = 1e-9  # from the contract; a projection onto the circle leaves 1e-15, and 1e-12 between steps
ENERGY_SHARES = {1e-3: 0.9, np.inf: 0.8}  # {loss: share of the points}; most points are for the constraint
TOP = 1e-6  # the rounding error of an angle of pi grows to 1e-16 exp(20) = 6e-8
COARSELY = 0.05  # of the scale: in 100 s a loose tolerance shifts the phase; wrong equations make 0.9 and more
ROUNDED = 1e-12  # a projection onto the circle leaves less

compare = compare_with(reference, tolerance=FORMULA)
compare_motions = compare_with(reference, by=compare_trajectory, tolerance=FOLLOWED)


def pull(case, _=None):
    """Return the scale of an acceleration, m/s^2."""
    v, parameters = case.args[-1][2:], case.kwargs
    return v @ v / parameters["length"] + parameters["gravity"] or 1.0


def heat(case, _):
    """Return the scale of an energy, J."""
    (x, y, vx, vy), parameters = case.args[0], case.kwargs
    return parameters["mass"] * ((vx**2 + vy**2) + parameters["gravity"] * np.hypot(x, y)) or 1.0


def state_size(case, _):
    return np.repeat([case.kwargs["length"], np.hypot(*case.args[0][2:]) or 1.0], 2)


def speed(case, expected):
    parameters = case.kwargs
    return max(np.abs(expected[:, 2:]).max(), np.sqrt(parameters["gravity"] * parameters["length"]))


MOTION = (
    Column("the place", "m", [0, 1], scale=lambda case, _: case.kwargs["length"]),
    Column("the velocity", "m/s", [2, 3], scale=speed),
)
RATES = OwnRates("acceleration", reference, lambda t, row: (row,), passes="consistent_state")
KEPT = Invariant("the energy", "of m g l", reference.energies, absolute, ENERGY)


@check("free_body_diagram", points=0.5)
def forces_on_the_particle(student, rng):
    """every force on the particle, where it acts and along what."""
    compare_diagrams(student.free_body_diagram, reference, cases.states(rng))


def of_mending(case, result, expected):
    on_circle = np.allclose(result[:2], expected[:2], rtol=0, atol=FORMULA * case.kwargs["length"])
    if not on_circle:
        return "Which point of the circle is on the same radius?"
    tangent = abs(np.dot(result[:2], result[2:])) <= FORMULA * np.linalg.norm(result[:2]) * np.linalg.norm(result[2:])
    if tangent and np.any(result[2:]):
        return "Your velocity is tangent to the circle; keep v's tangential part as it is."
    return "Which part of v is along the radius?"


@check("constraint_force", points=2)
def force_keeps_the_particle_on_the_circle(student, rng):
    """radial, and such that F = m a keeps x^2 + y^2 as it is."""
    hint = "Differentiate x^2 + y^2 = l^2 twice: which unknown does F = m a leave?"
    compare(student.constraint_force, cases.states(rng), hint=hint)


@check("acceleration", points=1.5)
def acceleration_is_that_of_both_forces(student, rng):
    """by the weight and the constraint force."""
    compare(student.acceleration, cases.states(rng), hint="Do both forces act, and what is r . a?")


@check("consistent_state", points=1.25)
def consistent_state_is_the_nearest(student, rng):
    """the place goes along its radius onto the circle, v loses its radial part."""
    compare(student.consistent_state, cases.off_circle(rng), hint=of_mending)


@check("consistent_state", points=0.25, after=consistent_state_is_the_nearest, refusals=True)
def consistent_state_refuses_the_origin(student, rng):
    """consistent_state raises ValueError where no point of the circle is the nearest."""
    hint = "Which point of the circle is nearest to its centre?"
    check_domain(student.consistent_state, reference, cases.origin(rng), tolerance=FORMULA, hint=hint)


@check("energy", points=1)
def energy_is_kinetic_and_potential(student, rng):
    """m v^2/2 and the potential energy of the weight, zero at y = 0."""
    compare(student.energy, cases.states(rng), hint="How high is it above y = 0, and how fast?")


@check("simulate", points=0.5)
def without_gravity_it_goes_round_uniformly(student, rng):
    """uniform motion around the circle where there is no gravity."""
    compare_motions(student.simulate, cases.without_gravity(rng), keeps=KEPT)


@check("simulate", points=0.75)
def with_gravity_it_swings_or_goes_round(student, rng):
    """the state at few and uneven times, the first of which is not 0."""
    compare_motions(student.simulate, cases.with_gravity(rng), keeps=KEPT)


LEAVES = "Do place and velocity leave the circle: what corrects the errors of the steps?"


@check("simulate", points=1.25, after=with_gravity_it_swings_or_goes_round)
def it_stays_on_the_circle(student, rng):
    """after 100 s the particle is still on the circle, its velocity tangent to it, its energy the first."""
    motions = compare_motions(
        student.simulate, cases.long(rng), tolerance=COARSELY, hint=LEAVES, near_miss_credit=False
    )
    (motion,) = motions
    (x, y, vx, vy), length = motion.actual.T, motion.case.kwargs["length"]
    off = (x**2 + y**2) / length**2 - 1
    out = (x * vx + y * vy) / (length * speed(motion.case, motion.expected))
    words = {**drift(off, out), "unit": "of its size", "t": motion.t, "partial": {1e-7: 0.5, 1e-5: 0.25}}
    expect(np.column_stack([off, out]), 0.0, tolerance=CONSTRAINT, **words)
    hint = "Tighten rtol and atol: does it leave the circle between the samples?"
    compare_invariants(student.simulate, motions, KEPT, partial=ENERGY_SHARES, hint=hint)


def drift(off, out):
    """Return the name of the constraint that is violated, and a hint."""
    constraint, hint = "x^2 + y^2 = l^2 or r . v = 0", LEAVES
    if np.abs(off).max() <= ROUNDED:
        constraint, hint = "r . v = 0", "The place is put back: is the velocity made tangent?"
    elif np.abs(out).max() <= ROUNDED:
        constraint, hint = "x^2 + y^2 = l^2", "The velocity is made tangent: is the place put back?"
    return {"quantity": f"the constraint {constraint}", "hint": hint}


@check("simulate", points=0.5, after=with_gravity_it_swings_or_goes_round)
def at_the_very_top_it_stays(student, rng):
    """at rest straight above the hinge it is in equilibrium."""
    hint = "What do the two forces add up to there?"
    compare_motions(student.simulate, cases.at_the_top(rng), tolerance=TOP, hint=hint, loose_tolerance_credit=False)


@check("wireframe", points=0.5)
def wireframe_is_the_rod(student, rng):
    """one segment, from the hinge to the particle."""
    compare(student.wireframe, cases.states(rng), hint="Its first end is the hinge, its second the particle.")


ASSIGNMENT = Assignment(
    returns={
        "constraint_force": array(2).described(
            "the constraint force", "N", lambda case, _: case.kwargs["mass"] * pull(case)
        ),
        "acceleration": array(2).described("the acceleration", "m/s^2", pull),
        "consistent_state": array(4).described("the state", "of its size", state_size),
        "energy": number.described("the energy", "J", heat),
        "simulate": rows(4, columns=MOTION, rates=RATES),
        "wireframe": array(1, 2, 2).described("an end of the rod", "m"),
        "free_body_diagram": free_body_diagram(2),
    },
    forbidden={},
    needs=("numpy",),
    states=(3,),
)
