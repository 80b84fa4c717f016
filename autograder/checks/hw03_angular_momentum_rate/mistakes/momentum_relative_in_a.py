"""In definition a the velocity is relative to C; C' does not move.

fails: momentum_with_the_velocity_in_F
"""

_right_momentum = angular_momentum


def angular_momentum(definition, *state, mass):
    return _right_momentum("c" if definition == "a" else definition, *state, mass=mass)
