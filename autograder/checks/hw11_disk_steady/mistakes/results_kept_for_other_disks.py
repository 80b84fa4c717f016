"""Results are kept by lean and precession, or track, whatever the disk.

fails: rolling_spin_balances_the_moments, rolling_track_has_the_contact_at_rest, rolling_precession_balances_the_moments, sliding_spin_balances_the_moments, common_precession_is_in_both_families, contact_force_moves_the_centre, moment_residual_is_moment_minus_rate, settling_energy_adds_up
names: Is a result kept?
"""


def _kept(function):
    results = {}

    def wrapped(*motion, **disk):
        if motion not in results:
            results[motion] = function(*motion, **disk)
        return results[motion]

    return wrapped


rolling_spin, rolling_precession, sliding_spin = map(_kept, (rolling_spin, rolling_precession, sliding_spin))
common_precession, settling_energy = map(_kept, (common_precession, settling_energy))
moment_residual, contact_force = map(_kept, (moment_residual, contact_force))
