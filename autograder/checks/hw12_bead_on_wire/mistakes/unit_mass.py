"""The force on a bead of one kilogram.

fails: force_has_the_right_size
suspect: a mass of 1 for the one given
"""

def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    upward = (gravity + 2 * curvature * v**2) / (1 + slope**2)
    return np.array([-slope * upward, upward])
