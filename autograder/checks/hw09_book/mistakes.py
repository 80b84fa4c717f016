"""Known mistakes of hw09."""

import math

import numpy as np

from tam570_grader.diagnosis.mistakes import mistake

from . import checks

# Matrices and sequences


@mistake(first_fails=checks.turns_about_the_coordinate_axes)
def axis_rotation(reference, axis, angle):
    """You drop the sign of the angle; a negative angle turns the other way."""
    return reference(axis, abs(angle))


@mistake(first_fails=checks.other_axes_are_refused, compared=False)
def axis_rotation(reference, axis, angle):
    """You use z for every string except x and y; raise ValueError for other strings."""
    return reference(axis if axis in ("x", "y") else "z", angle)


@mistake(first_fails=checks.other_axes_are_refused, compared=False)
def axis_rotation(reference, axis, angle):
    """You look up the axis in the string "xyz", where Python also finds "", "xy" and "yz"; accept single letters
    only.
    """
    return reference("xyz"["xyz".index(axis)], angle)


@mistake(first_fails=checks.space_sequence_takes_the_first_step_first)
def space_sequence(reference, steps):
    """You return after the first step; return after the loop."""
    return reference(steps[:1])


@mistake(first_fails=checks.space_sequence_takes_the_first_step_first, compared=False)
def space_sequence(reference, steps):
    """You remove the steps from the given list; leave the list unchanged."""
    return reference([steps.pop(0) for _ in list(steps)])


@mistake(first_fails=checks.space_sequence_takes_few_steps, compared=False)
def space_sequence(reference, steps):
    """You start from the first step, which fails when there is none; start from the identity."""
    return reference([steps[0], *steps[1:]])


@mistake(first_fails=checks.body_sequence_takes_the_axes_along)
def body_sequence(reference, steps):
    """You turn about axes fixed in space; these axes turn with the body."""
    return reference(steps[::-1])


@mistake(first_fails=checks.body_sequence_takes_the_axes_along)
def body_sequence(reference, steps):
    """You return the transpose of space_sequence, which undoes it; multiply the same matrices in the other order."""
    return space_sequence(steps).T


@mistake(first_fails=checks.body_sequence_takes_few_steps, compared=False)
def body_sequence(reference, steps):
    """You start from the first step, which fails when there is none; start from the identity."""
    return reference([steps[0], *steps[1:]])


@mistake(first_fails=checks.the_book_is_turned_in_both_orders)
def book_rotations(reference):
    """You exchange (a) and (b), as if the axes turned with the book; they are fixed in space."""
    R_a, R_b = reference()
    return R_b, R_a


@mistake(first_fails=checks.the_book_is_turned_in_both_orders)
def book_rotations(reference):
    """You return the transpose of (a) as (b), which undoes (a); (b) makes the same two turns in the other order."""
    R_a, _ = reference()
    return R_a, R_a.T


@mistake(first_fails=checks.the_book_is_turned_in_both_orders, compared=False)
def book_rotations(reference):
    """You turn the book by 1.5708 rad; use math.pi / 2."""
    about_x, about_z = ("x", 1.5708), ("z", 1.5708)
    return space_sequence([about_z, about_x]), space_sequence([about_x, about_z])


# Axis and angle


@mistake(first_fails=checks.axis_and_angle_are_those_of_the_matrix, label="far from special")
def axis_angle(reference, R):
    """Your angle is an arcsine, which never exceeds pi/2; beyond pi/2 the angle is pi minus the arcsine."""
    axis, angle = reference(R)
    return axis, min(angle, math.pi - angle)


@mistake(first_fails=checks.axis_and_angle_are_those_of_the_matrix)
def axis_angle(reference, R):
    """Your axis is the vector part of the quaternion, whose length is sin(angle/2); divide by that length."""
    axis, angle = reference(R)
    return math.sin(angle / 2) * axis, angle


@mistake(first_fails=checks.axis_and_angle_are_those_of_the_matrix)
def axis_angle(reference, R):
    """You use half of the trace as the cosine of the angle; subtract 1 from the trace first."""
    axis, _ = reference(R)
    return axis, math.acos(max(-1.0, min(1.0, np.trace(R) / 2)))


@mistake(first_fails=checks.axis_and_angle_are_those_of_the_matrix)
def axis_angle(reference, R):
    """You give all components of the axis one sign beyond 2 rad; R + R^T has the signs of their products."""
    axis, angle = reference(R)
    return math.copysign(1, axis.sum()) * np.abs(axis) if angle > 2 else axis, angle


@mistake(first_fails=checks.small_angles_keep_their_digits)
def axis_angle(reference, R):
    """Your angle is from the trace alone, which loses half of the digits near 0 and pi; use arctan2."""
    return reference(R)[0], math.acos(np.clip((np.trace(R) - 1) / 2, -1, 1))


@mistake(first_fails=checks.small_angles_keep_their_digits, compared=False)
def axis_angle(reference, R):
    """You compute the axis as the null vector of R - I, which loses digits for small angles; use R - R^T."""
    axis, angle = reference(R)
    null = np.linalg.svd(R - np.eye(3))[2][2]
    return math.copysign(1, null @ axis) * null if 0 < angle < math.pi else axis, angle


@mistake(first_fails=checks.angles_near_pi_keep_their_digits, compared=False)
def axis_angle(reference, R):
    """Your angle is an arcsine, which loses half of the digits at a quarter turn; use arctan2."""
    axis, angle = reference(R)
    arcsine = math.asin(min(np.linalg.norm(R - R.T) / math.sqrt(8), 1.0))
    return axis, angle if angle > 2 else arcsine if np.trace(R) >= 1 else math.pi - arcsine


@mistake(first_fails=checks.angles_near_pi_keep_their_digits)
def axis_angle(reference, R):
    """You take the axis, or its sign, from R - R^T, which rounding spoils near pi; use R + R^T there."""
    axis, angle = reference(R)
    twice_sine_n = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return twice_sine_n / (2 * math.sin(angle)) if angle > 0 else axis, angle


@mistake(first_fails=checks.axes_with_small_components_keep_their_digits, compared=False)
def axis_angle(reference, R):
    """You use square roots of the diagonal, which lose half of a small component's digits; use a column of R + R^T."""
    axis, angle = reference(R)
    squares = (np.diag(R) - math.cos(angle)) / (1 - math.cos(angle)) if angle > 3 else axis**2
    return np.copysign(np.sqrt(np.clip(squares, 0, None)), axis) if angle > 3 else axis, angle


@mistake(first_fails=checks.half_turns_have_their_axis)
def axis_angle(reference, R):
    """You drop the signs of a half turn's axis; R + I has the signs of the products of its components."""
    axis, angle = reference(R)
    return np.abs(axis) if np.abs(R - R.T).max() < 1e-14 else axis, angle


@mistake(first_fails=checks.no_turn_has_a_unit_axis, compared=False)
def axis_angle(reference, R):
    """You divide the axis of the identity by its length, which is 0; return any unit vector."""
    axis, angle = reference(R)
    return axis if angle > 0 else np.full(3, np.nan), angle


@mistake(first_fails=checks.what_is_no_rotation_is_refused, compared=False)
def axis_angle(reference, R):
    """Your arccos gives NaN where the trace is larger than 3; clip the cosine to 1."""
    axis, angle = reference(R)
    return axis, np.arccos((np.trace(R) - 1) / 2) if angle == 0 else angle


@mistake(first_fails=checks.what_is_no_rotation_is_refused, compared=False)
def _rotation(reference, R):
    """You compare R^T R with I by np.allclose, whose rtol allows 1e-5 beside a 1; set rtol=0."""
    if not (np.isfinite(R).all() and np.allclose(R.T @ R, np.eye(3), atol=1e-6) and np.linalg.det(R) > 0):
        raise ValueError
    return R


@mistake(first_fails=checks.what_is_no_rotation_is_refused, compared=False)
def _rotation(reference, R):
    """You accept a matrix with NaN, for which every comparison is false; test np.isfinite."""
    return R if np.isnan(R).any() else reference(R)


@mistake(first_fails=checks.what_is_no_rotation_is_refused, compared=False)
def _rotation(reference, R):
    """You accept reflections; refuse a matrix with a negative determinant."""
    return math.copysign(1, np.linalg.det(R)) * reference(math.copysign(1, np.linalg.det(R)) * R)


@mistake(first_fails=checks.what_is_no_rotation_is_refused, compared=False)
def _rotation(reference, R):
    """You refuse a matrix whose R^T R is wrong by more than 1e-12; the limit is 1e-6."""
    if np.abs(R.T @ R - np.eye(3)).max() > 1e-12:
        raise ValueError
    return reference(R)


# The book's edges


@mistake(first_fails=checks.the_book_has_its_twelve_edges, compared=False)
def book_edges(reference, R, *, size):
    """You return one edge twice and miss another; return twelve different edges."""
    edges = reference(R, size=size)
    edges[7] = edges[3][::-1]
    return edges


@mistake(first_fails=checks.the_book_has_its_twelve_edges, compared=False)
def book_edges(reference, R, *, size):
    """You turn the corners by R^T; turn them by R."""
    return reference(R.T, size=size)
