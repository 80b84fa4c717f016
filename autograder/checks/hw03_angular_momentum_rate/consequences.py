"""Right functions of hw03 in terms of others, as students write them; diagnosis tries mistakes in these, too."""

import numpy as np


def moment(r_p, a_p, r_c, *, mass):
    """Compute the components of a product."""
    return _cross(r_p - r_c, mass * a_p)


def angular_momentum(definition, r_p, v_p, r_c, v_c, *, mass):
    """Compute the components of a product."""
    return _cross(r_p - r_c, mass * (v_p - v_c if definition == "c" else v_p))


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    """Difference the angular momentum along parabolas, a cubic in time; the point C' of definition a stays."""

    def along(t):
        moved = (r_c, v_c) if definition == "a" else (r_c + t * v_c + t**2 / 2 * a_c, v_c + t * a_c)
        return angular_momentum(definition, r_p + t * v_p + t**2 / 2 * a_p, v_p + t * a_p, *moved, mass=mass)

    return (8 * (along(1.0) - along(-1.0)) - (along(2.0) - along(-2.0))) / 12


def _cross(a, b):
    return np.array([a[j] * b[k] - a[k] * b[j] for j, k in ((1, 2), (2, 0), (0, 1))])
