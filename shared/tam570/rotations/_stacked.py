"""The matrices of many quaternions at once, by one matrix product.

A batch of a thousand is short enough for the calls of NumPy to cost more than the arithmetic. The components lie
in rows of one workspace, so that one call serves all rows that are treated alike; the nine entries, each a sum of
the products of two components, are these times one constant matrix. That divides before it sums: an entry is off
by 3 eps at most, where the formula for floats is by 1.2. A turn by 0 is the identity, exactly.

Each function fills the results (n, 9) and returns the measure (n,).
"""

import numpy as np

from tam570.rotations._evaluate import Array

ENTRIES = np.array(  # of R, one a line, from the rows of products
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
    """Rotation matrices of quaternions (4, n) of any length."""
    square: Array = workspace[15]
    workspace[:4] = tables[0]
    _matrix(workspace, square, results)
    return square


def matrix_of_axis_angle(tables: list[Array], workspace: Array, results: Array) -> Array:
    """Rotation matrices of axes (3, n) of any length and angles (1, n)."""
    X = workspace[1:4]
    square: Array = workspace[15]
    X[...] = tables[0]
    _sum_of_squares(X, workspace[4:7], square)
    t = np.tan(0.5 * tables[1][0])
    t /= np.sqrt(square)
    _matrix_of_tangent(t, workspace, results)
    t *= 0.0
    square += t  # no number if the angle is none
    return square


def matrix_of_vector(tables: list[Array], workspace: Array, results: Array) -> Array:
    """Rotation matrices of rotation vectors (3, n)."""
    X, angle, t = workspace[1:4], workspace[4], workspace[5]
    square: Array = workspace[15]
    X[...] = tables[0]
    _sum_of_squares(X, workspace[4:7], square)
    np.sqrt(square, out=angle)
    np.maximum(angle, 1e-150, out=angle)  # down there tan(angle/2)/angle is 1/2 to the last digit
    np.multiply(angle, 0.5, out=t)
    np.tan(t, out=t)
    t /= angle
    _matrix_of_tangent(t, workspace, results)
    return square


def _sum_of_squares(rows: Array, squares: Array, total: Array) -> None:
    np.multiply(rows, rows, out=squares)
    np.dot(ONES[: len(rows)], squares, out=total)


def _matrix_of_tangent(t: Array, workspace: Array, results: Array) -> None:
    """Of the quaternions (1, t x, t y, t z), with x, y, z in their rows."""
    workspace[0] = 1.0
    workspace[1:4] *= t
    _matrix(workspace, workspace[14], results)


def _matrix(workspace: Array, square: Array, results: Array) -> None:
    """Of the quaternions in the first four rows, whose squared lengths go to a row that is not theirs."""
    Q, products = workspace[:4], workspace[4:14]
    over_square = products[:4]
    _sum_of_squares(Q, over_square, square)
    np.divide(Q, square, out=over_square)
    np.multiply(over_square[:3], Q[1:], out=products[4:7])
    np.multiply(over_square[:2], Q[2:], out=products[7:9])
    np.multiply(over_square[0], Q[3], out=products[9])
    np.multiply(over_square, Q, out=over_square)
    np.matmul(products.T, ENTRIES, out=results)
