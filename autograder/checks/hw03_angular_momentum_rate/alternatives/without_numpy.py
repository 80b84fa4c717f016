"""Show that plain Python passes: the permutation symbol, rates by complex steps, lists."""

EVEN = (0, 1, 2), (1, 2, 0), (2, 0, 1)
STEP = 1e-30  # s; a complex step has no difference to round


def cross(a, b):
    return [a[j] * b[k] - a[k] * b[j] for _, j, k in EVEN]


def along(r, v, a, t):
    return [x + u * t + w * t * t / 2 for x, u, w in zip(r, v, a, strict=True)]


def minus(a, b):
    return [x - y for x, y in zip(a, b, strict=True)]


def moment(r_p, a_p, r_c, *, mass):
    return cross(minus(r_p, r_c), [mass * x for x in a_p])


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    share = {"a": 0, "b": 0, "c": 1}.get(definition)
    if share is None:
        raise ValueError("there are the definitions a, b and c")
    return [mass * x for x in cross(minus(r_p, r_c), [u - share * w for u, w in zip(v_p, v_c, strict=True)])]


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    t = 1j * STEP
    here = r_c if definition == "a" else along(r_c, v_c, a_c, t)  # C' stays where C is now
    velocities = along(v_p, a_p, [0, 0, 0], t), along(v_c, a_c, [0, 0, 0], t)
    later = angular_momentum(
        definition, along(r_p, v_p, a_p, t), velocities[0], here, velocities[1], mass=mass
    )
    return [complex(x).imag / STEP for x in later]


def discrepancy(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    if definition == "a":
        return [0.0, 0.0, 0.0]
    return minus(rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, mass=mass), moment(r_p, a_p, r_c, mass=mass))


def special_motion(definition):
    if definition == "b":  # P runs beside C, which speeds up along a parallel
        return [[0, 0, 2], [3, 0, 0]], [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
    if definition == "c":  # C speeds up along the line of sight to P, which is ahead on the same line
        return [[5, 0, 0], [0, 1, 0]], [[0, 0, 0], [0, 1, 0], [1, 0, 0]]
    raise ValueError("there are special motions for b and c")
