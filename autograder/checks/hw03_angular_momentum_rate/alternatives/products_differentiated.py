"""Show that any special motions pass: collinear velocities for b, P at rest about C for c."""

import numpy as np


def moment(r_p, a_p, r_c, *, mass):
    return mass * np.cross(r_p - r_c, a_p)


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    if definition in ("a", "b"):
        return np.cross(r_p - r_c, mass * v_p)
    if definition == "c":
        return np.cross(r_p - r_c, mass * (v_p - v_c))
    raise ValueError(definition)


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    r = r_p - r_c
    if definition == "a":
        return mass * (np.cross(v_p, v_p) + np.cross(r, a_p))
    if definition == "b":
        return mass * (np.cross(v_p - v_c, v_p) + np.cross(r, a_p))
    if definition == "c":
        return mass * (np.cross(v_p - v_c, v_p - v_c) + np.cross(r, a_p - a_c))
    raise ValueError(definition)


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    return rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass) - moment(r_p, a_p, r_c, mass=mass)


def special_motion(definition):
    d = np.array([0.3, -0.7, 0.2])  # both move along d, at different rates, on parallel lines
    if definition == "b":
        c = np.outer([0.0, 0.9, 0.4, 0.1], d)
        p = np.outer([1.1, -0.6, 0.7], d) + np.outer([1, 0, 0], [2.0, 1.0, -0.5])
        return p, c
    if definition == "c":  # all in one direction from C: P = C + (1 + t/3) a_C, with a_C constant
        a = np.array([0.1, 0.7, -1.3])
        c = np.array([[0.2, 0.1, 3.0], [1.7, -0.3, 0.6], a / 2])
        p = c + np.array([a, a / 3, 0 * a])
        return p, c
    raise ValueError(definition)
