"""You land at x = 1; the particle falls straight down from its top corner, at x = cos(angle).

fails: path_at_a_huge_speed_has_the_limit_shape
"""


def limit_shape(angle):
    return np.array([[0, 0], [math.cos(angle), math.sin(angle)], [1, 0]])
