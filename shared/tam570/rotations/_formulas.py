"""The conversions as straight-line formulas; matrices row by row, quaternions scalar first.

A quaternion of any length stands for a rotation: leaving it unnormalised saves roundings and square roots.
"""

from tam570.rotations._evaluate import Component, Functions

Numbers = tuple[Component, ...]


def square(*components: Component) -> Component:
    """The sum of squares."""
    return sum((c * c for c in components[1:]), components[0] * components[0])


def matrix_of_quaternion(f: Functions, w: Component, x: Component, y: Component, z: Component) -> Numbers:
    """Rotation matrix of a quaternion of any length."""
    s = 2 / square(w, x, y, z)
    sx, sy, sz = s * x, s * y, s * z
    xx, yy, zz = sx * x, sy * y, sz * z
    xy, yz, zx = sx * y, sy * z, sz * x
    wx, wy, wz = w * sx, w * sy, w * sz
    return 1 - (yy + zz), xy - wz, zx + wy, xy + wz, 1 - (xx + zz), yz - wx, zx - wy, yz + wx, 1 - (xx + yy)


def matrix_of_axis_angle(f: Functions, x: Component, y: Component, z: Component, angle: Component) -> Numbers:
    """Rotation matrix of an axis of any length and an angle, by the quaternion (1, n tan(angle/2)) |axis|."""
    t = f.tan(0.5 * angle)  # no double is near enough to pi for t to overflow
    return matrix_of_quaternion(f, f.sqrt(square(x, y, z)), t * x, t * y, t * z)


def matrix_of_vector(f: Functions, x: Component, y: Component, z: Component) -> Numbers:
    """Rotation matrix of a rotation vector."""
    angle = f.sqrt(square(x, y, z))  # 0 below 1e-162, where tan(angle/2)/angle is 1/2 to the last digit
    t = f.where(angle == 0, 0.5, f.tan(0.5 * angle) / f.where(angle == 0, 1.0, angle))
    return matrix_of_quaternion(f, 1.0, t * x, t * y, t * z)


def quaternion_direction(f: Functions, *R: Component) -> Numbers:
    """The quaternion times a number of at least 2, scalar part not negative (Shepperd 1978).

    The outer product 4 q q^T is linear in R; of its four columns the one of a large enough component of q is
    taken, so that nothing cancels.
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
    """Unit quaternion of a rotation matrix, w >= 0."""
    w, x, y, z = quaternion_direction(f, *R)
    s = 1 / f.sqrt(square(w, x, y, z))
    return s * w, s * x, s * y, s * z


def axis_angle_of_matrix(f: Functions, *R: Component) -> Numbers:
    """Unit axis and angle in [0, pi]; the x axis where the angle is 0."""
    w, x, y, z = quaternion_direction(f, *R)
    length = f.hypot(f.hypot(x, y), z)  # not the root of a sum of squares: 1e-300 squared is 0
    still = length == 0
    s = f.where(still, 1.0, length)
    return f.where(still, 1.0, x / s), y / s, z / s, 2 * f.atan2(length, w)


def vector_of_matrix(f: Functions, *R: Component) -> Numbers:
    """Rotation vector, no longer than pi."""
    w, x, y, z = quaternion_direction(f, *R)
    length = f.hypot(f.hypot(x, y), z)
    s = 2 * f.atan2(length, w) / f.where(length == 0, 1.0, length)
    return s * x, s * y, s * z


def product_of_quaternions(f: Functions, *pq: Component) -> Numbers:
    """Hamilton's product p q."""
    a, b, c, d, w, x, y, z = pq
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def skew_of_vector(f: Functions, x: Component, y: Component, z: Component) -> Numbers:
    """The matrix of the cross product."""
    return 0.0, -z, y, z, 0.0, -x, -y, x, 0.0


def vector_of_skew(f: Functions, *S: Component) -> Numbers:
    """The vector of the antisymmetric part."""
    return 0.5 * (S[7] - S[5]), 0.5 * (S[2] - S[6]), 0.5 * (S[3] - S[1])


def defect(*R: Component) -> Component:
    """How far the rows of R are from a right-handed orthonormal triad (sum of squared errors)."""
    a, b, c, d, e, g, h, k, m = R
    return square(
        a * a + b * b + c * c - 1,
        d * d + e * e + g * g - 1,
        a * d + b * e + c * g,
        b * g - c * e - h,
        c * d - a * g - k,
        a * e - b * d - m,
    )
