"""The corners belong to a path over x = 1, whatever the angle.

fails: path_at_a_huge_speed_has_the_limit_shape
"""

def limit_shape(angle):
    return np.array([[0, 0], [1, math.tan(angle)], [1, 0]])
