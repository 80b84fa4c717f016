"""Show that a rate by finite differences of high order passes."""

import numpy as np

WEIGHTS = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}


def moment(r_p, a_p, r_c, *, mass):
    x, y, z = r_p - r_c
    fx, fy, fz = mass * a_p
    return [y * fz - z * fy, z * fx - x * fz, x * fy - y * fx]


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    velocities = {"a": v_p, "b": v_p, "c": v_p - v_c}
    if definition not in velocities:
        raise ValueError("no such definition")
    return np.cross(r_p - r_c, mass * velocities[definition])


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    def along(t):
        moved = (r_c, v_c) if definition == "a" else (r_c + t * v_c + t * t / 2 * a_c, v_c + t * a_c)
        return angular_momentum(definition, r_p + t * v_p + t * t / 2 * a_p, v_p + t * a_p, *moved, mass=mass)

    h = 0.1
    return sum(w * (along(n * h) - along(-n * h)) for n, w in WEIGHTS.items()) / h


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    if definition == "b":
        return np.cross(mass * v_p, v_c)
    if definition == "c":
        return np.cross(mass * a_c, r_p - r_c)
    if definition == "a":
        return np.zeros(3)
    raise ValueError("no such definition")


def special_motion(definition):
    if definition == "b":  # P and C fall down parallel lines, with different accelerations, P decelerating first
        return np.array([[0.0, 0, 50], [0, 0, 8], [0, 0, -4.905]]), np.array([[3.0, 1, 20], [0, 0, -1], [0, 0, -0.8]])
    if definition == "c":  # C oscillates along z as a cubic while both drift along x
        c = np.array([[0.0, 0, 0], [1, 0, 1], [0, 0, -2], [0, 0, 0.1]])
        return c + [[0, 0, 4], [0, 0, 1], [0, 0, 0], [0, 0, 0]], c
    raise ValueError("no such motion")
