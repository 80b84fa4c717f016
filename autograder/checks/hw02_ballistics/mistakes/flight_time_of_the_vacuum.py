"""The range at the flight time without drag.

fails: range_is_where_it_lands
suspect: the flight time without drag
"""


def horizontal_range(speed, angle, **known):
    time = 2 * speed * math.sin(angle) / known["gravity"]
    return trajectory(np.array([time]), speed, angle, **known)[0, 0]
