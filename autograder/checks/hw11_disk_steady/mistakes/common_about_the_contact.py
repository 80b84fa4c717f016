"""A + m a^2 taken for A, as if G moved.

fails: common_precession_is_in_both_families
"""


def common_precession(lean, *, mass, radius, inertia, gravity):
    return math.sqrt(mass * gravity * radius / ((inertia[0] + mass * radius**2) * math.cos(lean)))
