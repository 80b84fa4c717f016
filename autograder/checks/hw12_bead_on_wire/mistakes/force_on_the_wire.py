"""The force has the wrong sign: this one acts on the wire, not on the bead.

fails: force_and_weight_make_the_acceleration
"""

def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    upward = mass * (gravity + 2 * curvature * v**2) / (1 + slope**2)
    return np.array([slope * upward, -upward])
