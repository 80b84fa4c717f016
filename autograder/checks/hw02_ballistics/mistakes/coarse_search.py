"""This is the best of a thousand angles.

fails: best_angle_has_the_largest_range
names: a search stops early
"""


def best_angle(speed, **known):
    angles = np.linspace(1e-3, math.pi / 2, 1000)
    return angles[np.argmax([horizontal_range(speed, angle, **known) for angle in angles])]
