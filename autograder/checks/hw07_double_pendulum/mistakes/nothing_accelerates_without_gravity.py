"""Without gravity the bars are treated as free.

fails: accelerations_obey_the_equations
names: the bars still act on each other
also: the angular velocities stay as they are
"""

_right_alpha = angular_acceleration


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    if gravity == 0:
        return np.zeros(2)
    return _right_alpha(theta, omega, masses=masses, lengths=lengths, gravity=gravity)
