"""The radius of curvature is 1/(2 c) everywhere, which is right only at the bottom.

fails: force_has_the_right_size
"""


def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    long = np.hypot(1, slope)
    size = mass * (gravity / long + (long * v) ** 2 * 2 * curvature)
    return size * np.array([-slope, 1.0]) / long
