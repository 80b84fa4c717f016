"""The lean is treated as degrees; it is in radians.

fails: common_precession_is_in_both_families
"""


def common_precession(lean, *, mass, radius, inertia, gravity):
    return math.sqrt(mass * gravity * radius / (inertia[0] * math.cos(math.radians(lean))))
