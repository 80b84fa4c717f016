"""v is used as the speed along the wire, but it is the rate of x.

fails: force_has_the_right_size
"""

_right = constraint_force


def constraint_force(x, v, *, mass, curvature, gravity):
    along_x = v / math.hypot(1, 2 * curvature * x)
    return _right(x, along_x, mass=mass, curvature=curvature, gravity=gravity)
