"""Hidden checks of hw01."""

import math

import numpy as np

from tam570_grader import Assignment, check, expect, from_own_lagrangian
from tam570_grader.checks.compare import Column, absolute, compare_with, if_nearly
from tam570_grader.checks.diagrams import compare_diagrams
from tam570_grader.checks.returns import formula, free_body_diagram, group, number, rows
from tam570_grader.checks.trajectory import Invariant, OwnRates, check_conserved, compare_trajectory

from . import cases, reference

FORMULA = 1e-8  # a few rounding errors make 1e-15, a derivative by central differences 1e-10
TRAJECTORY = 2e-5  # LSODA at rtol 1e-9, atol 1e-9 has an error of 8e-8 at most, RK45 and DOP853 less
ENERGY = 1e-5  # the same solvers lose 5e-8 of it in six periods
COARSELY = 0.1  # rad after six periods; other rows of the motion have an error of one or two
PERIOD = 1e-6  # a quadrature with a singular end, or an event of a simulation, has an error of 1e-8
NEXT_TO_TOP = 1e-5  # the errors of the same simulation are ten times as large there
# At 1e-5 rad, and as far from the top, the same simulation has an error of 7e-5; a difference of cosines has no digit.
AT_THE_ENDS = 1e-3
LOSSES = {1e-4: 0.6, 1e-2: 0.3}  # {relative loss of energy: share of the points}
SMALL = 1e-3  # size of a variation; its square is below VARIATION
VARIATION = 1e-4  # a quadrature of second order has an error of (2 pi 1.5/2000)^2/3 = 7e-6
ACTION = 1e-5  # a quadrature of second order has an error of (4/4000)^2/3 = 3e-7, one of first order 2e-4

compare = compare_with(reference, tolerance=FORMULA)
compare_motions = compare_with(reference, by=compare_trajectory, tolerance=TRAJECTORY)


def power_of_rate(n, mass, length):
    """Return the scale m^mass l^length (omega + sqrt(g/l))^n as a function of a case, or of values for symbols."""

    def scale(case, _=None):
        parameters = {**dict(zip(cases.SYMBOLS, case.args, strict=False)), **case.kwargs}
        value = {name[0]: quantity for name, quantity in parameters.items()}
        rate = abs(value.get("o", 0.0)) + math.sqrt(value["g"] / value["l"])
        return value.get("m", 1.0) ** mass * value["l"] ** length * rate**n

    return scale


RATE2, FORCE = power_of_rate(2, 0, 0), power_of_rate(2, 1, 1)
MOMENTUM, MOMENT, POWER = power_of_rate(1, 1, 2), power_of_rate(2, 1, 2), power_of_rate(3, 1, 2)


def size_of_action(case, _):
    """Return the integral of T + V, which is the action with inverted gravity."""
    return abs(reference.action(*case.args, **{**case.kwargs, "gravity": -case.kwargs["gravity"]}))


def fastest(case, _):
    """Return the larger of the initial angular velocity and the rate of small motions."""
    return max(abs(case.args[2]), math.sqrt(case.kwargs["gravity"] / case.kwargs["length"]))


MOTION = (Column("theta", "rad", [0], turns=True, scale=absolute), Column("omega", "rad/s", [1], scale=fastest))
RATES = OwnRates("lagrange_equation", reference, lambda t, row: (row[0],))
KEPT = Invariant("the energy", "of its start", reference.energy_of_rows, None, ENERGY)
ALPHA = number.described("alpha", "rad/s^2", RATE2)


@check("free_body_diagram", points=0.5)
def forces_on_the_mass(student, rng):
    """every force on the mass, where it acts and along what."""
    compare_diagrams(student.free_body_diagram, reference, states(rng))


def states(rng):
    return [*cases.states(rng), *cases.at_rest(rng)]


@check("linear_momentum_balance", points=0.5)
def newton_gives_the_acceleration(student, rng):
    """alpha, along the circle."""
    compare(student.linear_momentum_balance, states(rng), only=0, hint="What of each force is along the circle?")


@check("linear_momentum_balance", points=0.5)
def newton_gives_the_tension(student, rng):
    """the tension, along the rod."""
    compare(student.linear_momentum_balance, states(rng), only=1, hint="Which way along the rod does m a point?")


@check("angular_momentum_balance", points=0.5)
def moments_give_the_acceleration(student, rng):
    """alpha, by M = dH/dt."""
    compare(student.angular_momentum_balance, states(rng), only=0, hint="Which way does the weight turn it?")


@check("angular_momentum_balance", points=0.5)
def momentum_and_moment_are_about_the_hinge(student, rng):
    """r x m v and the moment of the weight, about the hinge."""
    hint = "How far from the hinge do momentum and weight act?"
    compare(student.angular_momentum_balance, states(rng), only=(1, 2), hint=hint)


@check("energy_balance", points=0.5)
def energies_are_right(student, rng):
    """T, and V, which is zero at the lowest point."""
    compare(student.energy_balance, cases.states(rng), only=(1, 2), hint="How fast is the mass, and how high?")


@check("energy_balance", points=0.25)
def energy_gives_the_acceleration(student, rng):
    """alpha, from the constancy of the energy."""
    compare(student.energy_balance, cases.states(rng), only=0, hint="The terms of dE/dt have a factor in common.")


CANCELLED = "Do you divide by omega? Cancel it on paper."


@check("energy_balance", points=0.25, after=energy_gives_the_acceleration)
def energy_gives_the_acceleration_at_rest(student, rng):
    """alpha where omega is zero, too."""
    compare(student.energy_balance, cases.at_rest(rng), only=(0, 1), hint=CANCELLED)


@check("power_balance", points=0.25)
def power_gives_the_acceleration(student, rng):
    """the power of gravity, and alpha from it."""
    compare(student.power_balance, cases.states(rng), hint="Power is F . v: when does gravity speed the mass up?")


@check("power_balance", points=0.25, after=power_gives_the_acceleration)
def power_gives_the_acceleration_at_rest(student, rng):
    """alpha where omega is zero, too."""
    compare(student.power_balance, cases.at_rest(rng), hint=CANCELLED)


@check("virtual_work", points=0.5)
def virtual_work_gives_the_acceleration(student, rng):
    """the generalized force of gravity, and alpha from it."""
    compare(student.virtual_work, states(rng), hint="dr is l dtheta, across the rod.")


@check("lagrangian", points=0.75)
def lagrangian_is_kinetic_less_potential(student, rng):
    """T - V in theta, omega, m, l, g, with V zero at the lowest point."""
    hint = "Put numbers in: at rest at the lowest point it is zero, at rest elsewhere negative."
    compare(student.lagrangian, cases.symbols(rng), hint=hint)


@check("lagrange_equation", points=0.75)
def lagrange_gives_the_acceleration(student, rng):
    """alpha in theta, l, g alone."""
    calls = cases.symbols(rng)
    hint = from_own_lagrangian(student, calls[:2], "It is the alpha of the other balances.")
    compare(student.lagrange_equation, calls, hint=hint)


@check("action", points=0.5)
def action_is_stationary_on_motions(student, rng):
    """its first variation vanishes on true motions, and on other paths it does not."""
    paths = cases.varied_paths(rng, SMALL)
    hint = "Is it the integral of T - V, by a quadrature of second order that counts both ends as it must?"
    results = student.action.each([case for both, _ in paths for case in both])
    for _, expected in paths:
        (case, high), (_, low) = next(results), next(results)
        size = math.prod(case.kwargs.values()) * case.args[1] * (len(case.args[0]) - 1)  # m g l times the duration
        expect(
            (high - low) / (2 * SMALL),
            expected,
            tolerance=VARIATION * size,
            quantity="the first variation",
            unit="J s/rad",
            hint=hint,
            near_miss_credit=False,
        )


@check("action", points=0.5, after=action_is_stationary_on_motions)
def action_is_the_integral(student, rng):
    """the integral of T - V itself, to second order in the step."""
    hint = "V is zero at the lowest point; n samples make n - 1 steps, and half the step must quarter the error."
    compare(student.action, [*cases.paths(rng), *cases.plain_paths(rng)], tolerance=ACTION, hint=hint)


def of_harmonic(case, result, expected):
    """Return which part of a closed form is right."""
    theta, omega = np.abs(result - expected).max(axis=0) <= TRAJECTORY * np.array([1.0, fastest(case, expected)])
    if theta or omega:
        return "theta is right: differentiate it." if theta else "omega is right, theta is not: is it its integral?"
    if len(result) > 2 and not np.ptp(result, axis=0).any():
        return "Every row is the same: use the times in t."
    turned = math.sqrt(case.kwargs["gravity"] / case.kwargs["length"]) * case.args[0]
    waves = np.column_stack([np.cos(turned), np.sin(turned)])
    residual = result[:, 0] - waves @ np.linalg.lstsq(waves, result[:, 0])[0]
    if len(result) > 2 and np.abs(residual).max() <= TRAJECTORY * np.abs(result).max():
        return "It oscillates at the right rate: which state does it give at t = 0?"
    return "theta does not oscillate at the rate sqrt(g/l)."


@check("small_angle_solution", points=0.5)
def small_angle_solution_is_harmonic(student, rng):
    """theta and omega of theta'' + (g/l) theta = 0, from the state at t = 0."""
    compare(student.small_angle_solution, cases.small_angles(rng), tolerance=TRAJECTORY, hint=of_harmonic)


@check("small_angle_solution", points=0.25, after=small_angle_solution_is_harmonic)
def small_angle_solution_without_gravity(student, rng):
    """without gravity the pendulum turns uniformly."""
    hint = "What becomes of sin(w t)/w, w = sqrt(g/l), as w goes to zero?"
    compare(student.small_angle_solution, cases.weightless(rng), tolerance=TRAJECTORY, hint=hint)


@check("period", points=0.5)
def period_is_exact(student, rng):
    """exact at large amplitudes."""
    energy = "The energy gives omega at theta, and dt = dtheta/omega."
    hint = if_nearly("is your quadrature exact where omega is zero, or your series long enough?", energy)
    compare(student.period, cases.usual_periods(rng), tolerance=PERIOD, hint=hint)


@check("period", points=0.25, after=period_is_exact)
def period_grows_towards_the_top(student, rng):
    """exact from tiny amplitudes to pi, where it has no bound."""
    too_small = "No amplitude is small enough for the period of small angles."
    cosines = "Do you subtract nearly equal cosines? cos a - cos b is a product of sines."
    longer = "A series in the amplitude, or a quadrature of fixed order, does not reach this far."
    compare(student.period, cases.least_periods(rng), tolerance=PERIOD, hint=too_small)
    compare(student.period, cases.small_periods(rng), tolerance=PERIOD, hint=cosines)
    compare(student.period, cases.next_to_top(rng), tolerance=NEXT_TO_TOP, hint=longer)
    compare(student.period, [*cases.smaller_periods(rng), *cases.larger_periods(rng)], tolerance=PERIOD, hint=longer)
    compare(student.period, cases.tiny_periods(rng), tolerance=AT_THE_ENDS, hint=cosines)
    compare(student.period, cases.at_the_top(rng), tolerance=AT_THE_ENDS, hint="Do you subtract nearly equal numbers?")


@check("simulate", points=0.5)
def simulate_swings(student, rng):
    """large swings, row i at t[i], row 0 the given state."""
    hint = "Integrate theta' = omega, omega' = alpha from the state at t[0]."
    compare_motions(student.simulate, cases.large_swings(rng), hint=hint, keeps=KEPT)


@check("simulate", points=0.25, after=simulate_swings)
def simulate_needs_no_dense_times(student, rng):
    """the same at a few times, whatever was asked before."""
    small, *large = cases.few_times(rng)
    linear = "No swing is so small that sin theta is theta: the difference adds up."
    steps = "A fixed number of steps, or a fixed step, does not do for every pendulum."
    compare_motions(student.simulate, [small], hint=linear, loose_tolerance_credit=False)
    compare_motions(student.simulate, large, hint=steps)


@check("simulate", points=0.25, after=simulate_swings)
def simulate_turns_over_the_top(student, rng):
    """a pendulum that turns round and round; theta goes on growing."""
    compare_motions(student.simulate, cases.over_the_top(rng), hint="Is alpha right at every angle?")


@check("simulate", points=0.25, after=simulate_swings)
def simulate_without_gravity(student, rng):
    """without gravity it turns uniformly."""
    compare_motions(student.simulate, cases.weightless(rng), hint="Is anything divided by gravity?")


@check("simulate", points=0.25, after=simulate_swings)
def simulate_keeps_the_energy(student, rng):
    """the energy stays what it was over many periods."""
    hint = "Tighten rtol and atol; a step of fixed length does not do for every duration."
    turns = cases.many_periods(rng)
    check_conserved(student.simulate, reference, turns, KEPT, coarsely=COARSELY, partial=LOSSES, hint=hint)


ASSIGNMENT = Assignment(
    returns={
        "linear_momentum_balance": group(ALPHA, number.described("the tension", "N", FORCE)),
        "angular_momentum_balance": group(
            ALPHA,
            number.described("the angular momentum", "kg m^2/s", MOMENTUM),
            number.described("the moment", "N m", MOMENT),
        ),
        "energy_balance": group(
            ALPHA,
            number.described("the kinetic energy", "J", MOMENT),
            number.described("the potential energy", "J", MOMENT),
        ),
        "power_balance": group(ALPHA, number.described("the power", "W", POWER)),
        "virtual_work": group(ALPHA, number.described("the generalized force", "N m", MOMENT)),
        "lagrangian": formula(*cases.SYMBOLS).described("the Lagrangian", "J", MOMENT),
        "lagrange_equation": formula("theta", "l", "g").described("alpha", "rad/s^2", RATE2),
        "action": number.described("the action", "J s", size_of_action),
        "small_angle_solution": rows(2, columns=MOTION),
        "period": number.described("the period", "s"),
        "simulate": rows(2, columns=MOTION, rates=RATES),
        "free_body_diagram": free_body_diagram(2),
    },
    forbidden={"*": ("tam570.lagrange", "tam570.lectures")},
    needs=("numpy", "sympy"),
)
