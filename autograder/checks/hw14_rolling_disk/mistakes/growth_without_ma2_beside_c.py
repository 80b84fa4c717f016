"""In the growth rate m a^2 is missing beside C.

fails: growth_rate_is_that_of_a_small_lean
"""


def growth_rate_squared(speed, *, mass, radius, inertia, gravity):
    A, C = inertia
    return (mass * gravity * radius - C**2 / A * (speed / radius) ** 2) / (A + mass * radius**2)
