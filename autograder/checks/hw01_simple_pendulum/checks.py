"""Hidden checks of hw01."""

import math

import numpy as np

from tam570_grader import Column, Invariant, agree, agree_by_columns, check, expect, follow, law, stays
from tam570_grader.writing.formulas import from_own_lagrangian
from tam570_grader.writing.returns import formula, group, number, rows

from . import cases, right

NEEDS = ("numpy", "sympy")
OFF_LIMITS = {"*": ("tam570.lagrange", "tam570.lectures")}

FORMULA = 1e-8  # a few roundings make 1e-15, a derivative by central differences 1e-10
TRAJECTORY = 2e-5  # LSODA at rtol 1e-9, atol 1e-9 is off by 1.4e-6 after three periods, RK45 and DOP853 by less
FAR = 1e-4  # the same solvers are off by 6e-6 after sixteen periods, a hundred Runge-Kutta steps for them by 0.6
ENERGY = 1e-5  # the same solvers lose 3e-7 of it in thirty periods
COARSELY = 0.1  # rad after thirty periods; rows from anywhere on the motion are off by one or two
PERIOD = 1e-6  # a quadrature with a singular end, or an event of a simulation, is good to 1e-8
NEXT_TO_TOP = 1e-5  # there the same simulation magnifies its errors tenfold
# at 1e-5 rad, and that far from the top, the same simulation is good to 7e-5; a difference of cosines has no digit left
AT_THE_ENDS = 1e-3
SMALL = 1e-3  # of a variation; its square is below VARIATION
VARIATION = 1e-4  # (2 pi 1.5/2000)^2/3 = 7e-6 by any quadrature of second order
ACTION = 1e-5  # (4/4000)^2/3 = 3e-7 by any quadrature of second order; one of first order is off by 2e-4


def power_of_rate(n, mass, length):
    """The scale m^mass l^length (omega + sqrt(g/l))^n of a case, or of values for symbols."""

    def scale(case, _=None):
        known = {**dict(zip(("theta", "omega"), case.args, strict=False)), **case.kwargs}
        value = {name[0]: known[name] for name in known if name not in ("theta", "omega")}
        rate = abs(known.get("omega", 0.0)) + math.sqrt(value["g"] / value["l"])
        return value.get("m", 1.0) ** mass * value["l"] ** length * rate**n

    return scale


RATE2, FORCE = power_of_rate(2, 0, 0), power_of_rate(2, 1, 1)
MOMENTUM, MOMENT, POWER = power_of_rate(1, 1, 2), power_of_rate(2, 1, 2), power_of_rate(3, 1, 2)


def action_of_weight(case):
    """m g l times the duration."""
    path, step = case.args
    return math.prod(case.kwargs.values()) * step * (len(path) - 1)


def size_of_action(case, _):
    """The integral of T + V, whose sign of V is that of an inverted gravity."""
    return abs(right.action(*case.args, **{**case.kwargs, "gravity": -case.kwargs["gravity"]}))


def of_small_motions(case, _):
    return math.sqrt(case.kwargs["gravity"] / case.kwargs["length"]) or 1.0


def fastest(case, _):
    """The angular velocity at the start, or that of small motions."""
    return max(abs(case.args[2]), math.sqrt(case.kwargs["gravity"] / case.kwargs["length"]))


THETA = Column("theta", "rad", [0], turns=True, scale=lambda *_: 1.0)
SMALL_MOTION = THETA, Column("omega", "rad/s", [1], scale=of_small_motions)
MOTION = THETA, Column("omega", "rad/s", [1], scale=fastest)
KEPT = Invariant("the energy", "of itself", right.energy_of_rows, right.energy_at_the_start, ENERGY)
ALPHA = number.called("alpha", "rad/s^2", RATE2)
RESULTS = {
    "linear_momentum_balance": group(ALPHA, number.called("the tension", "N", FORCE)),
    "angular_momentum_balance": group(
        ALPHA, number.called("the angular momentum", "kg m^2/s", MOMENTUM), number.called("the moment", "N m", MOMENT)
    ),
    "energy_balance": group(
        ALPHA, number.called("the kinetic energy", "J", MOMENT), number.called("the potential energy", "J", MOMENT)
    ),
    "power_balance": group(ALPHA, number.called("the power", "W", POWER)),
    "virtual_work": group(ALPHA, number.called("the generalized force", "N m", MOMENT)),
    "lagrangian": formula("theta", "omega", "m", "l", "g").called("the Lagrangian", "J", MOMENT),
    "lagrange_equation": formula("theta", "l", "g").called("alpha", "rad/s^2", RATE2),
    "action": number.called("the action", "J s", size_of_action),
    "small_angle_solution": rows(2, columns=SMALL_MOTION),
    "period": number.called("the period", "s"),
    "simulate": rows(2, columns=MOTION),
}


@check(points=0.5, part="a")
def newton_gives_the_acceleration(student, draw):
    """linear_momentum_balance: alpha, by F = m a along the circle."""
    hint = "Draw the forces, and the component of each along the circle."
    agree(student.linear_momentum_balance, right, cases.all_states(draw), within=FORMULA, only=0, hint=hint)


@check(points=0.5, part="a")
def newton_gives_the_tension(student, draw):
    """linear_momentum_balance: the tension, by F = m a along the rod."""
    hint = "Which way along the rod does the acceleration point when omega is not zero?"
    agree(student.linear_momentum_balance, right, cases.all_states(draw), within=FORMULA, only=1, hint=hint)


@check(points=0.5, part="a")
def moments_give_the_acceleration(student, draw):
    """angular_momentum_balance: alpha, by M = dH/dt about the hinge."""
    hint = "Which way does the weight turn a pendulum that is out to the right?"
    agree(student.angular_momentum_balance, right, cases.all_states(draw), within=FORMULA, only=0, hint=hint)


@check(points=0.5, part="a")
def momentum_and_moment_are_about_the_hinge(student, draw):
    """angular_momentum_balance: r x m v and the moment of the weight, about the hinge."""
    hint = "How far from the hinge do momentum and weight act?"
    agree(student.angular_momentum_balance, right, cases.all_states(draw), within=FORMULA, only=(1, 2), hint=hint)


energies_are_right = law(
    "energy_balance: kinetic energy, and potential energy that is zero at the lowest point.", points=0.5, part="a"
).agrees(
    right.energy_balance, cases.states, within=FORMULA, only=(1, 2), hint="How high is the mass above its lowest point?"
)
energy_gives_the_acceleration = law(
    "energy_balance: alpha, from the constancy of the energy.", points=0.25, part="a"
).agrees(right.energy_balance, cases.states, within=FORMULA, only=0, hint="The terms of dE/dt have a factor in common.")
CANCELLED = "Cancel the factor omega; do not divide by it."
energy_gives_the_acceleration_at_rest = law(
    "energy_balance: alpha where omega is zero, too.", points=0.25, part="a", after=energy_gives_the_acceleration
).agrees(right.energy_balance, cases.at_rest, within=FORMULA, only=(0, 1), hint=CANCELLED)
power_gives_the_acceleration = law(
    "power_balance: the power of gravity, and alpha from it.", points=0.25, part="a"
).agrees(right.power_balance, cases.states, within=FORMULA, hint="Power is F . v: when does gravity speed the mass up?")
power_gives_the_acceleration_at_rest = law(
    "power_balance: alpha where omega is zero, too.", points=0.25, part="a", after=power_gives_the_acceleration
).agrees(right.power_balance, cases.at_rest, within=FORMULA, hint=CANCELLED)
virtual_work_gives_the_acceleration = law(
    "virtual_work: the generalized force of gravity, and alpha from it.", points=0.5, part="a"
).agrees(right.virtual_work, cases.all_states, within=FORMULA, hint="dr is l dtheta, across the rod.")


@check(points=0.75, part="a")
def lagrangian_is_kinetic_less_potential(student, draw):
    """lagrangian: T - V in theta, omega, m, l, g, with V zero at the lowest point."""
    calls = cases.symbols(cases.all_states(draw), *cases.NAMES)
    hint = "Put numbers in: at rest at the lowest point it is zero, at rest elsewhere negative."
    agree(student.lagrangian, right, calls, within=FORMULA, hint=hint)


@check(points=0.75, part="a")
def lagrange_gives_the_acceleration(student, draw):
    """lagrange_equation: alpha in theta, l, g alone."""
    states = cases.states(draw)
    equation, random = student.lagrange_equation, cases.symbols(states[:5], *cases.NAMES)

    def hint(*_):
        own = from_own_lagrangian(equation, student.lagrangian, random, "theta", "omega")
        return own or "It is the alpha of the other balances."

    calls = cases.symbols(states + cases.at_rest(draw), "theta", "l", "g")
    agree(equation, right, calls, within=FORMULA, hint=hint)


@check(points=0.5, part="a")
def action_is_stationary_on_motions(student, draw):
    """action: its first variation vanishes on true motions, and on other paths it does not."""
    paths = cases.varied_paths(draw, SMALL)
    hint = "Is it the integral of T - V, by a quadrature of second order that counts both ends as it must?"
    known = {"of": "the first variation", "unit": "J s/rad", "hint": hint, "gradual": False}
    found = student.action.each([case for both, _ in paths for case in both])
    for _, expected in paths:
        (case, high), (_, low) = next(found), next(found)
        expect((high - low) / (2 * SMALL), expected, within=VARIATION * action_of_weight(case), **known)


@check(points=0.5, part="a", after=action_is_stationary_on_motions)
def action_is_the_integral(student, draw):
    """action: the integral of T - V itself, to second order in the step."""
    hint = "Halve the step: the error must fall to a quarter."
    agree(student.action, right, cases.paths(draw), within=ACTION, hint=hint)


def of_small_angles(otherwise):
    return lambda case, *_: "Is anything kept between calls?" if "one before" in case.kind else otherwise


@check(points=0.5, part="a")
def small_angle_solution_is_harmonic(student, draw):
    """small_angle_solution: theta and omega of theta'' + (g/l) theta = 0, from the given state at t = 0."""
    hint = of_small_angles("Put t = 0 in: is the state the given one? Differentiate theta: is it omega?")
    agree_by_columns(student.small_angle_solution, right, cases.small_angles(draw), within=TRAJECTORY, hint=hint)


@check(points=0.25, part="a", after=small_angle_solution_is_harmonic)
def small_angle_solution_without_gravity(student, draw):
    """small_angle_solution: without gravity the pendulum turns uniformly."""
    calls, hint = cases.small_angles_without_gravity(draw), "What becomes of sin(k t)/k as k goes to zero?"
    agree_by_columns(student.small_angle_solution, right, calls, within=TRAJECTORY, hint=hint)


@check(points=0.75, part="a")
def period_is_exact(student, draw):
    """period: exact at large amplitudes."""
    amplitudes = [*draw.uniform(0.5, 2, 8), math.pi / 2, math.pi / 2, 1.0]
    hint = "The energy gives omega at every theta, and dt = dtheta/omega."
    agree(student.period, right, cases.periods(draw, amplitudes, "between 0.5 and 2 rad"), within=PERIOD, hint=hint)


COSINES = "Do you subtract nearly equal cosines? cos a - cos b is a product of sines."
LONGER = "A series in the amplitude, or a quadrature of fixed order, does not reach this far."
TOO_SMALL = "No amplitude is small enough for the period of small angles."
EQUAL = "Do you subtract nearly equal numbers?"


@check(points=0.25, part="a", after=period_is_exact)
def period_grows_towards_the_top(student, draw):
    """period: exact for small and tiny amplitudes, and on to pi, where it grows without bound."""
    # below .0099 the period of small angles, 1 - A^2/16 of the right one, is still off by 3e-6
    for amplitudes, within, kind, hint in (
        (draw.uniform(0.007, 0.0099, 1), PERIOD, "between 0.007 and 0.01 rad", TOO_SMALL),
        (10 ** draw.uniform(-2, -1, 2), PERIOD, "between 0.01 and 0.1 rad", COSINES),
        (np.pi - 10 ** draw.uniform(-3, -1, 4), NEXT_TO_TOP, "next to pi", LONGER),
        (cases.one_in_each(draw, cases.SMALLER), PERIOD, "between 0.1 and 0.5 rad", LONGER),
        (cases.one_in_each(draw, cases.LARGER), PERIOD, "between 2 and 3 rad", LONGER),
        (10 ** draw.uniform(-5, -4, 3), AT_THE_ENDS, "of less than 1e-4 rad", COSINES),
        (np.pi - 10 ** draw.uniform(-5, -4, 2), AT_THE_ENDS, "very close to pi", EQUAL),
    ):
        agree(student.period, right, cases.periods(draw, amplitudes, kind), within=within, hint=hint)


@check(points=0.75, part="a")
def simulate_swings(student, draw):
    """simulate: large swings, row i at t[i], row 0 the given state."""
    calls = [cases.motion(draw, cases.swing, 15, 1000, "a large swing, t[0] not 0")]
    hint = "Is omega the rate of theta, and alpha that of the balances?"
    follow(student.simulate, right, calls, within=TRAJECTORY, hint=hint, keeps=KEPT)


@check(points=0.25, part="a", after=simulate_swings)
def simulate_needs_no_dense_times(student, draw):
    """simulate: the same motion when only a few times are asked for, however far apart, whatever was asked before."""
    far = [cases.motion(draw, cases.swing, 100, 2, "two times, many periods apart")]
    steps = "A fixed number of steps, or a fixed step, does not do for every pendulum."
    linear = "No swing is so small that sin theta is theta: the difference adds up."
    follow(student.simulate, right, cases.few_times(draw), within=TRAJECTORY, hint=steps)
    follow(student.simulate, right, far, within=FAR, hint=steps)
    small = [cases.small_swing(draw)]
    follow(student.simulate, right, small, within=TRAJECTORY, hint=linear, loose=False)


@check(points=0.25, part="a", after=simulate_swings)
def simulate_turns_over_the_top(student, draw):
    """simulate: a pendulum that turns round and round; theta goes on growing."""
    hint = "Is alpha right at every angle?"
    follow(student.simulate, right, cases.over_the_top(draw), within=TRAJECTORY, hint=hint)


simulate_without_gravity = law(
    "simulate: without gravity it turns uniformly.", points=0.25, part="a", after=simulate_swings
).follows(right.simulate, cases.weightless, within=TRAJECTORY, hint="Is anything divided by gravity?")


@check(points=0.25, part="a", after=simulate_swings)
def simulate_keeps_the_energy(student, draw):
    """simulate: the energy stays what it was over many periods."""
    calls = [cases.motion(draw, cases.swing, 180, 300, "many periods")]
    share = {1e-4: 0.6, 1e-2: 0.3}
    hint = "A step of fixed length, or a fixed number of them, does not do for every duration."
    stays(student.simulate, right, calls, KEPT, coarsely=COARSELY, partial=share, hint=hint)
