"""The sine of the slope is taken out as a factor, which fails on level ground.

fails: acceleration_level_and_without_gravity, contact_force_may_pull, simulate_needs_no_dense_times, simulate_rocks_at_the_linear_frequency, simulate_keeps_the_energy
names: ZeroDivisionError for level ground
"""

_right = acceleration


def acceleration(phi, phi_dot, **cylinder):
    s = math.sin(cylinder["slope"])
    return s * (_right(phi, phi_dot, **cylinder) / s)
