"""Hidden checks of hw08."""

import numpy as np

from tam570_grader import Assignment, absolute, array, check, check_domain, compare_with, expect

from . import cases, reference

# a few rounding errors of numbers of size 1 make 1e-15; quaternions and products of matrices, 1e-14
POINTWISE = 1e-12
TINY = 1e-14  # rounding of the cosine; 0 in place of an angle of 1e-12 has an error of 1e-12, cos 3e-6 = 1 of 4e-12
# 1e6 rad, reduced modulo 2 pi by hand, has an error of 2e-10; R^T R of a matrix exponential of 2e-8
HUGE_ANGLE = 5e-8
BY_SIZE = TINY, POINTWISE, POINTWISE, HUGE_ANGLE  # tolerances of cases.angles_by_size
NEAR_MISS = 1e-5  # of the result; a pi of few digits has a smaller error, wrong physics a larger one

compare = compare_with(reference, tolerance=POINTWISE)


def length(case, _):
    return np.linalg.norm(case.args[0])


def of_few_digits(case, result, expected):
    if np.max(np.abs(result - expected)) <= NEAR_MISS * np.max(np.abs(expected)):
        return "It is nearly right: does a number have too few digits, or does an arccos lose them?"
    return "Try a quarter turn about z and a third of a turn about (1, 1, 1): both take x to y."


def of_which_term(case, result, expected):
    """Return which term is wrong: the cosine makes the symmetric part of the matrix, the sine the rest."""
    off = result - expected
    cosine, sine = np.abs(off + off.T).max(), np.abs(off - off.T).max()
    if cosine > 100 * sine:
        return "The sine is right in it, the cosine is not."
    return "The cosine is right in it, the sine is not." if sine > 100 * cosine else "What does each term become there?"


@check("skew", points=1)
def skew_is_the_cross_product(student, rng):
    """skew(v) r = v x r, for any v and r."""
    compare(student.skew, cases.vectors(rng), hint="Which columns are v x e, for the three unit vectors e?")


@check("rotation_matrix", points=2)
def matrix_turns_by_the_right_hand_rule(student, rng):
    """rotation_matrix turns by the angle about the axis, right-handed, whatever the axis's length."""
    compare(student.rotation_matrix, [*cases.turns(rng), *cases.plain_turns(rng)], hint=of_few_digits)


@check("rotation_matrix", points=1, after=matrix_turns_by_the_right_hand_rule)
def matrix_holds_for_every_angle(student, rng):
    """an angle of 1e-12 turns by 1e-12, one of 1e6 by 1e6; R^T R = I and det R = 1 for all of them."""
    sizes = cases.turns_by_size(rng)
    rotation_matrix = student.rotation_matrix.ahead(sum(sizes, []))
    for tolerance, calls in zip(BY_SIZE, sizes, strict=True):
        # a matrix exponential by scaling and squaring changes lengths, too, at 1e6 rad
        R = np.array(compare(rotation_matrix, calls, tolerance=tolerance, hint=of_which_term))
        squares, volumes = np.swapaxes(R, 1, 2) @ R, np.linalg.det(R)
        worst = np.argmax(np.abs(squares - np.eye(3)).max(axis=(1, 2)))
        said = {"tolerance": max(tolerance, POINTWISE), "label": calls[worst].label, "at": calls[worst]}
        expect(squares[worst], np.eye(3), quantity="R^T R", **said)
        expect(volumes, 1.0, quantity="det R", **said)


@check("rotation_matrix", points=1, after=matrix_turns_by_the_right_hand_rule)
def matrix_depends_on_the_direction_alone(student, rng):
    """axes of length 1e-100 or 1e100 give the same matrix as the unit axis."""
    compare(student.rotation_matrix, cases.of_any_length(rng), hint="Divide by any length; what becomes of its square?")


@check("rotation_matrix", points=1, after=matrix_turns_by_the_right_hand_rule, refusals=True)
def matrix_refuses_what_is_no_axis(student, rng):
    """rotation_matrix raises ValueError for an axis that is zero or not finite, whatever the angle."""
    check_domain(student.rotation_matrix, reference, cases.no_axes(rng), tolerance=POINTWISE)


@check("rotate", points=2)
def vector_turns_by_the_right_hand_rule(student, rng):
    """rotate turns r as the matrix would, whatever the axis's length."""
    compare(student.rotate, cases.turned_vectors(rng), hint=of_few_digits)


@check("rotate", points=1, after=vector_turns_by_the_right_hand_rule)
def vector_turns_by_every_angle(student, rng):
    """rotate holds for angles from 1e-12 to 1e6 and axes from 1e-100 to 1e100 long."""
    sizes = cases.vectors_by_size(rng)
    rotate = student.rotate.ahead(sum(sizes, []))
    for tolerance, calls in zip(BY_SIZE, sizes, strict=True):
        compare(rotate, calls, tolerance=tolerance)


@check("rotate", points=1, after=vector_turns_by_the_right_hand_rule, refusals=True)
def rotate_refuses_what_is_no_axis(student, rng):
    """rotate raises ValueError for an axis that is zero or not finite, whatever angle and vector."""
    check_domain(student.rotate, reference, cases.vectors_about_no_axes(rng), tolerance=POINTWISE)


ASSIGNMENT = Assignment(
    returns={
        "skew": array(3, 3).described("skew(v)", scale=length),
        "rotation_matrix": array(3, 3).described("the matrix", scale=absolute),
        "rotate": array(3).described("the turned vector", "m", scale=length),
    },
    forbidden={"*": ("scipy.spatial.transform", "tam570.rotations", "tam570.lectures"), "rotate": ("rotation_matrix",)},
    needs=("numpy",),
)
