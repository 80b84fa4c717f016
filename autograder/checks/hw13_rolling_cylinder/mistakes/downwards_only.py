"""A ramp upwards counts as a ramp downwards.

fails: acceleration_balances_momentum_about_G, naive_acceleration_is_the_moment_over_the_inertia, contact_force_accelerates_G, simulate_needs_no_dense_times
"""

_right, _naive = acceleration, naive_contact_acceleration


def acceleration(phi, phi_dot, *, slope, **cylinder):
    return _right(phi, phi_dot, slope=abs(slope), **cylinder)


def naive_contact_acceleration(phi, *, slope, **cylinder):
    return _naive(phi, slope=abs(slope), **cylinder)
