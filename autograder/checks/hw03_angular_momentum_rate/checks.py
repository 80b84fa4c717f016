"""Hidden checks of hw03."""

import numpy as np

from tam570_grader import Assignment, Case, array, check, check_domain, check_raises, compare_with, fail, group

from . import cases, reference, special

POINTWISE = 1e-8  # relative; a few rounding errors make 1e-15, a rate by differences of a Taylor series 1e-11
NEAR_MISS = 1e-4  # relative error up to which a rate is right in principle, for the choice of the hint

compare = compare_with(reference, tolerance=POINTWISE)


def sizes(state):
    """Return |r|, |v|, |a|, each the sum of both points, as far as a state has them."""
    half = len(state) // 2
    return [np.linalg.norm(state[i]) + np.linalg.norm(state[i + half]) for i in range(half)]


def moment_size(case, _=None):
    """Return the scale of a moment, N m."""
    if len(case.args) == 3:
        r_p, a_p, r_c = case.args
        return case.kwargs["mass"] * (np.linalg.norm(r_p) + np.linalg.norm(r_c)) * np.linalg.norm(a_p)
    r, v, a = sizes(case.args[1:])
    return case.kwargs["mass"] * (r * a + v**2)


QUOTIENT = "It is nearly right: is it a difference quotient? Differentiate the product on paper."


def by_difference(hint):
    """Return a hint: QUOTIENT for a rate that is nearly right, as a difference quotient is; else `hint`."""
    return lambda case, result, expected: (
        QUOTIENT if np.abs(result - expected).max() <= NEAR_MISS * moment_size(case) else hint
    )


LETTERS = "Raise ValueError for anything but the three letters."
check_letters = compare_with(reference, by=check_domain, tolerance=POINTWISE, hint=LETTERS)
FIXED = "C' stays where C is at this instant: what is its velocity?"
PRODUCT = by_difference("Differentiate the product: which vectors change with time?")


def left_over(case, result, expected):
    near = POINTWISE * moment_size(case)
    if np.abs(result).max() <= near:
        return "It vanishes; for a moving C the rate is not the moment."
    if np.abs(result + expected).max() <= near:
        return "It has the right size and the wrong sign; it is rate less moment."
    return "It is rate less moment: subtract them on paper; which terms are left?"


@check("moment", points=1)
def moment_is_about_C(student, rng):
    """of the total force on P, about C."""
    hint = "The lever arm runs from C to P, and the force on P is all of its m a."
    compare(student.moment, cases.moments(rng), hint=hint)


@check("angular_momentum", points=1)
def momentum_with_the_velocity_in_F(student, rng):
    """angular_momentum by definitions a and b: the lever arm from C, the velocity as F sees it."""
    hint = "From where does the lever arm run, and whose velocity is it, seen from where?"
    compare(student.angular_momentum, cases.momenta(rng, "ab"), hint=hint)


@check("angular_momentum", points=0.75)
def momentum_with_the_velocity_relative_to_C(student, rng):
    """angular_momentum by definition c: the velocity as one sees it who moves along with C."""
    compare(student.angular_momentum, cases.momenta(rng, "c"), hint="Whose velocity, seen from where?")


BOTH_MOMENTA = momentum_with_the_velocity_in_F, momentum_with_the_velocity_relative_to_C


@check("angular_momentum", points=0.25, after=BOTH_MOMENTA, refusals=True)
def momentum_refuses_other_definitions(student, rng):
    """angular_momentum raises ValueError for another definition."""
    check_letters(student.angular_momentum, cases.letters(rng, cases.momenta))


@check("rate", points=0.5)
def rate_about_a_fixed_point(student, rng):
    """rate by definition a: the derivative while C' stays where it is."""
    compare(student.rate, cases.rates(rng, "a"), hint=by_difference(FIXED))


@check("rate", points=1)
def rate_with_the_velocity_in_F(student, rng):
    """rate by definition b: the derivative of its angular momentum along any motion of P and C."""
    compare(student.rate, cases.rates(rng, "b"), hint=PRODUCT)


@check("rate", points=0.75)
def rate_with_the_velocity_relative_to_C(student, rng):
    """rate by definition c: the derivative of its angular momentum along any motion of P and C."""
    compare(student.rate, cases.rates(rng, "c"), hint=PRODUCT)


BOTH_RATES = rate_about_a_fixed_point, rate_with_the_velocity_in_F


@check("rate", points=0.25, after=BOTH_RATES, refusals=True)
def rate_refuses_other_definitions(student, rng):
    """rate raises ValueError for another definition."""
    check_letters(student.rate, cases.letters(rng, cases.rates))


@check("discrepancy", points=0.5)
def discrepancy_with_the_velocity_in_F(student, rng):
    """discrepancy by definition b: its rate less the moment."""
    compare(student.discrepancy, cases.rates(rng, "b"), hint=left_over)


@check("discrepancy", points=0.5)
def discrepancy_with_the_velocity_relative_to_C(student, rng):
    """discrepancy by definition c: its rate less the moment."""
    compare(student.discrepancy, cases.rates(rng, "c"), hint=left_over)


@check("discrepancy", points=0.25, after=discrepancy_with_the_velocity_in_F)
def no_discrepancy_about_a_fixed_point(student, rng):
    """discrepancy by definition a."""
    compare(student.discrepancy, cases.rates(rng, "a"), hint=FIXED)


@check("discrepancy", points=0.25, after=discrepancy_with_the_velocity_in_F, refusals=True)
def discrepancy_refuses_other_definitions(student, rng):
    """discrepancy raises ValueError for another definition."""
    check_letters(student.discrepancy, cases.letters(rng, cases.rates))


def judge_motion(special_motion, definition):
    """Fail for the first flaw of a special motion; if it has none in another order, the hint says so."""
    p, c = special_motion(definition)
    for message, hint in special.flaws(definition, p, c):
        fail(message, hint=special.order_hint(definition, p, c) or hint)


@check("special_motion", points=1.5)
def special_motion_of_b(student, rng):
    """special_motion of b: a motion in which C accelerates, for which definition b holds at every t, and c does not."""
    judge_motion(student.special_motion, "b")


@check("special_motion", points=1.25)
def special_motion_of_c(student, rng):
    """special_motion of c: a motion in which C accelerates, for which definition c holds at every t, and b does not."""
    judge_motion(student.special_motion, "c")


@check("special_motion", points=0.25, after=(special_motion_of_b, special_motion_of_c), refusals=True)
def special_motion_refuses_other_definitions(student, rng):
    """special_motion raises ValueError for another definition."""
    calls = [Case(name).labelled(f'the definition "{name}"') for name in ("d", "bc", "a", *cases.LETTERS_ALIKE)]
    check_raises(student.special_motion, calls, hint='Raise ValueError for anything but "b" and "c".')


ASSIGNMENT = Assignment(
    returns={
        "moment": array(3).described("the moment", "N m", moment_size),
        "angular_momentum": array(3).described(
            "the angular momentum", "kg m^2/s", lambda case, _: case.kwargs["mass"] * np.prod(sizes(case.args[1:]))
        ),
        "rate": array(3).described("the rate", "N m", moment_size),
        "discrepancy": array(3).described("the discrepancy", "N m", moment_size),
        "special_motion": group(array(None, 3), array(None, 3)),
    },
    forbidden={},
    needs=("numpy",),
)
