"""The sliding track has the cosine of the lean.

fails: sliding_track_is_around_the_resting_centre
suspect: the cosine of the lean
"""


def sliding_track_radius(lean, *, radius):
    return radius * math.cos(lean)
