"""Compute the matrices of many quaternions at once, by one matrix product.

In a batch of a thousand, NumPy's calls cost more than the arithmetic. The components are rows of one workspace, so that
one call computes several rows. Each of the nine entries is a sum of products of two components: one constant matrix
times these products gives them all. This divides before it sums, so an entry has an error of up to 3 eps, with the
formula for floats of up to 1.2 eps. A turn by 0 gives exactly the identity.

Each function fills the results (n, 9) and returns the measure (n,).
"""

import numpy as np

from tam570.rotations._evaluate import Array

ENTRIES = np.array(  # entries of R, one a line, as sums of the products below
    [  # ww  xx  yy  zz  wx  xy  yz  wy  xz  wz
        [1, 1, -1, -1, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 2, 0, 0, 0, -2],
        [0, 0, 0, 0, 0, 0, 0, 2, 2, 0],
        [0, 0, 0, 0, 0, 2, 0, 0, 0, 2],
        [1, -1, 1, -1, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, -2, 0, 2, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0, -2, 2, 0],
        [0, 0, 0, 0, 2, 0, 2, 0, 0, 0],
        [1, -1, -1, 1, 0, 0, 0, 0, 0, 0],
    ],
    dtype=np.float64,
).T.copy()
ONES = np.ones(4)


def matrix_of_quaternion(tables: list[Array], workspace: Array, results: Array) -> Array:
    """Compute the rotation matrices of quaternions (4, n) of any length."""
    square: Array = workspace[15]
    workspace[:4] = tables[0]
    _matrix(workspace, square, results)
    return square


def matrix_of_axis_angle(tables: list[Array], workspace: Array, results: Array) -> Array:
    """Compute the rotation matrices of axes (3, n) of any length and angles (1, n)."""
    X = workspace[1:4]
    square: Array = workspace[15]
    X[...] = tables[0]
    _sum_of_squares(X, workspace[4:7], square)
    t = np.tan(0.5 * tables[1][0])
    t /= np.sqrt(square)
    _matrix_of_tangent(t, workspace, results)
    t *= 0.0
    square += t  # NaN if the angle is not finite
    return square


def matrix_of_vector(tables: list[Array], workspace: Array, results: Array) -> Array:
    """Compute the rotation matrices of rotation vectors (3, n)."""
    X, angle, t = workspace[1:4], workspace[4], workspace[5]
    square: Array = workspace[15]
    X[...] = tables[0]
    _sum_of_squares(X, workspace[4:7], square)
    np.sqrt(square, out=angle)
    np.maximum(angle, 1e-150, out=angle)  # for smaller angles tan(angle/2)/angle is 1/2 to rounding
    np.multiply(angle, 0.5, out=t)
    np.tan(t, out=t)
    t /= angle
    _matrix_of_tangent(t, workspace, results)
    return square


def _sum_of_squares(rows: Array, squares: Array, total: Array) -> None:
    np.multiply(rows, rows, out=squares)
    np.dot(ONES[: len(rows)], squares, out=total)


def _matrix_of_tangent(t: Array, workspace: Array, results: Array) -> None:
    """Compute the matrices of the quaternions (1, t x, t y, t z), with x, y, z in rows 1 to 3 of the workspace."""
    workspace[0] = 1.0
    workspace[1:4] *= t
    _matrix(workspace, workspace[14], results)


def _matrix(workspace: Array, square: Array, results: Array) -> None:
    """Compute the matrices of the quaternions in the first four rows; write their squared lengths to `square`."""
    Q, products = workspace[:4], workspace[4:14]
    over_square = products[:4]
    _sum_of_squares(Q, over_square, square)
    np.divide(Q, square, out=over_square)
    np.multiply(over_square[:3], Q[1:], out=products[4:7])
    np.multiply(over_square[:2], Q[2:], out=products[7:9])
    np.multiply(over_square[0], Q[3], out=products[9])
    np.multiply(over_square, Q, out=over_square)
    np.matmul(products.T, ENTRIES, out=results)
