"""y'' without 2 c v^2.

fails: force_has_the_right_size
suspect: y'' without the term 2 c v^2
"""


def constraint_force(x, v, *, mass, curvature, gravity):
    a = acceleration_newton(x, v, curvature=curvature, gravity=gravity)
    return mass * np.array([a, 2 * curvature * x * a + gravity])
