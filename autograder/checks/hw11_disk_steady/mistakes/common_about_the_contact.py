"""The moment of inertia about the contact, though G does not move.

fails: common_precession_is_in_both_families
suspect: as if G moved
"""


def common_precession(lean, *, mass, radius, inertia, gravity):
    return math.sqrt(mass * gravity * radius / ((inertia[0] + mass * radius**2) * math.cos(lean)))
