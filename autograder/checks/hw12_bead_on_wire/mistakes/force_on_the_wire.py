"""The force reversed, that of the bead on the wire.

fails: force_and_weight_make_the_acceleration
"""

def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    upward = mass * (gravity + 2 * curvature * v**2) / (1 + slope**2)
    return np.array([slope * upward, -upward])
