"""The flight time without drag, or drag on the horizontal component alone.

fails: range_is_where_it_lands
"""


def horizontal_range(speed, angle, **known):
    time = 2 * speed * math.sin(angle) / known["gravity"]
    return trajectory(np.array([time]), speed, angle, **known)[0, 0]
