"""Hidden checks of hw03."""

import numpy as np

from tam570_grader import agree, array, check, fail, given, group, refuse

from . import cases, right, special

RESULTS = {
    "moment": array(3),
    "angular_momentum": array(3),
    "rate": array(3),
    "discrepancy": array(3),
    "special_motion": group(array(None, 3), array(None, 3)),
}
NEEDS = ("numpy",)
MANUAL = {"a": (2, "in words: which definitions have rate = moment in general, which in special cases, and why")}

POINTWISE = 1e-8  # of its size; a few roundings make 1e-15, a rate by differences of a Taylor series 1e-11
NEARLY = 1e-4  # off by less, a rate is right in principle, to choose the words


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


def momentum_size(case, _):
    """kg m^2/s."""
    return case.kwargs["mass"] * np.prod(sizes(case.args[1:]))


MOMENTUM = {"of": "the angular momentum", "unit": "kg m^2/s", "scale": momentum_size}
RATE = {"of": "the rate", "unit": "N m", "scale": moment_size}
DISCREPANCY = {"of": "the discrepancy", "unit": "N m", "scale": moment_size}


@check(points=1, part="a")
def moment_is_about_C(student, draw):
    """moment: of the total force on P, about C."""
    hint = "The lever arm runs from C to P, and the force on P is all of its m a."
    known = {"of": "the moment", "unit": "N m", "scale": moment_size, "hint": hint}
    agree(student.moment, right.moment, cases.moments(draw), within=POINTWISE, **known)


@check(points=1, part="a")
def momentum_with_the_velocity_in_F(student, draw):
    """angular_momentum by definitions a and b: the lever arm from C, the velocity as F sees it."""
    calls, hint = cases.momenta(draw, "ab"), "At one instant, can definitions a and b differ?"
    agree(student.angular_momentum, right.angular_momentum, calls, within=POINTWISE, hint=hint, **MOMENTUM)


@check(points=0.75, part="a")
def momentum_with_the_velocity_relative_to_C(student, draw):
    """angular_momentum by definition c: the velocity as one sees it who moves along with C."""
    calls, hint = cases.momenta(draw, "c"), "Whose velocity, seen from where?"
    agree(student.angular_momentum, right.angular_momentum, calls, within=POINTWISE, hint=hint, **MOMENTUM)


def refuse_others(function, expected, case):
    """Letters that name no definition are refused, and definition b is not."""
    accepts = [(case, expected(*case.args, **case.kwargs))]
    within = POINTWISE * moment_size(case) if len(case.args) == 7 else POINTWISE * momentum_size(case, None)
    hint = "Raise ValueError for anything but the three letters."
    refuse(function, cases.others(case), accepts=accepts, within=within, hint=hint)


@check(points=0.25, part="a", after=(momentum_with_the_velocity_in_F, momentum_with_the_velocity_relative_to_C))
def momentum_refuses_other_definitions(student, draw):
    """angular_momentum raises ValueError for another definition."""
    refuse_others(student.angular_momentum, right.angular_momentum, cases.momenta(draw, "b")[0])


def by_difference(hint):
    """The hint, but for a rate that is nearly right, as a difference quotient is."""

    def told(case, found, expected):
        nearly = np.abs(found - expected).max() <= NEARLY * moment_size(case)
        return (
            "It is nearly right: is it a difference quotient? Differentiate the product on paper." if nearly else hint
        )

    return told


FIXED = "C' stays where C is at this instant: what is its velocity?"
PRODUCT = by_difference("Differentiate the product: which vectors change with time?")


@check(points=0.5, part="a")
def rate_about_a_fixed_point(student, draw):
    """rate by definition a: the derivative while C' stays where it is."""
    agree(student.rate, right.rate, cases.rates(draw, "a"), within=POINTWISE, hint=by_difference(FIXED), **RATE)


@check(points=1, part="a")
def rate_with_the_velocity_in_F(student, draw):
    """rate by definition b: the derivative of its angular momentum along any motion of P and C."""
    agree(student.rate, right.rate, cases.rates(draw, "b"), within=POINTWISE, hint=PRODUCT, **RATE)


@check(points=0.75, part="a")
def rate_with_the_velocity_relative_to_C(student, draw):
    """rate by definition c: the derivative of its angular momentum along any motion of P and C."""
    agree(student.rate, right.rate, cases.rates(draw, "c"), within=POINTWISE, hint=PRODUCT, **RATE)


@check(points=0.25, part="a", after=(rate_about_a_fixed_point, rate_with_the_velocity_in_F))
def rate_refuses_other_definitions(student, draw):
    """rate raises ValueError for another definition."""
    refuse_others(student.rate, right.rate, cases.rates(draw, "b")[0])


def left_over(case, found, expected):
    near = POINTWISE * moment_size(case)
    if np.abs(found).max() <= near:
        return "It vanishes: is your rate the moment itself, and the motion of C forgotten?"
    if np.abs(found + expected).max() <= near:
        return "It is moment less rate: the sign is reversed."
    return "It is your rate less your moment: what is left of it on paper?"


@check(points=0.5, part="a")
def discrepancy_with_the_velocity_in_F(student, draw):
    """discrepancy by definition b: its rate less the moment."""
    calls = cases.rates(draw, "b")
    agree(student.discrepancy, right.discrepancy, calls, within=POINTWISE, hint=left_over, **DISCREPANCY)


@check(points=0.5, part="a")
def discrepancy_with_the_velocity_relative_to_C(student, draw):
    """discrepancy by definition c: its rate less the moment."""
    calls = cases.rates(draw, "c")
    agree(student.discrepancy, right.discrepancy, calls, within=POINTWISE, hint=left_over, **DISCREPANCY)


@check(points=0.25, part="a", after=discrepancy_with_the_velocity_in_F)
def no_discrepancy_about_a_fixed_point(student, draw):
    """discrepancy by definition a."""
    agree(student.discrepancy, right.discrepancy, cases.rates(draw, "a"), within=POINTWISE, hint=FIXED, **DISCREPANCY)


@check(points=0.25, part="a", after=discrepancy_with_the_velocity_in_F)
def discrepancy_refuses_other_definitions(student, draw):
    """discrepancy raises ValueError for another definition."""
    refuse_others(student.discrepancy, right.discrepancy, cases.rates(draw, "b")[0])


def judge_motion(definition, p, c):
    """The motion must have no flaw; if it has none in another order, the student is told."""
    for says, hint in special.flaws(definition, p, c):
        fail(says, hint=special.order_hint(definition, p, c) or hint)


@check(points=1.5, part="a")
def special_motion_of_b(student, draw):
    """special_motion of b: a motion with C speeding, for which definition b holds at every t, and c does not."""
    judge_motion("b", *student.special_motion("b"))


@check(points=1.25, part="a")
def special_motion_of_c(student, draw):
    """special_motion of c: a motion with C speeding, for which definition c holds at every t, and b does not."""
    judge_motion("c", *student.special_motion("c"))


@check(points=0.25, part="a", after=(special_motion_of_b, special_motion_of_c))
def special_motion_refuses_other_definitions(student, draw):
    """special_motion raises ValueError for another definition."""
    calls = [given(name).on(f'the definition "{name}"') for name in ("d", "bc", "", "a", *cases.LETTERS_ALIKE)]
    refuse(student.special_motion, calls, accepts=(), within=0.0, hint='Raise ValueError for anything but "b" and "c".')
