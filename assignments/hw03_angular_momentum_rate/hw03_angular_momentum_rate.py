"""hw03: What does "rate of change of angular momentum" mean?

figure.svg, beside this file, shows the axes, the names and the positive senses.

A particle P moves, and so does a point C, in any way it likes, relative to a Newtonian frame F with origin O. All
vectors have components in F: r from O, v and a as seen in F. Three definitions of the angular momentum about C:
"a" r_{P/C'} x m v_P, where C' is fixed in F at the place where C is now;
"b" r_{P/C} x m v_P;
"c" r_{P/C} x m v_{P/C}.
A `definition` is "a", "b" or "c"; every function raises ValueError for another. r_p, v_p, a_p and r_c, v_c, a_c are
positions, velocities and accelerations of P and of C, (3,) each, in m, m/s, m/s^2; `mass` is that of P, in kg.
"""

import numpy as np

__all__ = ["angular_momentum", "discrepancy", "moment", "rate", "special_motion"]


def moment(r_p, a_p, r_c, *, mass):
    """Moment about C of the total force on P. Returns (3,), N m."""
    raise NotImplementedError


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    """Angular momentum of P about C by one of the three definitions. Returns (3,), kg m^2/s."""
    raise NotImplementedError


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    """Time derivative in F of that angular momentum, exact, for any motion of P and C. Returns (3,), N m."""
    raise NotImplementedError


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    """By how much the rate of that angular momentum differs from the moment: rate less moment. Returns (3,), N m."""
    raise NotImplementedError


def special_motion(definition):
    """A motion of P and C for which this definition has rate = moment at every t, and the other of "b", "c" has not.

    Neither the velocity nor the acceleration of C vanishes for 0 <= t <= 1; P and C are apart then and do not move
    together (r_{P/C} is not constant). P may stand still.

    definition : "b" or "c"; ValueError for "a", too
    Returns (p, c): two arrays (k, 3), k of each its own, with P(t) = sum of p[j] t^j and C(t) = sum of c[j] t^j.
    """
    raise NotImplementedError
