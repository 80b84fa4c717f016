"""Reference functions of hw03: products of vectors of polynomials in time, differentiated."""

import numpy as np

# of coefficients (k, 3) of a vector of polynomials, the constant first
derivative = np.polynomial.polynomial.polyder


def cross(p, q):
    """Return the coefficients (k, 3) of the vector product of two vectors of polynomials."""
    product = np.zeros((len(p) + len(q) - 1, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        product[:, k] = np.convolve(p[:, i], q[:, j]) - np.convolve(p[:, j], q[:, i])
    return product


def difference(p, q):
    longer = max(len(p), len(q))
    p, q = (np.vstack([f, np.zeros((longer - len(f), 3))]) for f in (p, q))
    return p - q


def momentum(definition, p, c, mass):
    """Return the angular momentum as polynomials in time; C' is where C is at the time 0."""
    velocity = derivative(difference(p, c) if definition == "c" else p)
    return mass * cross(difference(p, c[:1] if definition == "a" else c), velocity)


def path(r, v, a=(0.0, 0.0, 0.0)):
    """Return the polynomial of a point that is at r with these derivatives at the time 0."""
    return np.array([r, v, np.asarray(a) / 2])


def moment(r_p, a_p, r_c, mass):
    return cross(np.array([r_p - r_c]), np.array([mass * a_p]))[0]


def angular_momentum(definition, r_p, v_p, r_c, v_c, mass):
    return momentum(definition, path(r_p, v_p), path(r_c, v_c), mass)[0]


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass):
    return derivative(momentum(definition, path(r_p, v_p, a_p), path(r_c, v_c, a_c), mass))[0]


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass):
    return rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass) - moment(r_p, a_p, r_c, mass)
