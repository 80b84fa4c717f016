"""At the bottom the wire carries the weight alone: that the bead turns there is forgotten; at rest it is asked to jump.

fails: force_has_the_right_size
names: for a bead at the bottom
"""

_right = constraint_force


def constraint_force(x, v, *, mass, curvature, gravity):
    return (0.0, mass * gravity) if x == 0 else _right(x, v, mass=mass, curvature=curvature, gravity=gravity)
