"""At the bottom the force is only the weight; it should also turn the bead.

fails: force_has_the_right_size
"""

_right = constraint_force


def constraint_force(x, v, *, mass, curvature, gravity):
    return np.array([0.0, mass * gravity]) if x == 0 else _right(x, v, mass=mass, curvature=curvature, gravity=gravity)
