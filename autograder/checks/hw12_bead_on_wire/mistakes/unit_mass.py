"""The force lacks the mass.

fails: force_has_the_right_size
"""

def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    upward = (gravity + 2 * curvature * v**2) / (1 + slope**2)
    return np.array([-slope * upward, upward])
