"""Hidden checks of hw05."""

import math

import numpy as np

from tam570_grader import Column, Invariant, agree, check, expect, follow, given, law, refuse, stays
from tam570_grader.writing.returns import array, number, rows

from . import cases, right

NEEDS = ("numpy",)

FORMULA = 1e-9  # a few roundings make 1e-15, a linear system 1e-14
FOLLOWED = 3e-5  # solve_ivp at rtol 1e-9, atol 1e-9 is off by 3e-6 after three periods
# of m g l: in the 100 s the same solvers lose 5e-6 of it (LSODA, the rows put back onto the circle), and 5e-5 (RK45)
# where the rates take the distance from the hinge for l, whatever it has become between the rows
ENERGY = 5e-5
CONSTRAINT = 1e-9  # of the contract: any step back onto the circle makes 1e-15, and 1e-12 between steps
TOP = 1e-6  # an angle of pi, which is rounded, falls by 1e-16 exp(8) = 4e-13
COARSELY = 0.3  # of the scale: in 100 s a loose tolerance shifts the phase, a motion of its own is off by 1
ROUNDED = 1e-12  # what a step back onto the circle leaves


def pull(case, _=None):
    """The size of an acceleration, m/s^2."""
    v, known = case.args[-1][2:], case.kwargs
    return v @ v / known["length"] + known["gravity"] or 1.0


def force(case, _=None):
    return case.kwargs["mass"] * pull(case)


def heat(case, _=None):
    """The size of an energy, J."""
    (x, y, vx, vy), known = case.args[0], case.kwargs
    return known["mass"] * ((vx**2 + vy**2) + known["gravity"] * math.hypot(x, y)) or 1.0


def state_size(case, _):
    return np.repeat([case.kwargs["length"], math.hypot(*case.args[0][2:]) or 1.0], 2)


def speed(case, expected):
    known = case.kwargs
    return max(np.abs(expected[:, 2:]).max(), math.sqrt(known["gravity"] * known["length"]))


def one(*_):
    return 1.0


MOTION = (
    Column("the place", "m", [0, 1], scale=lambda case, _: case.kwargs["length"]),
    Column("the velocity", "m/s", [2, 3], scale=speed),
)
KEPT = Invariant("the energy", "of m g l", right.energies, one, ENERGY)


RESULTS = {
    "constraint_force": array(2).called("the constraint force", "N", force),
    "acceleration": array(2).called("the acceleration", "m/s^2", pull),
    "consistent_state": array(4).called("the state", "of its size", state_size),
    "energy": number.called("the energy", "J", heat),
    "simulate": rows(4, columns=MOTION),
    "wireframe": array(1, 2, 2).called("an end of the rod", "m"),
}


@check(points=2, part="a")
def force_keeps_the_particle_on_the_circle(student, draw):
    """constraint_force: radial, and such that F = m a keeps x^2 + y^2 as it is."""
    hint = "Differentiate x^2 + y^2 = l^2 twice: which unknown does F = m a leave?"
    agree(student.constraint_force, right, cases.states(draw), within=FORMULA, hint=hint)


acceleration_is_that_of_both_forces = law(
    "acceleration: by the weight and the constraint force.", points=1.5, part="a"
).agrees(right.acceleration, cases.states, within=FORMULA, hint="What is r . a on the circle?")
consistent_state_is_the_nearest = law(
    "consistent_state: the position goes along its radius onto the circle, the velocity loses its radial part.",
    points=1.25,
    part="a",
).agrees(right.consistent_state, cases.off_circle, within=FORMULA, hint="Which part of v is along the radius?")


@check(points=0.25, part="a", after=consistent_state_is_the_nearest)
def consistent_state_refuses_the_origin(student, draw):
    """consistent_state raises ValueError where no point of the circle is the nearest."""
    allowed = given(np.array([0.0, -2.0, 1.0, 1.0]), length=1.0)
    accepts = [(allowed, right.consistent_state(*allowed.args, **allowed.kwargs))]
    hint = "Which point of the circle is nearest to its centre?"
    refuse(student.consistent_state, cases.origin(draw), accepts=accepts, within=FORMULA, hint=hint)


@check(points=1, part="a")
def energy_is_kinetic_and_potential(student, draw):
    """energy: m v^2/2 and the potential energy of the weight, zero at y = 0."""
    hint = "How high is it above y = 0, and how fast?"
    agree(student.energy, right, cases.states(draw, "mass", "gravity"), within=FORMULA, hint=hint)


@check(points=0.75, part="a")
def without_gravity_it_goes_round_uniformly(student, draw):
    """simulate: uniform motion around the circle where there is no gravity."""
    hint = "What changes the velocity when there is no weight?"
    follow(student.simulate, right, cases.without_gravity(draw), within=FOLLOWED, hint=hint, keeps=KEPT)


with_gravity_it_swings_or_goes_round = law(
    "simulate: the state at few and uneven times, the first of which is not 0.", points=1, part="a"
).follows(right.simulate, cases.with_gravity, within=FOLLOWED, hint="Do both forces turn the velocity?", keeps=KEPT)


@check(points=1, part="a", after=with_gravity_it_swings_or_goes_round)
def it_stays_on_the_circle(student, draw):
    """simulate: after 100 s the particle is still on the circle, and its velocity tangent to it."""
    (motion,) = follow(student.simulate, right, cases.long(draw), within=COARSELY, gradual=False)
    (x, y, vx, vy), length = motion.found.T, motion.case.kwargs["length"]
    off = (x**2 + y**2) / length**2 - 1
    out = (x * vx + y * vy) / (length * speed(motion.case, motion.expected))
    (of, hint), share = drift(off, out), {1e-7: 0.5, 1e-5: 0.25}
    known = {"of": of, "unit": "of its size", "t": motion.t, "hint": hint}
    expect(np.column_stack([off, out]), 0.0, within=CONSTRAINT, partial=share, **known)


def drift(off, out):
    """What leaves the circle, and what nothing takes back."""
    if np.abs(off).max() <= ROUNDED:
        return "r . v = 0", "The place is put back onto the circle: is the velocity made tangent?"
    if np.abs(out).max() <= ROUNDED:
        return "x^2 + y^2 = l^2", "The velocity is made tangent: is the place put back onto the circle?"
    hint = "Neither place nor velocity is put back: what corrects the errors of the steps?"
    return "x^2 + y^2 = l^2 or r . v = 0", hint


@check(points=0.25, part="a", after=with_gravity_it_swings_or_goes_round)
def energy_stays(student, draw):
    """simulate: after 100 s the energy has its first value."""
    hint = "Tighten rtol and atol: does it leave the circle between the samples?"
    share = {1e-3: 0.6, 1e-2: 0.3}
    stays(student.simulate, right, cases.long(draw), KEPT, coarsely=COARSELY, partial=share, hint=hint)


@check(points=0.5, part="a", after=with_gravity_it_swings_or_goes_round)
def at_the_very_top_it_stays(student, draw):
    """simulate: at rest straight above the hinge it is in equilibrium."""
    hint = "What do the two forces add up to there?"
    follow(student.simulate, right, cases.at_the_top(draw), within=TOP, hint=hint)


@check(points=0.5, part="a")
def wireframe_is_the_rod(student, draw):
    """wireframe: one segment, from the hinge to the particle."""
    hint = "Its first end is the hinge, its second the particle."
    agree(student.wireframe, right, cases.states(draw, "length"), within=FORMULA, hint=hint)
