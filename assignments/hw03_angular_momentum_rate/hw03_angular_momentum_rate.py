"""hw03: What does "rate of change of angular momentum" mean?

figure.svg, beside this file, shows the axes, the names and the positive senses.

A particle P moves, and so does a point C, in any way it likes, relative to a Newtonian frame F with origin O. All
vectors have components in F: r from O, v and a as seen in F. Three definitions of the angular momentum about C:
"a" r_{P/C'} x m v_P, where C' is fixed in F at the place where C is now;
"b" r_{P/C} x m v_P;
"c" r_{P/C} x m v_{P/C}.
"""

import numpy as np

__all__ = ["angular_momentum", "discrepancy", "moment", "rate", "special_motion"]


def moment(r_p, a_p, r_c, *, mass):
    """Moment about C of the total force on P.

    r_p : (3,) position of P, m
    a_p : (3,) acceleration of P, m/s^2
    r_c : (3,) position of C, m
    mass: of P, kg
    Returns (3,), N m.
    """
    raise NotImplementedError


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    """Angular momentum of P about C by one of the three definitions.

    definition : "a", "b" or "c"
    r_p, v_p : (3,) position and velocity of P, m, m/s
    r_c, v_c : (3,) position and velocity of C, m, m/s
    mass     : of P, kg
    Returns (3,), kg m^2/s.
    Raises ValueError for another definition.
    """
    raise NotImplementedError


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    """Time derivative in F of that angular momentum, exact, for any motion of P and C.

    definition : "a", "b" or "c"
    r_p, v_p, a_p : (3,) position, velocity, acceleration of P, m, m/s, m/s^2
    r_c, v_c, a_c : (3,) position, velocity, acceleration of C, m, m/s, m/s^2
    mass          : of P, kg
    Returns (3,), N m.
    Raises ValueError for another definition.
    """
    raise NotImplementedError


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    """By how much the rate of that angular momentum differs from the moment: rate less moment.

    definition : "a", "b" or "c"
    r_p, v_p, a_p : (3,) position, velocity, acceleration of P, m, m/s, m/s^2
    r_c, v_c, a_c : (3,) position, velocity, acceleration of C, m, m/s, m/s^2
    mass          : of P, kg
    Returns (3,), N m.
    Raises ValueError for another definition.
    """
    raise NotImplementedError


def special_motion(definition):
    """A motion of P and C for which this definition has rate = moment at every t, and the other of "b", "c" has not.

    Neither the velocity nor the acceleration of C vanishes for 0 <= t <= 1; P and C are apart then and do not move
    together (r_{P/C} is not constant). P may stand still.

    definition : "b" or "c"
    Returns (p, c): two arrays (k, 3), k of each its own, with P(t) = sum of p[j] t^j and C(t) = sum of c[j] t^j.
    Raises ValueError for another definition.
    """
    raise NotImplementedError
