"""The conversions as straight-line formulas; matrices row by row, quaternions scalar first.

The first result is a measure of the input: a squared length, the defect of a matrix, or 0 for finite numbers.

Quaternions have any length: not to normalise them saves roundings and square roots.
"""

import math

from tam570.rotations._evaluate import Component, Functions

Numbers = tuple[Component, ...]


def square(*components: Component) -> Component:
    """Return the sum of squares."""
    total = components[0] * components[0]
    for c in components[1:]:
        total = total + c * c
    return total


def nothing(*components: Component) -> Component:
    """Return 0 if all components, and their sum, are finite, else NaN."""
    total = components[0]
    for c in components[1:]:
        total = total + c
    return 0.0 * total


def matrix_of_quaternion(f: Functions, w: Component, x: Component, y: Component, z: Component) -> Numbers:
    """Return the rotation matrix of a quaternion of any length."""
    ww, xx, yy, zz = w * w, x * x, y * y, z * z
    near_x, off_x, over_x, y_over_z = ww + xx, yy + zz, ww - xx, yy - zz
    n = near_x + off_x  # one division per entry, at the end, has half the rounding of a unit quaternion's formula
    h = 0.5 * n
    xy, yz, zx = x * y, y * z, z * x
    wx, wy, wz = w * x, w * y, w * z
    return (
        n,
        (near_x - off_x) / n,
        (xy - wz) / h,
        (zx + wy) / h,
        (xy + wz) / h,
        (over_x + y_over_z) / n,
        (yz - wx) / h,
        (zx - wy) / h,
        (yz + wx) / h,
        (over_x - y_over_z) / n,
    )


def matrix_of_axis_angle(f: Functions, x: Component, y: Component, z: Component, angle: Component) -> Numbers:
    """Return the rotation matrix of an axis of any length and an angle by the quaternion (1, n tan(angle/2)) |axis|."""
    t = f.tan(0.5 * angle)  # no float is close enough to pi for t to overflow
    return matrix_of_quaternion(f, f.sqrt(square(x, y, z)), t * x, t * y, t * z)


def matrix_of_vector(f: Functions, x: Component, y: Component, z: Component) -> Numbers:
    """Return the rotation matrix of a rotation vector."""
    angle = f.sqrt(square(x, y, z))  # 0 below 1e-162, where tan(angle/2)/angle is 1/2 to rounding
    t = f.where(angle == 0, 0.5, f.tan(0.5 * angle) / f.where(angle == 0, 1.0, angle))
    return matrix_of_quaternion(f, 1.0, t * x, t * y, t * z)


def quaternion_direction(f: Functions, *R: Component) -> Numbers:
    """Return the quaternion times a number of at least 2, scalar part not negative (Shepperd 1978).

    The outer product 4 q q^T is linear in R. The formula uses its column of a large enough component of q, so that
    nothing cancels.
    """
    a, b, c, d, e, g, h, k, m = R
    on_axis, x_not_y, z_not_w = m < 0, a > e, a < -e

    def column(of_w: Component, of_x: Component, of_y: Component, of_z: Component) -> Component:
        return f.where(on_axis, f.where(x_not_y, of_x, of_y), f.where(z_not_w, of_z, of_w))

    w = column(1 + a + e + m, k - g, c - h, d - b)
    x = column(k - g, 1 + a - e - m, d + b, c + h)
    y = column(c - h, d + b, 1 - a + e - m, k + g)
    z = column(d - b, c + h, k + g, 1 - a - e + m)
    sign = f.where(w < 0, -1.0, 1.0)
    return sign * w, sign * x, sign * y, sign * z


def quaternion_of_matrix(f: Functions, *R: Component) -> Numbers:
    """Return the unit quaternion of a rotation matrix, w >= 0."""
    w, x, y, z = quaternion_direction(f, *R)
    s = 1 / f.sqrt(square(w, x, y, z))
    return defect(*R), s * w, s * x, s * y, s * z


def axis_angle_of_matrix(f: Functions, *R: Component) -> Numbers:
    """Return the unit axis and the angle in [0, pi]; the x axis if the angle is 0."""
    w, x, y, z = quaternion_direction(f, *R)
    length = f.norm(x, y, z)
    still = length == 0
    s = f.where(still, 1.0, length)
    return defect(*R), f.where(still, 1.0, x / s), y / s, z / s, 2 * f.atan2(length, w)


def vector_of_matrix(f: Functions, *R: Component) -> Numbers:
    """Return the rotation vector, no longer than pi, of a rotation matrix."""
    w, x, y, z = quaternion_direction(f, *R)
    length = f.norm(x, y, z)
    angle = 2 * f.atan2(length, w)
    s = angle / f.where(length == 0, 1.0, length)
    return defect(*R), *to_length(f, angle, s * x, s * y, s * z)


def to_length(f: Functions, length: Component, x: Component, y: Component, z: Component) -> Numbers:
    """Correct a vector, whose length is off by a few roundings, to `length`: near pi such an error would matter."""
    grid = 2.0**28 * length
    excess: Component = 0.0
    rest: Component = 0.0
    for c, sign in (length, 1), (x, -1), (y, -1), (z, -1):
        high = (c + grid) - grid  # the leading 25 bits: their squares and the sum of these are exact
        excess = excess + sign * (high * high)
        rest = rest + sign * ((c - high) * (c + high))
    square_of_length = length * length
    s = 0.5 * (excess + rest) / f.where(square_of_length == 0, 1.0, square_of_length)
    return x + s * x, y + s * y, z + s * z


def product_of_quaternions(f: Functions, *pq: Component) -> Numbers:
    """Return Hamilton's product p q."""
    a, b, c, d, w, x, y, z = pq
    return (
        nothing(*pq),
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def skew_of_vector(f: Functions, x: Component, y: Component, z: Component) -> Numbers:
    """Return the matrix of the cross product."""
    zero = nothing(x, y, z)
    return zero, zero, -z, y, z, zero, -x, -y, x, zero


def vector_of_skew(f: Functions, *S: Component) -> Numbers:
    """Return the vector of the antisymmetric part."""
    return nothing(*S), 0.5 * (S[7] - S[5]), 0.5 * (S[2] - S[6]), 0.5 * (S[3] - S[1])


def nearest_rotation(f: Functions, *M: Component) -> Numbers:
    """Return the last step's square and the orthogonal factor of M, by Newton's iteration X <- (X + X^-T)/2.

    Five steps suffice for singular values within a factor of ten (Higham 1986). For a left-handed M the first is inf.
    """
    s = f.sqrt(3 / square(*M))
    X = tuple(s * entry for entry in M)
    right_handed = True
    for _ in range(5):
        inverse_transpose, determinant = cofactors(*X)
        right_handed = right_handed & (determinant > 0)
        previous, h = X, 0.5 / determinant
        X = tuple(0.5 * entry + h * cofactor for entry, cofactor in zip(X, inverse_transpose, strict=True))
    step = square(*(new - old for new, old in zip(X, previous, strict=True)))
    return f.where(right_handed, step, math.inf), *X


def cofactors(*X: Component) -> tuple[Numbers, Component]:
    """Return the cofactors of a matrix, det(X) X^-T, and its determinant."""
    a, b, c, d, e, g, h, k, m = X
    p, q, r = e * m - g * k, g * h - d * m, d * k - e * h
    of_rest = (c * k - b * m, a * m - c * h, b * h - a * k, b * g - c * e, c * d - a * g, a * e - b * d)
    return (p, q, r, *of_rest), a * p + b * q + c * r


def defect(*R: Component) -> Component:
    """Return how far the rows of R are from a right-handed orthonormal triad (sum of squared errors)."""
    a, b, c, d, e, g, h, k, m = R
    return square(
        a * a + b * b + c * c - 1,
        d * d + e * e + g * g - 1,
        a * d + b * e + c * g,
        b * g - c * e - h,
        c * d - a * g - k,
        a * e - b * d - m,
    )
