"""The radius has the cosine of the lean; it should have the sine.

fails: sliding_track_is_around_the_resting_centre
"""


def sliding_track_radius(lean, *, radius):
    return radius * math.cos(lean)
