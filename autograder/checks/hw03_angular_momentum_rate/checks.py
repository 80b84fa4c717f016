"""Hidden checks of hw03."""

import numpy as np

from tam570_grader import Assignment, Case, array, check, check_raises, fail, group, law

from . import cases, reference, special

POINTWISE = 1e-8  # of its size; a few roundings make 1e-15, a rate by differences of a Taylor series 1e-11
NEAR_MISS = 1e-4  # off by less, a rate is right in principle, to choose the words


def sizes(state):
    """|r|, |v|, |a| of both points together, as far as they are given."""
    half = len(state) // 2
    return [np.linalg.norm(state[i]) + np.linalg.norm(state[i + half]) for i in range(half)]


def moment_size(case, _=None):
    """N m."""
    if len(case.args) == 3:
        r_p, a_p, r_c = case.args
        return case.kwargs["mass"] * (np.linalg.norm(r_p) + np.linalg.norm(r_c)) * np.linalg.norm(a_p)
    r, v, a = sizes(case.args[1:])
    return case.kwargs["mass"] * (r * a + v**2)


QUOTIENT = "It is nearly right: is it a difference quotient? Differentiate the product on paper."
ARM = "The lever arm runs from C to P, and the force on P is all of its m a."
SAME = "At one instant, can definitions a and b differ?"


def by_difference(hint):
    """The hint, but for a rate that is nearly right, as a difference quotient is."""
    return lambda case, found, expected: (
        QUOTIENT if np.abs(found - expected).max() <= NEAR_MISS * moment_size(case) else hint
    )


LETTERS = "Raise ValueError for anything but the three letters."
FIXED = "C' stays where C is at this instant: what is its velocity?"
PRODUCT = by_difference("Differentiate the product: which vectors change with time?")


def left_over(case, found, expected):
    near = POINTWISE * moment_size(case)
    if np.abs(found).max() <= near:
        return "It vanishes: is your rate the moment itself, and the motion of C forgotten?"
    if np.abs(found + expected).max() <= near:
        return "It has the right size and the wrong sign: is it rate less moment, and does rate pass?"
    return "It is rate less moment: do both pass, and what is left of it on paper?"


moment_is_about_C = law("moment: of the total force on P, about C.", points=1, part="a").agrees(
    reference.moment, cases.moments, tolerance=POINTWISE, hint=ARM
)
momentum_with_the_velocity_in_F = law(
    "angular_momentum by definitions a and b: the lever arm from C, the velocity as F sees it.", points=1, part="a"
).agrees(reference.angular_momentum, cases.momenta("ab"), tolerance=POINTWISE, hint=SAME)
momentum_with_the_velocity_relative_to_C = law(
    "angular_momentum by definition c: the velocity as one sees it who moves along with C.", points=0.75, part="a"
).agrees(reference.angular_momentum, cases.momenta("c"), tolerance=POINTWISE, hint="Whose velocity, seen from where?")
BOTH_MOMENTA = momentum_with_the_velocity_in_F, momentum_with_the_velocity_relative_to_C
momentum_refuses_other_definitions = law(
    "angular_momentum raises ValueError for another definition.", points=0.25, part="a", after=BOTH_MOMENTA
).refuses(reference.angular_momentum, cases.letters(cases.momenta("b")), tolerance=POINTWISE, hint=LETTERS)
rate_about_a_fixed_point = law(
    "rate by definition a: the derivative while C' stays where it is.", points=0.5, part="a"
).agrees(reference.rate, cases.rates("a"), tolerance=POINTWISE, hint=by_difference(FIXED))
rate_with_the_velocity_in_F = law(
    "rate by definition b: the derivative of its angular momentum along any motion of P and C.", points=1, part="a"
).agrees(reference.rate, cases.rates("b"), tolerance=POINTWISE, hint=PRODUCT)
rate_with_the_velocity_relative_to_C = law(
    "rate by definition c: the derivative of its angular momentum along any motion of P and C.", points=0.75, part="a"
).agrees(reference.rate, cases.rates("c"), tolerance=POINTWISE, hint=PRODUCT)
BOTH_RATES = rate_about_a_fixed_point, rate_with_the_velocity_in_F
rate_refuses_other_definitions = law(
    "rate raises ValueError for another definition.", points=0.25, part="a", after=BOTH_RATES
).refuses(reference.rate, cases.letters(cases.rates("b")), tolerance=POINTWISE, hint=LETTERS)
discrepancy_with_the_velocity_in_F = law(
    "discrepancy by definition b: its rate less the moment.", points=0.5, part="a"
).agrees(reference.discrepancy, cases.rates("b"), tolerance=POINTWISE, hint=left_over)
discrepancy_with_the_velocity_relative_to_C = law(
    "discrepancy by definition c: its rate less the moment.", points=0.5, part="a"
).agrees(reference.discrepancy, cases.rates("c"), tolerance=POINTWISE, hint=left_over)
no_discrepancy_about_a_fixed_point = discrepancy_with_the_velocity_in_F.then(
    "discrepancy by definition a.", points=0.25, part="a"
).agrees(reference.discrepancy, cases.rates("a"), tolerance=POINTWISE, hint=FIXED)
discrepancy_refuses_other_definitions = discrepancy_with_the_velocity_in_F.then(
    "discrepancy raises ValueError for another definition.", points=0.25, part="a"
).refuses(reference.discrepancy, cases.letters(cases.rates("b")), tolerance=POINTWISE, hint=LETTERS)


def motion_of(definition, other, points):
    """The check of one special motion: it must have no flaw; if it has none in another order, the student is told."""

    def judge(student, rng):
        p, c = student.special_motion(definition)
        for message, hint in special.flaws(definition, p, c):
            fail(message, hint=special.order_hint(definition, p, c) or hint)

    holds = f"for which definition {definition} holds at every t, and {other} does not."
    judge.__doc__ = f"special_motion of {definition}: a motion in which C accelerates, {holds}"
    return check(points=points, part="a")(judge)


special_motion_of_b, special_motion_of_c = motion_of("b", "c", 1.5), motion_of("c", "b", 1.25)


@check(points=0.25, part="a", after=(special_motion_of_b, special_motion_of_c))
def special_motion_refuses_other_definitions(student, rng):
    """special_motion raises ValueError for another definition."""
    calls = [Case(name).labelled(f'the definition "{name}"') for name in ("d", "bc", "", "a", *cases.LETTERS_ALIKE)]
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
