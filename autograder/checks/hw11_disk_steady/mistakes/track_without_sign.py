"""The sliding track is a distance, without its sign.

fails: sliding_track_is_around_the_resting_centre
suspect: the lean taken without its sign
"""


def sliding_track_radius(lean, *, radius):
    return radius * abs(math.sin(lean))
