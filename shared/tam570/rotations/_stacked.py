"""The matrices of many quaternions at once, by one matrix product.

A batch of a thousand is short enough for the calls of NumPy to cost more than the arithmetic. The components lie
in rows of one array, so that one call serves all rows that are treated alike; the nine entries, each a sum of
the products of two components, are these times one constant matrix. That divides before it sums: an entry is off
by 2.4 eps at most, where the formula for floats is by 1.2. A turn by 0 is the identity, exactly.
"""

import numpy as np

from tam570.rotations._evaluate import Array

Measured = tuple[Array, Array]  # the measure (n,), and the results (n, 9)

ENTRIES = np.array(  # of R, one a line, from the rows of products
    [  # ww  xx  yy  zz  xy  yz  zx  wx  wy  wz
        [1, 1, -1, -1, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 2, 0, 0, 0, 0, -2],
        [0, 0, 0, 0, 0, 0, 2, 0, 2, 0],
        [0, 0, 0, 0, 2, 0, 0, 0, 0, 2],
        [1, -1, 1, -1, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 2, 0, -2, 0, 0],
        [0, 0, 0, 0, 0, 0, 2, 0, -2, 0],
        [0, 0, 0, 0, 0, 2, 0, 2, 0, 0],
        [1, -1, -1, 1, 0, 0, 0, 0, 0, 0],
    ],
    dtype=np.float64,
).T.copy()


def matrix_of_quaternion(tables: list[Array]) -> Measured:
    """Rotation matrices of quaternions (4, n) of any length."""
    Q = np.empty((5, tables[0].shape[1]))
    Q[:4] = tables[0]
    Q[4] = Q[1]  # y, z, x in a run
    n = np.add.reduce(Q[:4] * Q[:4], axis=0)
    G = Q[:4] / n
    products = np.empty((10, len(n)))
    np.multiply(G, Q[:4], out=products[:4])
    np.multiply(G[1:], Q[2:5], out=products[4:7])
    np.multiply(G[1:], Q[0], out=products[7:])
    return n, products.T @ ENTRIES


def matrix_of_axis_angle(tables: list[Array]) -> Measured:
    """Rotation matrices of axes (3, n) of any length and angles (1, n)."""
    axis, angle = tables
    X = np.empty((4, axis.shape[1]))
    X[:3] = axis
    square = _square(X[:3])
    t = np.tan(0.5 * angle[0])
    t /= np.sqrt(square)
    X[:3] *= t
    t *= 0.0
    square += t  # no number if the angle is none
    return square, _matrix(X)[1]


def matrix_of_vector(tables: list[Array]) -> Measured:
    """Rotation matrices of rotation vectors (3, n)."""
    X = np.empty((4, tables[0].shape[1]))
    X[:3] = tables[0]
    angle = np.sqrt(_square(X[:3]))
    np.maximum(angle, 1e-150, out=angle)  # down there tan(angle/2)/angle is 1/2 to the last digit
    t = np.tan(0.5 * angle)
    t /= angle
    X[:3] *= t
    return _matrix(X)


def _square(X: Array) -> Array:
    return np.asarray(np.add.reduce(X * X, axis=0))


def _matrix(X: Array) -> Measured:
    """Of the quaternions (1, x, y, z), given in the first three of four rows."""
    X[3] = X[0]  # y, z, x in a run
    n = _square(X[:3])
    n += 1.0
    products = np.empty((10, len(n)))
    over_n = np.divide(X[:3], n, out=products[7:])
    np.divide(1.0, n, out=products[0])
    np.multiply(over_n, X[:3], out=products[1:4])
    np.multiply(over_n, X[1:], out=products[4:7])
    return n, products.T @ ENTRIES
