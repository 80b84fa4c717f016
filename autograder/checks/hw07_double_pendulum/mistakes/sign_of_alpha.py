"""The angular accelerations have the wrong sign: M^-1 (f + g) stands where -M^-1 (f + g) belongs.

fails: accelerations_obey_the_equations
"""

_right_alpha = angular_acceleration


def angular_acceleration(theta, omega, **known):
    return -_right_alpha(theta, omega, **known)
