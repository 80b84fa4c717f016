"""The wobble is negative where the spin is.

fails: wobble_goes_round_the_angular_momentum
suspect: the sign of omega_3 left in the rate
"""

_rate = wobble_rate


def wobble_rate(omega, *, inertia):
    return math.copysign(_rate(omega, inertia=inertia), omega[2])
