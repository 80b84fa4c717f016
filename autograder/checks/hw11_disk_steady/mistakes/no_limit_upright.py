"""The common precession is a quotient that is 0/0 upright.

fails: common_precession_has_a_limit_upright
names: returned NaN or infinity for an upright disk
"""


def common_precession(lean, *, mass, radius, inertia, gravity):
    weight = mass * gravity * radius * math.sin(lean)
    return math.sqrt(weight / (inertia[0] * math.sin(lean) * math.cos(lean)))
