"""Hidden checks of hw09."""

import math
from functools import partial

import numpy as np

from tam570_grader import Assignment, Case, check, expect, expect_that
from tam570_grader.checks.compare import absolute, check_domain, check_raises, compare_with, largest
from tam570_grader.checks.plots import judge_boxes
from tam570_grader.checks.returns import array, group, number

from . import cases, reference

WITHIN = 1e-13  # methods without division by a small number have errors of 1e-15; 1e-12 rad taken for no turn, 1e-12
# for small angles and their axes: R - R^T and quaternions err by 5e-16, the null vector of R - I by 6e-11 at 1e-8 rad
RELATIVE = 1e-12
MANY_TURNS = 1e-10  # by S = R A R^T, R <- S R, rounding errors triple at each turn: 1e-14 after six, 1e-11 after twelve
# for a matrix sheared by 7e-7: axes from its parts differ by as much, that by eigh of R + R^T by 3.5e-6 (4000 draws)
SHEARED = 2e-5
STRETCHED = 2e-3  # rad: the identity times 1 + 4.5e-7 has a cosine of 1 + 6.8e-7: no angle, or 1.2e-3 rad by its size
NEAR_MISS = 1e-5  # of a result, or rad; a pi of few digits has a smaller error
SAME = 1e-6

compare = compare_with(reference, tolerance=WITHIN)


def in_limits(case, _):
    """Return the scale of a matrix; it is larger for many turns, which allows a larger error."""
    return 1.0 if len(case.args[0]) < 5 else MANY_TURNS / WITHIN


def near(result, expected, tolerance=SAME):
    return np.abs(np.subtract(result, expected)).max() <= tolerance


def of_few_digits(case, result, expected, otherwise):
    return "It is nearly right: which number has too few digits?" if near(result, expected, NEAR_MISS) else otherwise


QUARTER_TURN = partial(of_few_digits, otherwise="Where does a quarter turn take each of the other two axes?")
WHICH_FIRST = partial(of_few_digits, otherwise="Which matrix acts on a vector first, the leftmost or the rightmost?")
THE_EDGES = partial(of_few_digits, otherwise="Turn a real book: where do its three edges end?")


@check("axis_rotation", points=1)
def turns_about_the_coordinate_axes(student, rng):
    """axis_rotation turns by the angle about x, y or z, by the right-hand rule."""
    compare(student.axis_rotation, cases.turns(rng), hint=QUARTER_TURN)


@check("axis_rotation", points=0.5, after=turns_about_the_coordinate_axes, refusals=True)
def other_axes_are_refused(student, rng):
    """axis_rotation raises ValueError for any other string."""
    check_domain(student.axis_rotation, reference, cases.no_axes(rng), tolerance=WITHIN)


@check("space_sequence", points=1)
def space_sequence_takes_the_first_step_first(student, rng):
    """space_sequence turns about axes fixed in space, first step first."""
    compare(student.space_sequence, cases.sequences(rng), hint=WHICH_FIRST)


@check("space_sequence", points=0.25, after=space_sequence_takes_the_first_step_first)
def space_sequence_takes_few_steps(student, rng):
    """space_sequence of one step, and of none: the identity."""
    compare(student.space_sequence, cases.few_steps(rng))


@check("body_sequence", points=1)
def body_sequence_takes_the_axes_along(student, rng):
    """body_sequence turns about the axes that the steps before have turned."""
    compare(student.body_sequence, cases.sequences(rng), hint=WHICH_FIRST)


@check("body_sequence", points=0.25, after=body_sequence_takes_the_axes_along)
def body_sequence_takes_few_steps(student, rng):
    """body_sequence of one step, and of none: the identity."""
    compare(student.body_sequence, cases.few_steps(rng))


@check("book_rotations", points=1)
def the_book_is_turned_in_both_orders(student, rng):
    """90 degrees about z then x, and about x then z, axes fixed in space."""
    compare(student.book_rotations, [Case()], hint=THE_EDGES)


# (d, e) Axis and angle

NEGATIVE = "Your angle is negative: flip both signs, as -angle about -axis is the same turn."
TOO_LARGE = "The angle is larger than pi: the same turn is one by 2 pi - angle about the opposite axis."
OPPOSITE = "The axis points the opposite way: R - R^T tells which."
LONG = "The axis points the right way, but its length is not 1."
IS_KEPT = "R n = n holds for your axis, but near the identity every vector nearly obeys it: use R - R^T."
SMALL_ONES = "Only its small components are off: is that a square root of a small difference?"
SIGNS = "The sizes of its components are right, their signs are not: R + R^T has the products n_x n_y."


def of_pairs(case, result, expected, otherwise, near_miss=""):
    """Return what is wrong with an axis and its angle, if the numbers show it, else where to look."""
    (axis, angle), (n, right_angle) = result, expected
    small, same_axis = np.abs(n) < 1e-4, near(axis, n)
    only_small = small.any() and near(axis[~small], n[~small], WITHIN) and not near(axis, n, WITHIN)
    small_angle = right_angle < 0.1 and near(angle, right_angle, RELATIVE * right_angle)
    holds_of = {
        NEGATIVE: angle < 0 and near(-angle, right_angle) and near(-axis, n),
        TOO_LARGE: angle > math.pi + SAME and near(angle, 2 * math.pi - right_angle),
        "Small angles are given as 0.": angle == 0 and right_angle < 0.1,
        "Angles near pi are given as pi.": angle == math.pi,
        LONG: not near(axis @ axis, 1) and near(axis, np.linalg.norm(axis) * n),
        # an eigenvector up to the rounding of R, which an axis is not by chance
        IS_KEPT: small_angle and near(case.args[0] @ axis, axis, 2e-15),
        SMALL_ONES: same_axis and only_small,
        OPPOSITE: near(-axis, n) and near(angle, right_angle),
        SIGNS: near(np.abs(axis), np.abs(n)) and not same_axis,
        near_miss: near(axis, n, NEAR_MISS) and near(angle, right_angle, NEAR_MISS),
    }
    return next((message for message, holds in holds_of.items() if holds and message), otherwise)


LOST = "It is nearly right: where are digits lost?"
WHAT_STAYS = partial(of_pairs, otherwise="Which vector does R keep, and what is the trace of R?", near_miss=LOST)
FLAT_COSINE = "An arccos of the trace loses half of the digits there, and so does the arcsine of half of the angle."
HALF = 1e-6  # rad: half of the digits; if the angle itself is small, all digits of an arccos
WHICH_PART = "Which part of R is large there: R - R^T or R + R^T?"


def where_flat(case, result, expected):
    return of_pairs(case, result, expected, of_angle(result[1], expected[1]) or WHICH_PART)


def of_angle(angle, expected):
    """Return what is wrong with an angle; "" if it is right."""
    if abs(angle - expected) <= WITHIN:
        return ""
    return FLAT_COSINE if near(angle, expected, HALF) else "Test it: the trace of R is 1 + 2 cos(angle)."


@check("axis_angle", points=1)
def axis_and_angle_are_those_of_the_matrix(student, rng):
    """axis_angle gives the unit axis and the angle of a rotation, of the book's two and of a quarter turn too."""
    compare(student.axis_angle, cases.generic(rng), hint=WHAT_STAYS)


@check("axis_angle", points=0.75, after=axis_and_angle_are_those_of_the_matrix)
def small_angles_keep_their_digits(student, rng):
    """axis_angle keeps all digits of axis and angle for angles from 1e-12 to 1e-2."""
    compare(student.axis_angle, cases.small(rng), tolerance=RELATIVE, scale=largest, hint=where_flat)


@check("axis_angle", points=0.75, after=axis_and_angle_are_those_of_the_matrix)
def angles_near_pi_keep_their_digits(student, rng):
    """axis_angle keeps all digits 1e-12 to 1e-2 from a half turn, and at a quarter turn."""
    compare(student.axis_angle, cases.near_pi(rng), hint=where_flat)
    compare(student.axis_angle, cases.near_quarters(rng), hint=where_flat)


@check("axis_angle", points=0.25, after=angles_near_pi_keep_their_digits)
def axes_with_small_components_keep_their_digits(student, rng):
    """axis_angle keeps all digits near pi where a component of the axis is very small."""
    compare(student.axis_angle, cases.small_components(rng), hint=where_flat)


@check("axis_angle", points=0.25, after=axis_and_angle_are_those_of_the_matrix)
def half_turns_have_their_axis(student, rng):
    """axis_angle of a half turn: the angle pi and the axis, of either sign."""
    for case, (axis, angle) in student.axis_angle.each(cases.half_turns(rng)):
        expect(angle, math.pi, tolerance=WITHIN, quantity="the angle", unit="rad", hint=of_angle(angle, math.pi))
        squares = (case.args[0] + np.eye(3)) / 2
        hint = SIGNS if near(axis**2, np.diag(squares)) else "What is R + I there?"
        expect(np.outer(axis, axis), squares, tolerance=WITHIN, quantity="the product n n^T of the axis", hint=hint)


@check("axis_angle", points=0.25, after=axis_and_angle_are_those_of_the_matrix)
def no_turn_has_a_unit_axis(student, rng):
    """axis_angle of the identity: the angle 0 and any unit axis."""
    for _, (axis, angle) in student.axis_angle.each([Case(np.eye(3)).labelled("the identity")]):
        expect(angle, 0.0, tolerance=WITHIN, quantity="the angle", unit="rad")
        expect_that(np.any(axis), "the axis is the zero vector")
        expect(np.linalg.norm(axis), 1.0, tolerance=WITHIN, quantity="the length of the axis")


@check("axis_angle", points=0.25, after=axis_and_angle_are_those_of_the_matrix)
def what_is_no_rotation_is_refused(student, rng):
    """axis_angle refuses matrices that are not rotations, and accepts one with R^T R wrong by 9e-7."""
    sheared = cases.nearly_rotations(rng)
    stretched = Case((1 + 4.5e-7) * np.eye(3)).labelled("the identity times 1 + 4.5e-7")
    wrong, along_z = cases.no_rotations(rng), cases.stretched_along_z(rng)
    axis_angle = student.axis_angle.ahead([*sheared, stretched, *wrong, *along_z])
    compare(axis_angle, sheared, tolerance=SHEARED)
    for _, (axis, angle) in axis_angle.each([stretched]):
        expect(np.linalg.norm(axis), 1.0, tolerance=SHEARED, quantity="the length of the axis")
        expect(angle, 0.0, tolerance=STRETCHED, quantity="the angle", unit="rad")
    check_raises(axis_angle, wrong)
    check_raises(axis_angle, along_z, hint="Do you use np.allclose? Its rtol allows 1e-5 beside a one.")


# (c) The book


@check("book_edges", points=1.5, part="c")
def the_book_has_its_twelve_edges(student, rng):
    """book_edges are the edges of the turned book, in any order and direction."""
    judge_boxes(student.book_edges, cases.books(rng), tolerance=WITHIN)


ASSIGNMENT = Assignment(
    returns={
        "axis_rotation": array(3, 3).described("the matrix", scale=absolute),
        "space_sequence": array(3, 3).described("the matrix", scale=in_limits),
        "body_sequence": array(3, 3).described("the matrix", scale=in_limits),
        "book_rotations": group(*(array(3, 3).described(f"the matrix of ({part})", scale=absolute) for part in "ab")),
        "axis_angle": group(
            array(3).described("the axis", scale=absolute), number.described("the angle", "rad", absolute)
        ),
        "book_edges": array(12, 2, 3),
    },
    forbidden={"*": ("scipy.spatial.transform", "tam570.rotations", "tam570.lectures")},
    needs=("numpy",),
)
