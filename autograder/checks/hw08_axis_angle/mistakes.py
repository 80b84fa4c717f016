"""Known mistakes of hw08."""

import math

import numpy as np

from tam570_grader.diagnosis.mistakes import mistake

from . import checks

# The cross product


@mistake(first_fails=checks.skew_is_the_cross_product, name="transposed_skew")
def skew(reference, v):
    """You return the matrix of r x v; it must be v x r."""
    return reference(v).T


@mistake(first_fails=checks.skew_is_the_cross_product)
def skew(reference, v):
    """You return the identity for v = 0; it is the zero matrix."""
    return reference(v) if np.any(v) else np.eye(3)


# The axis


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def _unit(reference, axis):
    """You use the axis as it is; divide it by its length."""
    return np.array(axis)


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def _unit(reference, axis):
    """You divide the axis by the square of its length; divide it by its length."""
    return axis / np.dot(axis, axis)


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def rotation_matrix(reference, axis, angle):
    """You multiply the angle by the length of the axis; only the axis's direction matters."""
    return reference(axis, angle * np.linalg.norm(axis))


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule, compared=False)
def rotation_matrix(reference, axis, angle):
    """You get the axis's polar angle from arccos, which rounds to 0 near the z axis; use arctan2 or no angle."""
    x, y, z = _unit(axis)
    polar, azimuth = math.acos(max(-1.0, min(1.0, z))), math.atan2(y, x)
    n = [math.sin(polar) * math.cos(azimuth), math.sin(polar) * math.sin(azimuth), math.cos(polar)]
    return reference(n if polar < 1e-6 else axis, angle)


@mistake(first_fails=checks.matrix_depends_on_the_direction_alone)
def _unit(reference, axis):
    """You refuse a short axis; only the zero axis has no direction."""
    if np.linalg.norm(axis) < 1e-8:
        raise ValueError("no axis")
    return reference(axis)


@mistake(first_fails=checks.matrix_depends_on_the_direction_alone)
def rotation_matrix(reference, axis, angle):
    """You do not turn about a short axis; only its direction matters."""
    return np.eye(3) if 0 < np.linalg.norm(axis) < 1e-8 else reference(axis, angle)


@mistake(first_fails=checks.matrix_refuses_what_is_no_axis, compared=False)
def _unit(reference, axis):
    """You test only the largest component of the axis; minus infinity is not the largest."""
    if np.isnan(axis).any() or np.max(axis) == np.inf or not np.any(axis):
        raise ValueError("no axis")
    finite = np.nan_to_num(axis) / np.max(np.abs(np.nan_to_num(axis)))
    return finite / np.linalg.norm(finite)


@mistake(first_fails=checks.matrix_refuses_what_is_no_axis, compared=False)
def _unit(reference, axis):
    """You accept an axis that is not finite; raise ValueError."""
    length = np.max(np.abs(axis))
    if length == 0:
        raise ValueError("no axis")
    return axis / length / np.linalg.norm(axis / length)


@mistake(first_fails=checks.matrix_refuses_what_is_no_axis, compared=False)
def rotation_matrix(reference, axis, angle):
    """You return the identity for the zero axis; raise ValueError."""
    return reference(axis, angle) if np.any(axis) else np.eye(3)


@mistake(first_fails=checks.matrix_refuses_what_is_no_axis, compared=False)
def rotation_matrix(reference, axis, angle):
    """You do not look at the axis where the angle is 0; raise ValueError for a zero axis there, too."""
    return np.eye(3) if angle == 0 else reference(axis, angle)


# The three terms


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def rotation_matrix(reference, axis, angle):
    """You multiply the identity by n . n; the term needs the dyad n n^T."""
    return np.eye(3) + np.sin(angle) * skew(_unit(axis))


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def rotation_matrix(reference, axis, angle):
    """You multiply n * n element by element; np.outer(n, n) has all products n_x n_y."""
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + (1 - np.cos(angle)) * n * n + np.sin(angle) * skew(n)


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def rotation_matrix(reference, axis, angle):
    """You put only the squares of n on the diagonal; the term needs all products n_x n_y, the dyad n n^T."""
    n, c = _unit(axis), np.cos(angle)
    return c * np.eye(3) + (1 - c) * np.diag(n**2) + np.sin(angle) * skew(n)


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def rotation_matrix(reference, axis, angle):
    """You square each element of skew(n) by K ** 2; use K @ K, the product of the matrix with itself."""
    K = skew(_unit(axis))
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K**2


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule, name="square_subtracted")
def rotation_matrix(reference, axis, angle):
    """You subtract (1 - cos(angle)) skew(n)^2; add it."""
    K = skew(_unit(axis))
    return np.eye(3) - (1 - np.cos(angle)) * K @ K + np.sin(angle) * K


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def rotation_matrix(reference, axis, angle):
    """You write the quaternion as (w, x, y, z) and read it as (x, y, z, w); keep to one order."""
    x, y, z, w = np.cos(angle / 2), *np.sin(angle / 2) * _unit(axis)
    return reference((x, y, z), 2 * np.arctan2(np.linalg.norm((x, y, z)), w))


# The angle


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def rotation_matrix(reference, axis, angle):
    """You drop the sign of the angle; keep it."""
    return reference(axis, abs(angle))


@mistake(first_fails=checks.matrix_turns_by_the_right_hand_rule)
def rotation_matrix(reference, axis, angle):
    """You return the identity for a half turn; its sine is 0, but its cosine is -1."""
    return reference(axis, 0.0 if abs(np.sin(angle)) < 1e-15 else angle)


@mistake(first_fails=checks.matrix_holds_for_every_angle)
def rotation_matrix(reference, axis, angle):
    """You use single precision for large angles; use float64."""
    return reference(axis, np.float32(angle).item() if abs(angle) > 50 else angle)


@mistake(first_fails=checks.matrix_holds_for_every_angle, tolerance=1e-14)
def rotation_matrix(reference, axis, angle):
    """You do not turn by angles below 1e-8; the term with sin(angle) counts there, too."""
    return reference(axis, 0.0 if abs(angle) < 1e-8 else angle)


# Vectors


@mistake(first_fails=checks.vector_turns_by_the_right_hand_rule)
def rotate(reference, r, axis, angle):
    """You return zero for r along the axis, where n x r is zero; r stays as it is."""
    across = np.cross(_unit(axis), r)
    return reference(r, axis, angle) if np.linalg.norm(across) > 1e-9 * np.linalg.norm(r) else across


@mistake(first_fails=checks.vector_turns_by_the_right_hand_rule, compared=False)
def rotate(reference, r, axis, angle):
    """You multiply r by the matrix; the formula needs no matrix."""
    return rotation_matrix(axis, angle) @ r


@mistake(first_fails=checks.vector_turns_by_the_right_hand_rule, compared=False)
def rotate(reference, r, axis, angle):
    """You change the given r; return a new vector."""
    r[:] = reference(r, axis, angle)
    return r


@mistake(first_fails=checks.rotate_refuses_what_is_no_axis, compared=False)
def rotate(reference, r, axis, angle):
    """You return the zero vector before you look at the axis; raise ValueError for a zero axis."""
    return reference(r, axis, angle) if np.any(r) else np.zeros(3)


@mistake(first_fails=checks.vector_turns_by_every_angle, tolerance=1e-14)
def rotate(reference, r, axis, angle):
    """You do not turn r by angles below 1e-8; the term with sin(angle) counts there, too."""
    return reference(r, axis, 0.0 if abs(angle) < 1e-8 else angle)
