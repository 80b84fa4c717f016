"""The lean has lost its sign.

fails: sliding_track_is_around_the_resting_centre
"""


def sliding_track_radius(lean, *, radius):
    return radius * abs(math.sin(lean))
