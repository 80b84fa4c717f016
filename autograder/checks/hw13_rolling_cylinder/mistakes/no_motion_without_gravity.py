"""Without gravity phi_dot is kept; it should change where G is not at the centre.

fails: acceleration_level_and_without_gravity, contact_force_may_pull, simulate_keeps_the_energy
"""

_right = acceleration


def acceleration(phi, phi_dot, **cylinder):
    return _right(phi, phi_dot, **cylinder) if cylinder["gravity"] > 0 else 0.0
