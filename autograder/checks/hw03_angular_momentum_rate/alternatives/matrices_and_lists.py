"""Right: skew matrices, lists as results; a resting P for b, an accelerated C on the way to P for c."""

import numpy as np


def skew(v):
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def moment(r_p, a_p, r_c, *, mass):
    return (mass * skew(np.subtract(r_p, r_c)) @ a_p).tolist()


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    arm = skew(np.subtract(r_p, r_c))
    return list({"a": mass * arm @ v_p, "b": mass * arm @ v_p, "c": mass * arm @ np.subtract(v_p, v_c)}[_known(definition)])


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    M = np.array(moment(r_p, a_p, r_c, mass=mass))
    return tuple(M + discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass))


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    return {
        "a": [0, 0, 0],
        "b": mass * skew(v_p) @ v_c,
        "c": mass * skew(a_c) @ np.subtract(r_p, r_c),
    }[_known(definition)]


def special_motion(definition):
    if definition == "b":
        return [[5, 0, 1]], [[0, 0, 0], [0, 2, 0], [0, 0, 3], [1, 0, 0]]
    if definition == "c":  # on the line from P, which moves uniformly: C = P + (2 - t^2) e, so a_C = -2 e
        return [[1e3, 0, 0], [0, 7, 0]], [[1e3, 0, 2], [0, 7, 0], [0, 0, -1]]
    raise ValueError("b or c")


def _known(definition):
    if definition not in ("a", "b", "c"):
        raise ValueError("a, b or c")
    return definition
