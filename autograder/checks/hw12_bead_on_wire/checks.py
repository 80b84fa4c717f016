"""Hidden checks of hw12."""

import math
from dataclasses import replace
from functools import partial
from itertools import islice

import numpy as np

from tam570_grader import Assignment, Failed, check, expect, from_own_lagrangian
from tam570_grader.checks.compare import Column, compare_with, if_nearly, own_result
from tam570_grader.checks.diagrams import compare_diagrams
from tam570_grader.checks.expect import FollowsFrom, NotWritten
from tam570_grader.checks.returns import array, formula, free_body_diagram, number, rows
from tam570_grader.checks.trajectory import Invariant, OwnRates, check_conserved, compare_trajectory

from . import cases, reference

FORMULA = 1e-8  # a few rounding errors make 1e-15, a derivative by central differences 1e-10
FEW_DIGITS = 1e-4  # of x'' next to the bottom; differences of energies have errors of 5e-6 of this small value
TRAJECTORY = 2e-5  # LSODA at rtol 1e-9, atol 1e-9 has an error of 1e-6 after three periods, RK45 and DOP853 less
SHARP_TURN = 2e-4  # the error is 1e-5 after the sharp turns of a steep wire
LOSSES = {1e-3: 0.6, 1e-2: 0.3}  # {relative loss of energy: share of the points}
ENERGY = 7e-5  # BDF at the same tolerances loses 7e-6 of it in thirty periods, the others 1e-6
COARSELY = 0.03  # of the amplitude after many periods; other rows of the motion have an error of one or two
PERIOD = 1e-6  # a quadrature with a singular end, or an event of a simulation, has an error of 1e-8
MUCH_BETTER = 0.1  # of the relative error at a fourth of the amplitude: a series has less, a singular end as much
TINY = 5e-4  # at micrometres an event of a simulation with an absolute tolerance of 1e-9 m has an error of 5e-5

compare = compare_with(reference, tolerance=FORMULA)
compare_motions = compare_with(reference, by=compare_trajectory, tolerance=TRAJECTORY)
compare_energy = compare_with(reference, by=check_conserved, coarsely=COARSELY)


def largest_term(case, acceleration):
    """Return the size of x'' or, if it is zero, of the terms that cancel in it."""
    values = dict(zip(("x", "v"), case.args, strict=False)) | {k[0]: value for k, value in case.kwargs.items()}
    return abs(acceleration) or values["g"] + values["c"] * values["v"] ** 2


def size(case, states):
    """Return the amplitude; without gravity the farthest place."""
    _, x, v = case.args
    return reference.amplitude(x, v, **case.kwargs) if case.kwargs["gravity"] else np.max(np.abs(states[:, 0]))


def pace(case, states):
    rate = math.sqrt(2 * case.kwargs["gravity"] * case.kwargs["curvature"])
    return size(case, states) * rate or np.max(np.abs(states[:, 1]))


MOTION = (Column("x", "m", [0], scale=size), Column("v", "m/s", [1], scale=pace))
KEPT = Invariant("the energy", "of its start", reference.energy_of_rows, None, ENERGY)


@check("free_body_diagram", points=0.5)
def forces_on_the_bead(student, rng):
    """every force on the bead, where it acts and along what."""

    def own_body(case):
        at_rest = case.replace(*case.args, 0.0)
        body, along = reference.free_body_diagram(*case.args, **case.kwargs), own_result(force, reference, at_rest)
        weight, wire = body.forces
        return replace(body, forces=(weight, replace(wire, along=along)))

    force = student.constraint_force
    compare_diagrams(student.free_body_diagram, reference, cases.places(rng), (force, own_body))


@check("lagrangian", points=1)
def lagrangian_is_kinetic_less_potential(student, rng):
    """T - V in x, v, m, c, g, V up to a constant."""
    calls = cases.symbols(rng)
    values = student.lagrangian.each([*(case.replace(x=0.0, v=0.0) for case in calls), *calls])
    levels = [level for _, level in islice(values, len(calls))]
    hint = "How fast is the bead along the wire, and how high?"
    for level, (case, value) in zip(levels, values, strict=True):
        tolerance = FORMULA * (reference.energy(*case.kwargs.values()) or 1.0)
        expected = reference.lagrangian(**case.kwargs)
        expect(value - level, expected, tolerance=tolerance, quantity="the Lagrangian", unit="J", hint=hint)


@check("lagrange_equation", points=1.5)
def lagrange_gives_the_acceleration(student, rng):
    """x'' in x, v, c, g alone."""
    calls = cases.symbols(rng)
    hint = from_own_lagrangian(student, calls, "dT/dv depends on x: its rate has a term with v. dT/dx is not zero.")
    compare(student.lagrange_equation, calls, hint=hint)


def at_rest_or_not(at_rest, moving):
    """Return a hint that depends on whether the bead is at rest."""
    return lambda case, *_: moving if case.args[1] else at_rest


TWICE = at_rest_or_not(
    "Which part of g is along the wire, and what is its x component?",
    "Is y'' = 2 c v^2 + 2 c x x'', and v the rate of x?",
)


@check("acceleration_newton", points=1.5, part="b")
def newton_gives_the_acceleration(student, rng):
    """x'' by F = m a along the tangent, as Lagrange has it."""
    compare(student.acceleration_newton, cases.beads(rng), hint=TWICE)
    compare(student.acceleration_newton, cases.next_to_bottom(rng), tolerance=FEW_DIGITS, hint=TWICE)


BEND = at_rest_or_not("How much of the weight does a slope carry?", "How sharply does the wire bend at x?")


def source_or(student, otherwise, case, force, expected=None):
    """Return FollowsFrom lagrange_equation if the force makes the student's own wrong x'' of it, else a hint."""
    (x, v), (mass, curvature, gravity) = case.args, (case.kwargs[name] for name in ("mass", "curvature", "gravity"))
    try:
        (a,) = student.lagrange_equation.at([{"x": x, "v": v, "c": curvature, "g": gravity}])
    except (Failed, NotWritten):
        return otherwise(case, force, expected)
    needed = mass * np.array([a, 2 * curvature * (v**2 + x * a) + gravity])
    is_wrong = not np.allclose(needed, reference.constraint_force(*case.args, **case.kwargs))
    if is_wrong and np.allclose(force, needed):
        return FollowsFrom("lagrange_equation")
    return otherwise(case, force, expected)


@check("constraint_force", points=0.75, part="b")
def force_has_the_right_size(student, rng):
    """as large as carrying and turning the bead takes."""
    for case, force in student.constraint_force.each(cases.beads(rng) + cases.next_to_bottom(rng)):
        size = math.hypot(*reference.constraint_force(*case.args, **case.kwargs))
        tolerance = FORMULA * (size or 1.0)
        hint = partial(source_or, student, BEND, case, force)
        expect(math.hypot(*force), size, tolerance=tolerance, quantity="the size of the force", unit="N", hint=hint)


def of_direction(case, force, expected):
    """Return in which way a force of the right size is wrong."""
    along = np.dot(force, [1.0, 2 * case.kwargs["curvature"] * case.args[0]])
    if abs(along) <= 1e-6 * np.linalg.norm(force):
        return "It is normal to the wire, and points to the other side: return the force on the bead."
    return "Its dot product with the tangent (1, 2 c x) is not zero; without friction it is normal to the wire."


@check("constraint_force", points=0.5, part="b", after=force_has_the_right_size)
def force_and_weight_make_the_acceleration(student, rng):
    """normal to the wire, and with the weight it is m a."""
    hint = partial(source_or, student, of_direction)
    compare(student.constraint_force, [*cases.beads(rng), *cases.next_to_bottom(rng)], hint=hint)


SPEED = at_rest_or_not("At rest it is potential: how high is the bead?", "How fast is the bead along the wire?")


@check("energy", points=1, part="b")
def energy_is_kinetic_and_potential(student, rng):
    """of the speed along the wire and of the height above the bottom."""
    compare(student.energy, [*cases.beads(rng), *cases.next_to_bottom(rng), *cases.nearly_at_rest(rng)], hint=SPEED)


BY_EQUATION = OwnRates("lagrange_equation", reference, lambda t, row: tuple(row))
RATES = OwnRates("acceleration_newton", reference, lambda t, row: tuple(row), otherwise=BY_EQUATION)


@check("simulate", points=0.75, part="b")
def simulate_slides(student, rng):
    """large motions, row i at t[i], row 0 the given state."""
    compare_motions(student.simulate, cases.wide(rng), keeps=KEPT)


@check("simulate", points=0.25, part="b", after=simulate_slides)
def simulate_needs_no_dense_times(student, rng):
    """the same motion when only a few times are asked for."""
    compare_motions(student.simulate, cases.few_times(rng))
    hint = "Do you leave terms out at small amplitudes, or is atol too loose for them?"
    compare_motions(student.simulate, cases.close(rng), hint=hint, near_miss_credit=False)


@check("simulate", points=0.25, part="b", after=simulate_slides)
def simulate_without_gravity(student, rng):
    """without gravity the bead keeps its speed, whatever was asked before."""
    compare_motions(student.simulate, cases.weightless(rng), hint="Is anything divided by gravity?")


@check("simulate", points=0.25, part="b", after=simulate_slides)
def simulate_slides_down_steep_wires(student, rng):
    """an amplitude of many 1/c, where the bead turns sharply at the bottom."""
    hint = "Are the steps short enough for the turn at the bottom?"
    compare_motions(student.simulate, cases.steep(rng), tolerance=SHARP_TURN, hint=hint)


@check("simulate", points=0.25, part="b", after=simulate_slides)
def simulate_keeps_the_energy(student, rng):
    """the energy stays what it was over many periods."""
    hint = "Do your steps grow with the duration, or is the tolerance loose?"
    compare_energy(student.simulate, cases.many_periods(rng), KEPT, partial=LOSSES, hint=hint)


def of_accuracy(student, case, period, expected):
    """Return what a nearly right period at a smaller amplitude shows, and a question that follows from it."""
    small = case.replace(case.args[0] / 4)
    exact = reference.period(*small.args, **small.kwargs)
    if abs(student.period.aside(small) / exact - 1) < MUCH_BETTER * abs(period / expected - 1):
        return ", and much better at a smaller amplitude: does a series end too early, or has a quadrature few points?"
    return ", and hardly better at a smaller amplitude: is your quadrature exact where v is zero?"


@check("period", points=1, part="b")
def period_is_exact(student, rng):
    """exact for amplitudes near 1/c."""
    energy = "The energy gives v at every x, and dt is dx/v; the wire is longer than x."
    hint = if_nearly(partial(of_accuracy, student), energy)
    compare(student.period, cases.usual_periods(rng), tolerance=PERIOD, hint=hint)


@check("period", points=0.5, part="b", after=period_is_exact)
def period_of_small_and_of_huge_amplitudes(student, rng):
    """exact on almost flat and on almost upright wires."""
    root = "Do you add a small number under a root, or use an absolute tolerance? 1e-15 m^2 is not small here."
    reach = "Does your series or quadrature reach amplitudes of a hundred times 1/c?"
    compare(student.period, cases.tiny_periods(rng), tolerance=TINY, hint=root)
    compare(student.period, cases.small_periods(rng), tolerance=PERIOD, hint="Do you subtract nearly equal heights?")
    compare(student.period, [*cases.large_periods(rng), *cases.largest_period(rng)], tolerance=PERIOD, hint=reach)


ASSIGNMENT = Assignment(
    returns={
        "lagrangian": formula(*cases.SYMBOLS),
        "lagrange_equation": formula("x", "v", "c", "g").described("x''", "m/s^2", largest_term),
        "acceleration_newton": number.described("x''", "m/s^2", largest_term),
        "constraint_force": array(2).described("the force", "N", lambda _, force: math.hypot(*force)),
        "energy": number.described("the energy", "J"),
        "simulate": rows(2, columns=MOTION, rates=RATES),
        "period": number.described("the period", "s"),
        "free_body_diagram": free_body_diagram(2),
    },
    forbidden={"*": ("tam570.lagrange", "tam570.lectures")},
    needs=("numpy", "sympy"),
)
