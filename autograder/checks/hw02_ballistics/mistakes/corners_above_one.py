"""Your top corner is at x = 1 for every angle; it is at x = cos(angle).

fails: path_at_a_huge_speed_has_the_limit_shape
"""

def limit_shape(angle):
    return np.array([[0, 0], [1, math.tan(angle)], [1, 0]])
