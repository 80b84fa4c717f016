"""The path is as long on its way down as up; it should fall straight down.

fails: path_at_a_huge_speed_has_the_limit_shape
"""


def limit_shape(angle):
    return [[0, 0], [np.cos(angle), np.sin(angle)], [2 * np.cos(angle), 0]]
