"""The weight has the wrong sign; it should be F = m a + m g j.

fails: force_has_the_right_size
"""


def constraint_force(x, v, *, mass, curvature, gravity):
    a = acceleration_newton(x, v, curvature=curvature, gravity=gravity)
    return mass * np.array([a, 2 * curvature * (v**2 + x * a) - gravity])
