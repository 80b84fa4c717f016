"""This is m a, the sum of all forces; the weight should be taken off.

fails: force_has_the_right_size
"""


def constraint_force(x, v, *, mass, curvature, gravity):
    a = acceleration_newton(x, v, curvature=curvature, gravity=gravity)
    return mass * np.array([a, 2 * curvature * (v**2 + x * a)])
