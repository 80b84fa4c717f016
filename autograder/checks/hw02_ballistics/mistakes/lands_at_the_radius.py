"""The landing is as far from the launch as the top corner; the particle falls straight down.

fails: path_at_a_huge_speed_has_the_limit_shape
"""


def limit_shape(angle):
    return np.array([[0, 0], [math.cos(angle), math.sin(angle)], [1, 0]])
