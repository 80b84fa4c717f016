"""The matrices of many quaternions at once, by one matrix product.

A batch of a thousand is short enough for the calls of NumPy to cost more than the arithmetic. The components lie
in rows of one workspace, so that one call serves all rows that are treated alike; the nine entries, each a sum of
the products of two components, are these times one constant matrix. That divides before it sums: an entry is off
by 2.4 eps at most, where the formula for floats is by 1.2. A turn by 0 is the identity, exactly.

Each function fills the results (n, 9) and returns the measure (n,).
"""

import numpy as np

from tam570.rotations._evaluate import Array

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


def matrix_of_quaternion(tables: list[Array], workspace: Array, results: Array) -> Array:
    """Rotation matrices of quaternions (4, n) of any length."""
    Q, products = workspace[:5], workspace[5:15]
    square: Array = workspace[15]
    Q[:4] = tables[0]
    Q[4] = Q[1]  # y, z, x in a run
    np.einsum("kn,kn->n", Q[:4], Q[:4], out=square)
    over_square = np.divide(1.0, square, out=products[4])
    G = np.multiply(Q[:4], over_square, out=products[:4])
    np.multiply(G[1:], Q[2:5], out=products[4:7])
    np.multiply(G[1:], Q[0], out=products[7:])
    np.multiply(G, Q[:4], out=G)
    np.matmul(products.T, ENTRIES, out=results)
    return square


def matrix_of_axis_angle(tables: list[Array], workspace: Array, results: Array) -> Array:
    """Rotation matrices of axes (3, n) of any length and angles (1, n)."""
    X = workspace[:4]
    square: Array = workspace[15]
    X[:3] = tables[0]
    np.einsum("kn,kn->n", X[:3], X[:3], out=square)
    t = np.tan(0.5 * tables[1][0])
    t /= np.sqrt(square)
    X[:3] *= t
    t *= 0.0
    square += t  # no number if the angle is none
    _matrix(workspace, results)
    return square


def matrix_of_vector(tables: list[Array], workspace: Array, results: Array) -> Array:
    """Rotation matrices of rotation vectors (3, n)."""
    X, angle = workspace[:4], workspace[4]
    square: Array = workspace[15]
    X[:3] = tables[0]
    np.einsum("kn,kn->n", X[:3], X[:3], out=square)
    np.sqrt(square, out=angle)
    np.maximum(angle, 1e-150, out=angle)  # down there tan(angle/2)/angle is 1/2 to the last digit
    t = np.multiply(angle, 0.5, out=workspace[5])
    np.tan(t, out=t)
    t /= angle
    X[:3] *= t
    _matrix(workspace, results)
    return square


def _matrix(workspace: Array, results: Array) -> None:
    """Of the quaternions (1, x, y, z), given in the first three rows."""
    X, products, square = workspace[:4], workspace[5:15], workspace[4]
    X[3] = X[0]  # y, z, x in a run
    np.einsum("kn,kn->n", X[:3], X[:3], out=square)
    square += 1.0
    over_square = np.divide(1.0, square, out=products[0])
    G = np.multiply(X[:3], over_square, out=products[7:])
    np.multiply(G, X[:3], out=products[1:4])
    np.multiply(G, X[1:], out=products[4:7])
    np.matmul(products.T, ENTRIES, out=results)
