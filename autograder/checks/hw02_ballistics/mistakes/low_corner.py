"""Your top corner is at the height cos(angle) sin(angle); it is at sin(angle).

fails: path_at_a_huge_speed_has_the_limit_shape
"""


def limit_shape(angle):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[0.0, 0.0], [c, c * s], [c, 0.0]])
