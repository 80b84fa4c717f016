"""What is right in hw03: products of vectors of polynomials in time, differentiated."""

import numpy as np

# coefficients (k, 3) of a vector of polynomials, the constant first


def cross(p, q):
    """Coefficients (k, 3) of the vector product of two vectors of polynomials."""
    product = np.zeros((len(p) + len(q) - 1, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        product[:, k] = np.convolve(p[:, i], q[:, j]) - np.convolve(p[:, j], q[:, i])
    return product


def derivative(p):
    return p[1:] * np.arange(1, len(p))[:, None] if len(p) > 1 else np.zeros((1, 3))


def difference(p, q):
    longer = max(len(p), len(q))
    p, q = (np.vstack([f, np.zeros((longer - len(f), 3))]) for f in (p, q))
    return p - q


def value(p, t):
    """Of a vector of polynomials, at numbers t: (..., 3)."""
    return np.moveaxis(np.polynomial.polynomial.polyval(t, p), 0, -1)


def momentum(definition, p, c, mass, now):
    """The angular momentum as polynomials in time; C' is where C is at the time `now`."""
    held = value(c, now)[None] if definition == "a" else c
    velocity = derivative(difference(p, c)) if definition == "c" else derivative(p)
    return mass * cross(difference(p, held), velocity)


def path(r, v, a=(0.0, 0.0, 0.0)):
    """The polynomial of a point that is at r with these derivatives at the time 0."""
    return np.array([r, v, np.asarray(a) / 2])


def moment(r_p, a_p, r_c, mass):
    arm, force = np.array([r_p - r_c]), np.array([mass * a_p])
    return cross(arm, force)[0]


def angular_momentum(definition, r_p, v_p, r_c, v_c, mass):
    return momentum(definition, path(r_p, v_p), path(r_c, v_c), mass, 0.0)[0]


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass):
    return derivative(momentum(definition, path(r_p, v_p, a_p), path(r_c, v_c, a_c), mass, 0.0))[0]


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass):
    return rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass) - moment(r_p, a_p, r_c, mass)
