"""The force on a bead at rest, whatever its speed.

fails: force_has_the_right_size
suspect: the force on a bead at rest
"""

def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    upward = mass * (gravity) / (1 + slope**2)
    return np.array([-slope * upward, upward])
