"""A and C are swapped: A is about a diameter, C about the axle.

fails: rolling_spin_balances_the_moments, rolling_track_has_the_contact_at_rest, rolling_precession_balances_the_moments, sliding_spin_balances_the_moments, common_precession_is_in_both_families, moment_residual_is_moment_minus_rate
"""


def _swapped(right):
    return lambda *args, inertia, **disk: right(*args, inertia=inertia[::-1], **disk)


_residual = moment_residual
rolling_precession = _swapped(rolling_precession)
rolling_spin = _swapped(rolling_spin)
rolling_track_radius = lambda lean, p, *, radius, **disk: radius * (math.sin(lean) + rolling_spin(lean, p, radius=radius, **disk) / p)
sliding_spin = _swapped(sliding_spin)
common_precession = _swapped(common_precession)
moment_residual = _swapped(moment_residual)
