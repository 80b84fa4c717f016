"""The limit of the shape comes down as it went up.

fails: path_at_a_huge_speed_has_the_limit_shape
suspect: a path as long on its way down as up
"""


def limit_shape(angle):
    return [[0, 0], [np.cos(angle), np.sin(angle)], [2 * np.cos(angle), 0]]
