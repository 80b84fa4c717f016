"""The flight time lacks drag; with drag it is shorter.

fails: range_is_where_it_lands
also: The vertical motion lacks drag, which acts on both components
"""


def horizontal_range(speed, angle, **known):
    time = 2 * speed * math.sin(angle) / known["gravity"]
    return trajectory(np.array([time]), speed, angle, **known)[0, 0]
