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
    return np.cross(r_p - r_c, mass * a_p)


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    """Angular momentum of P about C by one of the three definitions.

    definition : "a", "b" or "c"
    r_p, v_p : (3,) position and velocity of P, m, m/s
    r_c, v_c : (3,) position and velocity of C, m, m/s
    mass     : of P, kg
    Returns (3,), kg m^2/s.
    Raises ValueError for another definition.
    """
    _check(definition)
    velocity = v_p - v_c if definition == "c" else v_p
    return np.cross(r_p - r_c, mass * velocity)


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    """Time derivative in F of that angular momentum, exact, for any motion of P and C.

    definition : "a", "b" or "c"
    r_p, v_p, a_p : (3,) position, velocity, acceleration of P, m, m/s, m/s^2
    r_c, v_c, a_c : (3,) position, velocity, acceleration of C, m, m/s, m/s^2
    mass          : of P, kg
    Returns (3,), N m.
    Raises ValueError for another definition.
    """
    _check(definition)
    if definition == "a":  # C' does not move, and v_P x m v_P = 0
        return np.cross(r_p - r_c, mass * a_p)
    if definition == "b":
        return np.cross(v_p - v_c, mass * v_p) + np.cross(r_p - r_c, mass * a_p)
    return np.cross(r_p - r_c, mass * (a_p - a_c))


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    """By how much the rate of that angular momentum differs from the moment: rate less moment.

    definition : "a", "b" or "c"
    r_p, v_p, a_p : (3,) position, velocity, acceleration of P, m, m/s, m/s^2
    r_c, v_c, a_c : (3,) position, velocity, acceleration of C, m, m/s, m/s^2
    mass          : of P, kg
    Returns (3,), N m.
    Raises ValueError for another definition.
    """
    # What is left: nothing for a, -v_C x m v_P for b, -r_{P/C} x m a_C for c.
    motion = r_p, v_p, a_p, r_c, v_c, a_c
    return rate(definition, *motion, mass=mass) - moment(r_p, a_p, r_c, mass=mass)


def special_motion(definition):
    """A motion of P and C for which this definition has rate = moment at every t, and the other of "b", "c" has not.

    Neither the velocity nor the acceleration of C vanishes for 0 <= t <= 1; P and C are apart then and do not move
    together (r_{P/C} is not constant). P may stand still.

    definition : "b" or "c"
    Returns (p, c): two arrays (k, 3), k of each its own, with P(t) = sum of p[j] t^j and C(t) = sum of c[j] t^j.
    Raises ValueError for another definition.
    """
    _check(definition, "bc")
    if definition == "b":  # P stands still beside the line along which C speeds up
        return np.array([[0.0, 1, 0]]), np.array([[0.0, 0, 0], [1, 0, 0], [1, 0, 0]])
    # C is thrown; P is above it at every time, and rises from it steadily
    return np.array([[0.0, 1, 0], [1, 1, 0], [0, -1, 0]]), np.array([[0.0, 0, 0], [1, 0, 0], [0, -1, 0]])


def _check(definition, allowed="abc"):
    if definition not in tuple(allowed):
        raise ValueError(f"definition: one of {', '.join(allowed)}, got {definition!r}")
