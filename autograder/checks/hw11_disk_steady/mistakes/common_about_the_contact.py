"""The common precession has A + m a^2 where A belongs, as if G moved.

fails: common_precession_is_in_both_families
"""


def common_precession(lean, *, mass, radius, inertia, gravity):
    return math.sqrt(mass * gravity * radius / ((inertia[0] + mass * radius**2) * math.cos(lean)))
