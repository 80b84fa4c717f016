"""The rate keeps the sign of omega_3; it should be positive.

fails: wobble_goes_round_the_angular_momentum
"""

_rate = wobble_rate


def wobble_rate(omega, *, inertia):
    return math.copysign(_rate(omega, inertia=inertia), omega[2])
