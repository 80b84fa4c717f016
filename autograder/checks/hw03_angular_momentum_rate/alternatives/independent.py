"""Right: product rule by hand, match statements, a special motion whose r_{P/C} turns with a_C."""
import numpy as np


def moment(r_p, a_p, r_c, *, mass):
    return np.cross(r_p - r_c, mass * a_p)


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    match definition:
        case "a" | "b":
            return np.cross(r_p - r_c, mass * v_p)
        case "c":
            return mass * np.cross(r_p - r_c, v_p - v_c)
        case _:
            raise ValueError("definition?")


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    r, v, a = r_p - r_c, v_p - v_c, a_p - a_c
    if definition == "a":
        return mass * np.cross(r, a_p)  # C' is fixed, v_p x v_p = 0
    if definition == "b":
        return mass * (np.cross(v, v_p) + np.cross(r, a_p))
    if definition == "c":
        return mass * np.cross(r, a)
    raise ValueError("definition?")


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    got = rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass)
    return list(got - moment(r_p, a_p, r_c, mass=mass))


def special_motion(definition):
    if definition == "b":  # the acceleration of C along its line is small, P passes it at a distance of 1 mm
        return [[0, 1e-3, 0], [1, 0, 0]], [[0, 0, 0], [2, 0, 0], [1e-3, 0, 0]]
    if definition == "c":  # r turns with a_C: C = (t^3 / 6, t^2 / 2, t), a_C = (t, 1, 0), r = 2 a_C
        c = np.array([[0, 0, 0], [0, 0, 1], [0, 0.5, 0], [1 / 6, 0, 0]])
        return c + np.array([[0, 2, 0], [2, 0, 0], [0, 0, 0], [0, 0, 0]]), c
    raise ValueError
