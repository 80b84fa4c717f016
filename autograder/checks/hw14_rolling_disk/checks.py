"""Hidden checks of hw14."""

from dataclasses import replace
from functools import partial

import numpy as np

from tam570_grader import Assignment, check, expect, expect_that
from tam570_grader.checks.compare import Column, absolute, compare_with, own_result
from tam570_grader.checks.diagrams import compare_diagrams
from tam570_grader.checks.expect import FollowsFrom
from tam570_grader.checks.returns import array, free_body_diagram, number, rows
from tam570_grader.checks.trajectory import Invariant, OwnRates, check_conserved, compare_invariants, compare_trajectory

from . import cases, reference

POINTWISE = 1e-9  # careful formulas agree to 1e-13, a numpy.linalg.solve of nine unknowns to 1e-12
FLAT = 1e-8  # at a tilt of 1e-3 a linear system for the angles loses six of its sixteen digits
LINEAR = 1e-7  # the five-point difference has an error of 1e-11; a student's own difference of 1e-9
# Relative tolerances of motions, with the largest error of solve_ivp at rtol = atol = 1e-9 in 120 draws, which is by
# BDF; LSODA has a tenth of it, the others less. RK45 at 1e-6 has an error of 5e-6 or more if the motion is compared.
TRAJECTORY = 5e-6  # 5e-7
KEPT = 1e-6  # 8e-8, of constants: omega along e2 and e3, and the height
AGREED = 2e-5  # 2e-6, of two simulations over a longer time
ROTATION = 2e-5  # 1.2e-6, of R^T R over that time
ENERGY = 5e-6  # 4.3e-7, over a longer time
COARSELY = 1e-3  # 1e-6 over that time; with the centre in place of the contact the error is 3e-2 or more

compare = compare_with(reference, tolerance=POINTWISE)
compare_motions = compare_with(reference, by=compare_trajectory, tolerance=TRAJECTORY)


def euler_of(case):
    state = case.args[-1]
    return reference.euler_state(state, case.kwargs["radius"]) if len(state) == 15 else state


def rate(case, _=None):
    return 1e-3 + np.abs(euler_of(case)[5:]).sum()


def second(case, _=None):
    """Return the scale of angular accelerations."""
    state, disk = euler_of(case), case.kwargs
    return (np.abs(state[5:]).sum() ** 2 + disk["gravity"] / disk["radius"]) / np.sin(state[3])


def force(case, _=None):
    return case.kwargs["mass"] * case.kwargs["radius"] * second(case)


def moment(case, _=None):
    return case.kwargs["radius"] * force(case) + sum(case.kwargs["inertia"]) * second(case)


def radius(case, _=None):
    return case.kwargs["radius"]


def speed(case, _):
    return radius(case) * rate(case)


def size(case, growth):
    return reference.growth_rate_squared(0.0, **case.kwargs) + abs(growth)


def by_largest(quantity, unit, where, least=absolute, turns=False):
    """Return a column of a state or a motion, with the largest number there, or at least `least`, as its scale."""
    return Column(quantity, unit, where, turns, lambda case, states: max(np.abs(states[..., where]).max(), least(case)))


MATRIX_STATE = (
    by_largest("the centre", "m", reference.CENTRE, radius),
    Column("R, row by row,", "", reference.MATRIX, scale=absolute),
    by_largest("omega in space axes", "rad/s", reference.OMEGA),
)
EULER_RATES = (
    Column("the contact's velocity", "m/s", slice(0, 2), scale=speed),
    Column("an angle's rate", "rad/s", slice(2, 5), scale=rate),
    *(Column(f"{angle}''", "rad/s^2", [k], scale=second) for k, angle in enumerate(("yaw", "tilt", "roll"), 5)),
)
MATRIX_RATES = (
    Column("the centre's velocity", "m/s", reference.CENTRE, scale=speed),
    Column("dR/dt", "1/s", reference.MATRIX, scale=rate),
    Column("omega'", "rad/s^2", reference.OMEGA, scale=second),
)
EULER = (
    by_largest("the contact", "m", [0, 1], radius),
    by_largest("yaw", "rad", [2], turns=True),
    by_largest("tilt", "rad", [3]),
    by_largest("roll", "rad", [4], turns=True),
    by_largest("an angle's rate", "rad/s", [5, 6, 7]),
)
BY_MULTIPLIERS = OwnRates("multiplier_state_derivative", reference)
BY_ANGLES = OwnRates("euler_state_derivative", reference)
BY_MATRICES = OwnRates("matrix_state_derivative", reference, otherwise=BY_MULTIPLIERS)


@check("free_body_diagram", points=0.5)
def forces_on_the_disk(student, rng):
    """every force on the disk, where it acts and along what."""

    def own_body(case):
        body = reference.free_body_diagram(*case.args, **case.kwargs)
        centre, (weight, ground) = own_result(student.matrix_state, reference, case)[:3], body.forces
        return replace(body, forces=(replace(weight, point=centre), ground))

    calls = [*cases.instants(rng), *cases.flat_and_upright(rng)]
    compare_diagrams(student.free_body_diagram, reference, calls, (student.matrix_state, own_body))


ROTATES = Invariant("R^T R", "", reference.not_a_rotation, absolute, ROTATION)
HEIGHT = Invariant("the centre's height", "m", reference.above_the_ground, radius, KEPT)
ENERGY_KEPT = Invariant("the energy", "J", lambda rows, **disk: reference.energy(rows.T, **disk), None, ENERGY)
CARRIED = "omega along e2 or e3, carried to the upright disk by the tilt,"
INTEGRALS = Invariant(CARRIED, "rad/s", reference.two_integrals, rate, KEPT)


# (a) Three derivations


def wrong_place(case, result, expected):
    """Return what is exchanged in R or omega, if the numbers show it."""
    x, y, yaw, tilt, roll, *rates = case.args[0]
    exchanged = reference.matrix_state([x, y, roll, tilt, yaw, *rates], **case.kwargs)[reference.MATRIX]
    if np.allclose(result[reference.MATRIX], exchanged):
        return "Yaw and roll are exchanged in R, which is Rz(yaw) Rx(tilt) Rz(roll)."
    turned = rates[1] * (result[3:12:3] - reference.frame(case.args[0])[0])
    placed = expected + np.concatenate([np.zeros(12), turned])
    if np.allclose(result, placed):
        return "Your tilt' turns the disk about its own x axis; it is about e1, which does not roll."
    return "The centre is contact + a e2, R is Rz(yaw) Rx(tilt) Rz(roll), omega is yaw' z + tilt' e1 + roll' e3."


@check("matrix_state", points=0.5)
def matrix_state_places_the_disk(student, rng):
    """matrix_state has the centre, R row by row, and the total omega in space axes."""
    compare(student.matrix_state, cases.instants(rng), hint=wrong_place)


def along(quantity, off, state, limit):
    """Return along which of e1, e2, e3 a vector is wrong; "" if along all of them or none."""
    wrong = np.abs(reference.frame(state) @ off) > limit
    names = [name for name, is_off in zip(("e1", "e2", "e3"), wrong, strict=True) if is_off]
    return f"{quantity} is wrong along {' and '.join(names)} only." if 0 < len(names) < 3 else ""


def wrong_turning(otherwise, case, result, expected):
    """Return where omega' is wrong, to which the second derivatives of the angles contribute."""
    state, off = euler_of(case), result - expected
    e1, _, e3 = reference.frame(state)
    turning = off[reference.OMEGA] if len(off) == 15 else off[5] * reference.Z + off[6] * e1 + off[7] * e3
    return along("omega'", turning, state, POINTWISE * second(case)) or otherwise


TEST_IT = partial(wrong_turning, "Test it on straight rolling, then on hw11's circles.")
IN_SPACE = partial(wrong_turning, "Find dR/dt from omega, then write the balances in space axes.")
ARM = partial(wrong_turning, "Space axes need I = R diag(A, A, C) R^T; differentiate the constraint with its arm.")
NEXT_TO_FLAT = {"tolerance": FLAT, "hint": "No tilt but 0 and pi is singular."}


@check("euler_state_derivative", points=1.25)
def euler_equations_hold(student, rng):
    """euler_state_derivative balances momentum and angular momentum of disk, hoop and wheel."""
    compare(student.euler_state_derivative, cases.timed(rng, cases.instants), hint=TEST_IT)


@check("euler_state_derivative", points=0.25, after=euler_equations_hold)
def euler_equations_hold_next_to_flat_and_upright(student, rng):
    """euler_state_derivative holds at a tilt of 1e-3, and for a disk spinning upright on a point."""
    compare(student.euler_state_derivative, cases.timed(rng, cases.flat_and_upright), **NEXT_TO_FLAT)


@check("matrix_state_derivative", points=0.75)
def matrix_equations_hold(student, rng):
    """the balances hold, and omega in space axes turns R."""
    compare(student.matrix_state_derivative, cases.by_matrix(rng, cases.timed, cases.instants), hint=IN_SPACE)
    compare(student.matrix_state_derivative, cases.by_matrix(rng, cases.timed, cases.flat_and_upright), **NEXT_TO_FLAT)


@check("multiplier_state_derivative", points=0.75)
def multiplier_equations_hold(student, rng):
    """the balances hold, with multipliers for the contact."""
    compare(student.multiplier_state_derivative, cases.by_matrix(rng, cases.timed, cases.instants), hint=ARM)
    compare(
        student.multiplier_state_derivative, cases.by_matrix(rng, cases.timed, cases.flat_and_upright), **NEXT_TO_FLAT
    )


# (b) Simulation, (c) both ways


@check("simulate_euler", points=0.5, part="b")
def euler_simulation_follows_the_motion(student, rng):
    """simulate_euler follows the motion from any start, row i at t[i], row 0 the given state."""
    compare_motions(student.simulate_euler, cases.simulated(rng), keeps=ENERGY_KEPT)


@check("simulate_euler", points=0.5, part="b", after=euler_simulation_follows_the_motion)
def euler_simulation_keeps_energy_and_two_integrals(student, rng):
    """over a long time the energy stays, and omega along e2 and e3 depends only on the tilt."""
    motions, shares = cases.long_motion(rng), {1e-4: 0.5}
    check_conserved(
        student.simulate_euler, reference, motions, INTEGRALS, ENERGY_KEPT, coarsely=COARSELY, partial=shares
    )


@check("simulate_matrix", points=0.5, part="b")
def matrix_simulation_follows_the_motion(student, rng):
    """simulate_matrix follows the motion from any start, row i at t[i], row 0 the given state."""
    compare_motions(student.simulate_matrix, cases.by_matrix(rng, cases.simulated))


BOTH = euler_simulation_follows_the_motion, matrix_simulation_follows_the_motion


@check("simulate_matrix", points=0.5, part="c", after=BOTH)
def both_simulations_agree(student, rng):
    """simulate_matrix agrees with it over a long time; the disk stays on the ground, R a rotation."""
    motions = compare_motions(student.simulate_matrix, cases.by_matrix(rng, cases.long_motion), tolerance=AGREED)
    compare_invariants(student.simulate_matrix, motions, ROTATES, HEIGHT)


# (d) Steady circles


@check("steady_residual", points=0.75, part="d")
def steady_residual_is_the_tilt_acceleration(student, rng):
    """steady_residual is tilt'' at this lean, precession and total spin, steady or not."""
    compare(student.steady_residual, cases.steady(rng), hint="Use tilt = lean + pi/2 and tilt' = 0.")


# (e) The picture


@check("wireframe", points=0.5, part="e")
def wireframe_is_a_rolling_disk(student, rng):
    """wireframe is a closed regular polygon on the rim, and two perpendicular diameters that roll with the disk."""
    pictures = [*cases.pictures(rng)]
    wireframe = student.wireframe.ahead(sum(pictures, []))
    for calls in pictures:
        places = [judge_wireframe(student.matrix_state, case, lines) for case, lines in wireframe.each(calls)]
        apart, hint = reference.turned(np.diff(places, axis=0), np.pi), "Do they roll with the disk?"
        expect(apart, 0.0, tolerance=POINTWISE * 10, quantity="the diameters' place in the disk", unit="rad", hint=hint)


def judge_wireframe(matrix_state, case, lines):
    """Return where the diameters are in the disk, rad; fail for wrong segments."""
    (state,), size, sides = case.args, case.kwargs["radius"], case.kwargs["sides"]
    expect(len(lines), sides + 2, tolerance=0, quantity="the number of segments")
    angles, off = reference.in_the_disk(lines, reference.matrix_state(state, size), size)
    on_the_rim = partial(expect, expected=0.0, tolerance=POINTWISE * size, unit="m")

    def where():
        _, off = reference.in_the_disk(lines, own_result(matrix_state, reference, case), size)
        is_there = off.max() <= POINTWISE * size
        return FollowsFrom("matrix_state") if is_there else "What are the centre and R?"

    on_the_rim(off[:sides], quantity="the distance from the rim of an end of a side", hint=where)
    radii = "A diameter goes from rim to rim." if off[sides:].min() <= POINTWISE * size else ""
    on_the_rim(off[sides:], quantity="the distance from the rim of an end of a diameter", hint=radii)
    angle = partial(expect, tolerance=10 * POINTWISE, unit="rad")  # for points with errors of POINTWISE
    across = reference.turned(angles[:, 1] - angles[:, 0], 2 * np.pi)
    step = 2 * np.pi / sides
    spans = [step] * sides + [np.pi] * 2
    angle(np.abs(across), spans, quantity="the angle that a segment spans", hint="Is the polygon closed and regular?")
    middles = np.diff(np.sort((angles[:sides, 0] + across[:sides] / 2) % (2 * np.pi)))
    expect_that(middles.min() > step / 2, "Two sides are drawn in one place, and one is missing")
    angle(middles, step, quantity="the angle from side to side", hint="The polygon is closed.")
    between = abs(reference.turned(angles[-1, 0] - angles[-2, 0], np.pi))
    angle(between, np.pi / 2, quantity="the angle between the diameters")
    return angles[sides:, 0]


# (f) Energy and force


@check("energy", points=0.75, part="f")
def energy_is_kinetic_and_potential(student, rng):
    """energy adds what moves, what turns and what is high."""
    at_rest = "At rest it is wrong, too: what is the height of the centre?"
    moving = "At rest it is right: look at the speed of the centre and the turning about it."
    calls = sorted(cases.instants(rng), key=lambda case: "at rest" not in case.label)  # those at rest are judged first
    compare(student.energy, calls, hint=lambda case, *_: moving if np.any(case.args[0][5:]) else at_rest)


def wrong_force(case, result, expected):
    """Return what is wrong with the force, if the numbers show it."""
    weight = case.kwargs["mass"] * case.kwargs["gravity"] * reference.Z
    limit = POINTWISE * force(case)
    if abs(np.linalg.norm(result - weight) - np.linalg.norm(expected - weight)) <= limit:
        return "m a of G has the right size: are its sign and its components those along space x, y, z?"
    otherwise = "F - m g = m a of G; the axes along which its velocity is known turn."
    return along("The force", result - expected, case.args[0], limit) or otherwise


@check("contact_force", points=0.75, part="f")
def contact_force_moves_the_centre(student, rng):
    """contact_force is what the centre's acceleration and the weight ask for, in space axes."""
    compare(student.contact_force, cases.instants(rng), hint=wrong_force)


# (g) and (h) Stability


@check("critical_speed", points=0.5, part="g")
def critical_speed_parts_stable_from_unstable(student, rng):
    """critical_speed is the centre's speed at which a small lean neither grows nor swings."""
    compare(student.critical_speed, cases.wheels(rng), tolerance=LINEAR, hint="Linearise: what is yaw' to first order?")


@check("growth_rate_squared", points=0.75, part="h")
def growth_rate_is_that_of_a_small_lean(student, rng):
    """growth_rate_squared is the lean's, below and above the critical speed, and at rest."""
    compare(student.growth_rate_squared, cases.speeds(rng), tolerance=LINEAR, hint="Linearise about upright.")


ASSIGNMENT = Assignment(
    returns={
        "euler_state_derivative": array(8, columns=EULER_RATES),
        "matrix_state_derivative": array(15, columns=MATRIX_RATES),
        "multiplier_state_derivative": array(15, columns=MATRIX_RATES),
        "matrix_state": array(15, columns=MATRIX_STATE),
        "simulate_euler": rows(8, columns=EULER, rates=BY_ANGLES),
        "simulate_matrix": rows(15, columns=MATRIX_STATE, rates=BY_MATRICES),
        "energy": number.described("the energy", "J", moment),
        "contact_force": array(3).described("the force", "N", force),
        "steady_residual": number.described("tilt''", "rad/s^2", lambda case, _: reference.usual(case.kwargs) ** 2),
        "critical_speed": number.described("the critical speed", "m/s"),
        "growth_rate_squared": number.described("the square of the rate", "1/s^2", size),
        "wireframe": array(None, 2, 3),
        "free_body_diagram": free_body_diagram(3),
    },
    forbidden={
        "euler_state_derivative": ("matrix_state_derivative", "multiplier_state_derivative"),
        "matrix_state_derivative": ("euler_state_derivative", "multiplier_state_derivative"),
        "multiplier_state_derivative": ("euler_state_derivative", "matrix_state_derivative"),
    },
    needs=("numpy",),
    states=(8, 15),
)
