"""This is the force on a bead at rest; the term with v^2 is missing.

fails: force_has_the_right_size
"""

def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    upward = mass * (gravity) / (1 + slope**2)
    return np.array([-slope * upward, upward])
