"""The radius of curvature at the bottom, 1/(2 c), taken everywhere.

fails: force_has_the_right_size
"""


def constraint_force(x, v, *, mass, curvature, gravity):
    slope = 2 * curvature * x
    long = np.hypot(1, slope)
    size = mass * (gravity / long + (long * v) ** 2 * 2 * curvature)
    return size * np.array([-slope, 1.0]) / long
