"""Half of the term with v^2 is missing: the second derivative of c x^2 is 2 c.

fails: force_has_the_right_size
"""


def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    return mass * (gravity + curvature * v**2) / (1 + slope**2) * np.array([-slope, 1.0])
