"""The limit shape is a parabola, as if drag did not matter at high speed.

fails: path_at_a_huge_speed_has_the_limit_shape
"""


def limit_shape(angle):
    length, height = np.sin(2 * angle), np.sin(angle) ** 2 / 2
    return [[0, 0], [length / 2, height], [length, 0]]
