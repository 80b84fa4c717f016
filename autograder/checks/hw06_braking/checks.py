"""Hidden checks of hw06."""

import math

import numpy as np

from tam570_grader import Column, agree, agree_by_columns, check, expect_that, follow, law, refuse
from tam570_grader.writing.returns import array, number, rows

from . import cases, right
from .right import wheelbase

NEEDS = ("numpy",)
MANUAL = {"c": (2, "the definition of steering stability, with plots that answer the question by it")}

FORMULA = 1e-9  # of the largest term: roundings make 1e-15, solving for the side force 1e-13; wrong terms .1
GROWTH = 1e-6  # a student's central difference is good to 1e-9; wrong terms are off by .1
SMALL_YAW = 1e-6  # the same, and an integral by rtol 1e-9 in the place of the closed form
FOLLOWED = 1e-6  # solve_ivp at rtol = atol = 1e-9, whatever its method, stays below 8e-8 well before the stop
SLOW = 1e-3  # at 1e-6 m/s and more a guard against 0/0 (v + 1e-9) is still right, a deadband off by 1
STOPPED = 5e-5  # of the way that friction needs: from AT_REST to the stop it is the square, up to 1e-5
AT_REST = 100 * STOPPED  # of the first speed: a student may call it rest below 1e-3 m/s, and cars start from 0.4 m/s


def braking(case, _):
    return case.kwargs["mass"] * max(case.kwargs["friction"] * case.kwargs["gravity"], 0.1)


def pace(case, _=None):
    """The size of the velocities, m/s."""
    return cases.usual(case.kwargs) + cases.speed_of(case.args[1], case.kwargs)


def turning(case, _):
    """The size of yaw accelerations."""
    known = case.kwargs
    return right.ease_of_turning(case.args[-1], **known) * (pace(case) / wheelbase(known)) ** 2


def of_growth(case, _):
    known, (speed, locked) = case.kwargs, case.args
    rates = speed / wheelbase(known) + known["friction"] * known["gravity"] / speed
    return right.ease_of_turning(locked, **known) * rates


RATES = (
    Column("the velocity of G", "m/s", [0, 1], scale=pace),
    Column("the rate of heading", "rad/s", [2], scale=lambda case, _: pace(case) / wheelbase(case.kwargs)),
    Column("the rate of speed", "m/s^2", [3], scale=lambda case, _: pace(case) ** 2 / wheelbase(case.kwargs)),
    Column("the yaw acceleration", "rad/s^2", [4], scale=turning),
)


def way(case, _=None):
    """The way that friction needs."""
    return cases.speed_of(case.args[1], case.kwargs) ** 2 / max(case.kwargs["friction"] * case.kwargs["gravity"], 0.1)


def gone(case, _=None):
    """The way that a slow car goes."""
    t, drag = case.args[0], case.kwargs["friction"] * case.kwargs["gravity"]
    return way(case) if drag else (t[-1] - t[0]) * cases.speed_of(case.args[1], case.kwargs)


def columns(far, fast=1.0):
    """The columns of a motion: how far it goes, and how much more a speed may be off."""

    def turned(case, _):
        return min(far(case) / wheelbase(case.kwargs), 1.0)

    def speed(case, _):
        return fast * cases.speed_of(case.args[1], case.kwargs)

    return (
        Column("the place", "m", [0, 1], scale=far),
        Column("the heading", "rad", [2], turns=True, scale=turned),
        Column("the speed", "m/s", [3], scale=speed),
        Column("the yaw rate", "rad/s", [4], scale=lambda case, _: speed(case, _) / wheelbase(case.kwargs)),
    )


MOTION, SLOWLY = columns(lambda case, _=None: max(way(case), wheelbase(case.kwargs))), columns(gone)
TO_REST = columns(MOTION[0].scale, AT_REST / STOPPED)
RESULTS = {
    "axle_load": number.called("the load", "N", lambda case, _: case.kwargs["mass"] * (case.kwargs["gravity"] or 1.0)),
    "friction_force": array(2).called("the friction force", "N", braking),
    "state_derivative": array(5, columns=RATES),
    "simulate": rows(5, columns=MOTION),
    "kinetic_energy": number.called("the kinetic energy", "J"),
    "yaw_growth_rate": number.called("the growth rate", "1/s", of_growth),
    "critical_speed": array(infinite=True).called("the critical speed", "m/s"),
    "small_yaw_rate": number.called("the yaw rate", "rad/s"),
}


axle_load_balances_the_weight = law(
    "axle_load: what the locked axle carries of the weight of a car at rest.", points=0.75, part="a"
).agrees(
    right.axle_load, cases.loads, within=FORMULA, hint="Which axle carries more, the one near G or the one far from it?"
)


@check(points=1, part="a")
def friction_opposes_the_sliding(student, draw):
    """friction_force: forward and left, against the velocity of the axle that drags, in proportion to its load."""
    hint = "Which way does the locked axle move, seen from the car?"
    agree(student.friction_force, right, cases.turning(draw, "friction_force", 8), within=FORMULA, hint=hint)


AS_AT_REST = "friction is zero there, as at rest; at rest speed and yaw rate are both exactly zero"


def of_friction(case, found, expected):
    if not np.any(found) and np.any(expected):
        return AS_AT_REST
    return "Coulomb friction is along the velocity, at any speed: what is 0/0 at rest?"


@check(points=0.5, part="a", after=friction_opposes_the_sliding)
def friction_in_any_motion_and_at_rest(student, draw):
    """friction_force: in reverse, on the spot, straight, slow, without friction; zero at rest."""
    name, force = "friction_force", student.friction_force
    agree(force, right, cases.ways(draw, name) + cases.odd(draw, name), within=FORMULA, hint=of_friction)
    agree(force, right, cases.creeping(draw, name), within=SLOW, hint=of_friction)
    brakes(force, right.friction_force, cases.hardly_moving(draw, name))


def brakes(function, force, calls):
    """Along the right friction, however small: a guard against 0/0 leaves only a part of it there."""
    for case, found in function.each(calls):
        along = np.asarray(found[-2:]) @ np.asarray(force(*case.args, **case.kwargs)[-2:])
        expect_that(along > 0, "there is no friction", hint=AS_AT_REST)


def of_rates(case, found, expected):
    unbraked = right.state_derivative(*case.args, **{**case.kwargs, "friction": 0.0})
    if np.allclose(found, unbraked, rtol=1e-4, atol=0) and not np.allclose(expected, unbraked, rtol=1e-4, atol=0):
        return AS_AT_REST
    if np.allclose(found[:3], expected[:3]) and not np.allclose(found[3], expected[3]):
        return "In axes that turn, does the rate of speed have a term with the yaw rate squared?"
    if np.allclose(found[:4], expected[:4]):
        return "Do the moments about the free axle balance, speed times yaw rate included?"
    return "G slips sideways, for it is not on the free axle: do you turn (forward, left) by the heading?"


def judge_rates(student, calls, within=FORMULA):
    agree_by_columns(student.state_derivative, right, cases.timed(calls), within=within, hint=of_rates)


@check(points=1.25, part="a")
def equations_of_motion(student, draw):
    """state_derivative: the balances of momentum, and a free axle that does not slip sideways."""
    judge_rates(student, cases.turning(draw, "state_derivative", 10))


@check(points=0.5, part="a", after=equations_of_motion)
def equations_in_any_motion(student, draw):
    """state_derivative: in reverse, turning on the spot, straight, slow."""
    name = "state_derivative"
    judge_rates(student, cases.ways(draw, name, [kind for kind in cases.WAYS if "rest" not in kind]))
    judge_rates(student, [case for case in cases.odd(draw, name) if "heading" in case.kind])
    judge_rates(student, cases.creeping(draw, name), SLOW)
    brakes(student.state_derivative, right.state_derivative, cases.timed(cases.hardly_moving(draw, name)))


@check(points=0.5, part="a", after=equations_of_motion)
def equations_without_friction_and_at_rest(student, draw):
    """state_derivative: without friction, without gravity; all zero at rest."""
    judge_rates(student, cases.ways(draw, "state_derivative", ("a car at rest",)))
    judge_rates(student, [case for case in cases.odd(draw, "state_derivative") if "heading" not in case.kind])


@check(points=0.5, part="a")
def kinetic_energy_of_G_and_of_turning(student, draw):
    """kinetic_energy: of G, which moves to the side too, and of the turning about it."""
    calls = cases.ways(draw, "kinetic_energy") + cases.odd(draw, "kinetic_energy")
    agree(student.kinetic_energy, right, calls, within=FORMULA, hint="What is the velocity of G?")


def of_run(motion):
    """What to say of a motion that ends early, or goes straight on."""
    found, expected = motion.found, motion.expected
    if found[1:, 3].any() and not found[1:, 4].any() and expected[1:, 4].any():
        return "It goes straight on: a small yaw rate is not zero, and may grow."
    stands = expected[:, 3:].any(axis=1) & ~found[:, 3:].any(axis=1)
    if stands.any():
        return "Speed and yaw rate are zero there before it stops: does your event count time from t[0]?"
    return "Is your integrator's tolerance tight?"


simulate_brakes = law(
    "simulate: braking with either axle locked, row i at t[i], row 0 the given state.", points=1, part="a"
).follows(right.simulate, lambda draw: cases.runs(draw, 100), within=FOLLOWED, hint=of_run)
simulate_needs_no_dense_times = law(
    "simulate: the same motion when only a few times are asked for.", points=0.25, part="a", after=simulate_brakes
).follows(right.simulate, cases.few_times, within=FOLLOWED, hint=of_run)


@check(points=0.5, part="a", after=simulate_brakes)
def simulate_glides_without_friction(student, draw):
    """simulate: without friction or gravity it keeps its energy, however slow, ends with G ahead of the free axle."""
    follow(student.simulate, right, cases.gliding(draw), within=FOLLOWED, hint=of_run)
    follow(student.simulate, right, cases.gliding_slowly(draw), SLOWLY, within=SLOW, hint=of_run)


@check(points=0.75, part="a")
def growth_rate_is_the_slope(student, draw):
    """yaw_growth_rate: how fast the yaw acceleration rises with a small yaw rate, at low and high speed."""
    hint = "Linearise at yaw rate 0: is friction's sideways part in it?"
    agree(student.yaw_growth_rate, right, cases.at_speeds(draw), within=GROWTH, hint=hint)


@check(points=0.5, part="a")
def critical_speed_is_where_growth_begins(student, draw):
    """critical_speed: with the rear locked, that at which the growth rate is zero; with the front locked, math.inf."""
    for _, found in student.critical_speed.each(cases.criticals(draw, "rear")):
        expect_that(math.isfinite(found), "critical_speed is infinite", hint="Is it unstable at any speed at all?")
    hint = "Where is your growth rate zero?"
    agree(student.critical_speed, right, cases.criticals(draw, "rear"), within=FORMULA, hint=hint)
    for _, found in student.critical_speed.each(cases.criticals(draw, "front")):
        expect_that(found == math.inf, "critical_speed is not math.inf", hint="Can your growth rate be positive there?")


@check(points=0.75, part="d")
def small_yaw_rate_is_the_linear_solution(student, draw):
    """small_yaw_rate: the linear equation, solved exactly over the falling speed."""
    hint = "Divide the yaw acceleration by the rate of speed: can you integrate over the speed?"
    agree(student.small_yaw_rate, right, cases.slowing(draw), within=SMALL_YAW, hint=hint)


def judge_refusals(student, names, call, others=cases.OTHERS, after=""):
    """ValueError for another `locked`, from functions that take "front" and "rear"; call(name, locked) is one."""
    for name in names:
        function = getattr(student, name)
        for locked in cases.AXLES:
            case = call(name, locked)
            says = f"{name} raises ValueError for a {locked} axle"
            expect_that(not function.refuses(*case.args, **case.kwargs), says)
        bad = [call(name, locked).on(f"locked={locked!r}{after}") for locked in others]
        refuse(function, bad, accepts=(), within=FORMULA, hint='Only "front" and "rear" are axles.')


@check(points=0.25, part="a")
def mechanics_refuses_other_axles(student, draw):
    """axle_load, friction_force, state_derivative, kinetic_energy, simulate: ValueError for another `locked`."""
    agree(student.axle_load, right, cases.loads(draw)[:2], within=FORMULA)
    moves = ("friction_force", "state_derivative", "kinetic_energy", "simulate")
    judge_refusals(student, ("axle_load", *moves), cases.of_mechanics(draw, moving=True))
    judge_refusals(student, moves, cases.of_mechanics(draw, moving=False), ("both",), ", a car at rest")


@check(points=0.25, part="a")
def stability_refuses_other_axles(student, draw):
    """critical_speed, yaw_growth_rate, small_yaw_rate: ValueError for another `locked`."""
    call = cases.of_stability(draw)
    agree(student.critical_speed, right, cases.criticals(draw, "rear")[:1], within=FORMULA)
    judge_refusals(student, ("yaw_growth_rate", "critical_speed", "small_yaw_rate"), call)


# Last: a student whose integrator never gets past the stop shall lose nothing else by it.


def of_stop(motion):
    """What to say of the rows at the stop and after it."""
    rests = ~motion.expected[:, 3:].any(axis=1)
    found = motion.found[rests]
    if not rests.any():
        return "Slow is not at rest: it has a way to go before it stops."
    if not found.any():
        return "Place and heading are zero there; do they stay where it stops?"
    if len(found) > 1 and (found[:, 3] * motion.case.args[1][3] < 0).all():
        return "It goes back after the stop."
    return "Find the time at which it stops: does anything change from then on?"


@check(points=0.75, part="a", after=simulate_brakes)
def simulate_comes_to_rest_and_stays(student, draw):
    """simulate: a car that has come to rest stays where it is, in place and heading; one at rest does not start.

    A slow one is not at rest.
    """
    follow(student.simulate, right, cases.braking_slowly(draw), SLOWLY, within=SLOW, hint=of_run)
    follow(student.simulate, right, cases.stops(draw), TO_REST, within=STOPPED, hint=of_stop)
    follow(student.simulate, right, cases.at_rest(draw), within=FORMULA, hint=of_run)
