"""The lean is taken for degrees.

fails: common_precession_is_in_both_families
suspect: the lean taken for degrees
"""


def common_precession(lean, *, mass, radius, inertia, gravity):
    return math.sqrt(mass * gravity * radius / (inertia[0] * math.cos(math.radians(lean))))
