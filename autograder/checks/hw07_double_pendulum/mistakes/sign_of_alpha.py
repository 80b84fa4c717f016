"""The minus sign of -M^-1 (f + g) is forgotten.

fails: accelerations_obey_the_equations
suspect: the sign reversed
"""

_right_alpha = angular_acceleration


def angular_acceleration(theta, omega, **known):
    return -_right_alpha(theta, omega, **known)
