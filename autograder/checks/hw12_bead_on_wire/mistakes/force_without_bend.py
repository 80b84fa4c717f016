"""y'' has no term 2 c v^2: differentiate y = c x^2 twice.

fails: force_has_the_right_size
"""


def constraint_force(x, v, *, mass, curvature, gravity):
    a = acceleration_newton(x, v, curvature=curvature, gravity=gravity)
    return mass * np.array([a, 2 * curvature * x * a + gravity])
