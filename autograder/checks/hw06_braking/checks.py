"""Hidden checks of hw06."""

from functools import partial

import numpy as np

from tam570_grader import Assignment, Failed, check, expect_that
from tam570_grader.checks.compare import Batch, Column, check_raises, compare_with, largest, own_result
from tam570_grader.checks.diagrams import compare_diagrams
from tam570_grader.checks.returns import array, free_body_diagram, number, rows
from tam570_grader.checks.trajectory import OwnRates, compare_trajectory

from . import cases, reference
from .reference import wheelbase

FORMULA = 1e-9  # of the largest term: rounding errors are 1e-15, solving for the side force 1e-13; wrong terms .1
GROWTH = 1e-6  # central differences have errors of 1e-9, as their integral at rtol 1e-9; wrong terms .1
FOLLOWED = 1e-6  # solve_ivp at rtol = atol = 1e-9, with any method, has errors below 8e-8 well before the stop
SLOW = 1e-3  # at 1e-6 m/s and more a guard against 0/0 (v + 1e-9) is still right; the error of a deadband is 1
STOPPED = 5e-5  # of the braking distance; from AT_REST to the stop the share is the square, up to 1e-5
SOME = 0.999  # a guard against 0/0 may remove any part of the friction at 1e-8 m/s, but not all of it
SLOWEST = 0.05  # of the turning: students stop cars below 1e-2 of their speed at most
AT_REST = 100 * STOPPED  # of the first speed: students may treat 1e-3 m/s as rest, and cars start from 0.3 m/s

compare = compare_with(reference, tolerance=FORMULA)


def pace(case, _=None):
    """Return the scale of the velocities, m/s."""
    return cases.usual(case.kwargs) + cases.speed_of(case)


def turning(case, _):
    """Return the scale of yaw accelerations, rad/s^2."""
    car = case.kwargs
    return reference.ease_of_turning(case.args[-1], **car) * (pace(case) / wheelbase(car)) ** 2


def of_growth(case, _):
    car, (speed, locked) = case.kwargs, case.args
    rates = speed / wheelbase(car) + car["friction"] * car["gravity"] / speed
    return reference.ease_of_turning(locked, **car) * rates


RATES = (
    Column("the velocity of G", "m/s", [0, 1], scale=pace),
    Column("the rate of heading", "rad/s", [2], scale=lambda case, _: pace(case) / wheelbase(case.kwargs)),
    Column("the rate of speed", "m/s^2", [3], scale=lambda case, _: pace(case) ** 2 / wheelbase(case.kwargs)),
    Column("the yaw acceleration", "rad/s^2", [4], scale=turning),
)


def way(case, _=None):
    """Return the distance in which friction stops the car, m."""
    return cases.speed_of(case) ** 2 / cases.drag(case.kwargs)


def gone(case, _=None):
    """Return the distance that a slow car moves, m."""
    t, drag = case.args[0], case.kwargs["friction"] * case.kwargs["gravity"]
    return way(case) if drag else (t[-1] - t[0]) * cases.speed_of(case)


def columns(far, off=1.0):
    """Return the columns of a motion, with the scale of its distance and a factor on the scale of its speeds."""
    return (
        Column("the place", "m", [0, 1], scale=far),
        Column("the heading", "rad", [2], True, lambda case, _: min(far(case) / wheelbase(case.kwargs), 1.0)),
        Column("the speed", "m/s", [3], scale=lambda case, _: off * cases.speed_of(case)),
        Column("the yaw rate", "rad/s", [4], scale=lambda case, _: off * cases.speed_of(case) / wheelbase(case.kwargs)),
    )


MOTION, SLOWLY = columns(lambda case, _=None: max(way(case), wheelbase(case.kwargs))), columns(gone)
TO_REST = columns(MOTION[0].scale, AT_REST / STOPPED)


@check("free_body_diagram", points=0.5)
def forces_on_the_car(student, rng):
    """every force on the car, seen from above, where it acts and along what."""

    def own_body(case):
        along, aside = own_result(student.friction_force, reference, case)
        return reference.free_body_diagram(*case.args, **{**case.kwargs, "drag": complex(along, aside) or None})

    calls = cases.all_states(rng)
    compare_diagrams(student.free_body_diagram, reference, calls, (student.friction_force, own_body))
    judge_refusals(student, [("free_body_diagram", calls[0])])


# Where to look
AS_AT_REST = "Your friction is zero although the car moves: it rests only where speed and yaw rate are both exactly 0"


def where_zero(case, result, expected):
    return "Can your growth rate be positive there?" if case.args[-1] == "front" else "Where is your growth rate zero?"


ARM = (
    "Friction's term has your locked axle's distance from G; use the wheelbase, in the axle's sideways velocity and in "
    "its arm about the free axle."
)


def of_rate(case, rate, expected):
    """Return which of the two terms of a growth rate is missing."""
    gliding = reference.yaw_growth_rate(*case.args, **{**case.kwargs, "friction": 0.0})
    if abs(rate - gliding) <= GROWTH * of_growth(case, None):
        return "The term of friction is missing: its sideways part grows with the yaw rate."
    if abs(rate - expected + gliding) <= GROWTH * of_growth(case, None):
        return "The term of speed times yaw rate is missing."
    share = case.kwargs[case.args[-1]] / wheelbase(case.kwargs)
    if np.isclose((rate - gliding) / (expected - gliding), (share, share**2)).any():
        return ARM
    return "It has two terms: of speed times yaw rate, and of friction's sideways part."


def of_friction(case, result, expected):
    if not np.any(result) and np.any(expected):
        return AS_AT_REST
    if not np.any(expected):
        return "A car at rest has no friction: 0/0 is not 0."
    if np.allclose(np.multiply(result, np.linalg.norm(expected)), np.multiply(expected, np.linalg.norm(result))):
        return "Its direction is right, its size is not: it is as large at any speed."
    return "Which way does the locked axle move, seen from the car?"


def of_rates(case, result, expected):
    unbraked = reference.state_derivative(*case.args, **{**case.kwargs, "friction": 0.0})
    if np.allclose(result, unbraked, rtol=1e-4, atol=0) and not np.allclose(expected, unbraked, rtol=1e-4, atol=0):
        return AS_AT_REST
    if cases.speed_of(case) <= 2e-3:  # m/s
        return "Friction is as large at any speed, however low: is yours smoothed there?"
    if np.allclose(result[:3], expected[:3]) and not np.allclose(result[3], expected[3]):
        without = expected[3] - unbraked[3] * np.array([1, 2])  # the term is missing, or has the other sign
        turning = "In axes that turn, does the rate of speed have a term with the yaw rate squared?"
        return turning if np.isclose(result[3], without, rtol=1e-6, atol=0).any() else ""
    if np.allclose(result[:4], expected[:4]):
        return "Do the moments about the free axle balance, speed times yaw rate included?"
    return "Turn (forward, left) by the heading; G slips sideways, for no axle is there."


STILL_TURNS = "where its speed is nearly zero, but it still turns: it rests only where both are zero."


def stops_by_speed(case, expected, runs):
    """Return whether the speed passes zero, or nearly, around the last row that moves, but the yaw rate does not."""
    last = np.flatnonzero(runs).max()
    speeds, turning = expected[last : last + 2, 3], np.abs(expected[last : last + 2, 4]) * wheelbase(case.kwargs)
    slow = np.abs(speeds).min() <= SLOWEST * turning.min() or speeds[0] * speeds[-1] < 0
    return slow and turning.min() > SLOW * cases.speed_of(case)


def of_run(motion):
    """Return a hint for a motion that ends early, goes straight on, or does not stay where it stops."""
    result, expected = motion.actual, motion.expected
    rests = ~expected[:, 3:].any(axis=1)
    after = result[rests]
    if not result[~rests, 3:].any(axis=1).all():
        runs = result[:, 3:].any(axis=1)
        if motion.errors[runs].max(initial=0.0) <= SLOW:
            where = f"Until then it is right; you stop the car at t = {motion.t[runs][-1]:.3g} s, "
            return where + (STILL_TURNS if stops_by_speed(motion.case, expected, runs) else "too early.")
        return "You stop the car too early, and before that the motion is wrong."
    if not result[1:, 4].any() and expected[1:, 4].any():
        return "It goes straight on: a small yaw rate is not zero, and may grow."
    if not rests.any():
        return ""
    if not after.any():
        return "Place and heading are zero there; do they stay where it stops?"
    if len(after) > 1 and (after[:, 3] * motion.case.args[1][3] < 0).any():
        return "It goes back after the stop."
    return "Find the time at which it stops: does anything change from then on?"


compare_motions = compare_with(reference, by=compare_trajectory, hint=of_run)
compare_rates = compare_with(reference, tolerance=FORMULA, hint=of_rates)
HARDLY = {"tolerance": SOME, "near_miss_credit": False}
EACH_BY_ITSELF = [Column(column.quantity, column.unit, column.where) for column in RATES[2:]]  # each has its own scale


@check("axle_load", points=0.75)
def axle_load_balances_the_weight(student, rng):
    """what the locked axle carries at rest."""
    compare(student.axle_load, cases.parked(rng), hint="Which axle carries more, the one near G or the other?")


@check("friction_force", points=1)
def friction_opposes_the_sliding(student, rng):
    """against the velocity of the axle that drags, in proportion to its load."""
    compare(student.friction_force, cases.turning(rng), hint=of_friction)


@check("friction_force", points=0.5, after=friction_opposes_the_sliding)
def friction_in_any_motion_and_at_rest(student, rng):
    """any motion, however slow; zero at rest."""
    compare(student.friction_force, cases.all_states(rng), hint=of_friction)
    compare(student.friction_force, cases.slow(rng), tolerance=SLOW, hint=of_friction)
    compare(student.friction_force, cases.hardly_moving(rng), hint=of_friction, scale=largest, **HARDLY)


@check("state_derivative", points=1.25)
def equations_of_motion(student, rng):
    """the balances of momentum; the free axle does not slip sideways."""
    compare_rates(student.state_derivative, cases.timed(rng, cases.turning))


@check("state_derivative", points=0.5, after=equations_of_motion)
def equations_in_any_motion(student, rng):
    """in reverse, on the spot, straight, slow."""
    compare_rates(student.state_derivative, cases.timed(rng, cases.moving_on, cases.headings))
    compare_rates(student.state_derivative, cases.timed(rng, cases.slow), tolerance=SLOW)
    compare_rates(student.state_derivative, cases.timed(rng, cases.hardly_moving), columns=EACH_BY_ITSELF, **HARDLY)


@check("state_derivative", points=0.5, after=equations_of_motion)
def equations_without_friction_and_at_rest(student, rng):
    """without friction, without gravity; all zero at rest."""
    compare_rates(student.state_derivative, cases.timed(rng, cases.resting, cases.odd_cars))


@check("kinetic_energy", points=0.5)
def kinetic_energy_of_G_and_of_turning(student, rng):
    """of G, and of turning about it."""
    hint = "What is the velocity of G?"
    compare(student.kinetic_energy, [*cases.any_way(rng), *cases.odd_cars(rng)], hint=hint)


@check("simulate", points=0.75)
def simulate_brakes(student, rng):
    """braking with either axle locked, row i at t[i], row 0 the given state."""
    compare_motions(student.simulate, cases.braking(rng), tolerance=FOLLOWED)


@check("simulate", points=0.25, after=simulate_brakes)
def simulate_needs_no_dense_times(student, rng):
    """the same motion when only a few times are asked for."""
    compare_motions(student.simulate, cases.few_times(rng), tolerance=FOLLOWED)


@check("simulate", points=0.25, after=simulate_brakes)
def simulate_glides_without_friction(student, rng):
    """without friction it glides, however slow."""
    compare_motions(student.simulate, cases.gliding_slowly(rng), columns=SLOWLY, tolerance=SLOW)


@check("yaw_growth_rate", points=0.75)
def growth_rate_is_the_slope(student, rng):
    """d(yaw acceleration)/d(yaw rate)."""
    compare(student.yaw_growth_rate, cases.at_speeds(rng), tolerance=GROWTH, hint=of_rate)


@check("critical_speed", points=0.5)
def critical_speed_is_where_growth_begins(student, rng):
    """that at which the growth rate is zero; math.inf where it never is."""
    compare(student.critical_speed, cases.parked(rng), hint=where_zero)


@check("small_yaw_rate", points=0.75, part="d")
def small_yaw_rate_is_the_linear_solution(student, rng):
    """exact by linear theory."""
    hint = "What is d(yaw rate)/d(speed)? Integrate over the speed."
    compare(student.small_yaw_rate, cases.slowing(rng), tolerance=GROWTH, hint=hint)


def judge_refusals(student, calls):
    """Fail unless functions that take "front" and "rear" raise ValueError for another `locked`."""
    for name, call in calls:
        function, batch = getattr(student, name), Batch.of(getattr(reference, name), [call])
        allowed = batch.cases[0]
        bad = batch.remembered(cases.OTHERS, partial(with_other_axles, *batch.cases))
        function = function.ahead([allowed, *bad])
        expect_that(not is_refused(function, allowed), f"{name} raises ValueError for a {allowed.args[-1]} axle")
        check_raises(function, bad, hint='Only "front" and "rear" are axles.')


def is_refused(function, case):
    """Return whether a function raises ValueError; its own checks judge other exceptions."""
    try:
        return any(refused for _, refused in function.refusals([case]))
    except Failed:
        return False


def with_other_axles(case):
    """Return the case with each value of `locked` that is no axle."""
    others = [(locked, case.replace(*case.args[:-1], locked)) for locked in cases.OTHERS]
    return [other.labelled(f"locked={locked!r}, {case.label}") for locked, other in others]


@check("axle_load", points=0.25)
def mechanics_refuses_other_axles(student, rng):
    """axle_load, friction_force, state_derivative, kinetic_energy, simulate: ValueError for another `locked`."""
    compare(student.axle_load, cases.parked(rng)[:2])
    judge_refusals(student, cases.of_mechanics(rng))


@check("critical_speed", points=0.25)
def stability_refuses_other_axles(student, rng):
    """critical_speed, yaw_growth_rate, small_yaw_rate: ValueError for another `locked`."""
    compare(student.critical_speed, cases.parked(rng)[1:2])
    judge_refusals(student, cases.of_stability(rng))


# This check is last, so that a student whose integrator never gets past the stop loses nothing else.


@check("simulate", points=0.75, after=simulate_brakes)
def simulate_comes_to_rest_and_stays(student, rng):
    """it stops, and stays; a car at rest does not start."""
    compare_motions(student.simulate, cases.stops(rng), columns=TO_REST, tolerance=STOPPED)
    compare_motions(student.simulate, cases.at_rest(rng), tolerance=FORMULA)


ASSIGNMENT = Assignment(
    returns={
        "axle_load": number.described("the load", "N"),
        "friction_force": array(2).described(
            "the force", "N", lambda case, _: case.kwargs["mass"] * cases.drag(case.kwargs)
        ),
        "state_derivative": array(5, columns=RATES),
        "simulate": rows(5, columns=MOTION, rates=OwnRates("state_derivative", reference)),
        "kinetic_energy": number.described("the kinetic energy", "J"),
        "yaw_growth_rate": number.described("the growth rate", "1/s", of_growth),
        "critical_speed": array(infinite=True).described("the critical speed", "m/s"),
        "small_yaw_rate": number.described("the yaw rate", "rad/s"),
        "free_body_diagram": free_body_diagram(2),
    },
    forbidden={},
    needs=("numpy",),
    states=(3, 5),
)
