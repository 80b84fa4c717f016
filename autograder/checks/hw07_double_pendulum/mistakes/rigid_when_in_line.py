"""Bars in line that turn alike are given one angular acceleration; they should have two.

fails: accelerations_obey_the_equations
"""

accelerated = angular_acceleration


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    alpha = accelerated(theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    if theta[0] == theta[1] and omega[0] == omega[1]:
        return np.full(2, alpha[0])
    return alpha
