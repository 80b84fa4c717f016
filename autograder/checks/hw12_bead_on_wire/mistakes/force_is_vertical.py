"""The force points straight up, not along the normal.

fails: force_and_weight_make_the_acceleration
"""

def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    return np.array([0.0, mass * (gravity + 2 * curvature * v**2) / math.sqrt(1 + slope**2)])
