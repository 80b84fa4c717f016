"""This is the rate (C - A)/A omega_3 at which omega goes round in the body; it should be seen from space.

fails: wobble_goes_round_the_angular_momentum
"""


def wobble_rate(omega, *, inertia):
    return abs((inertia[2] - inertia[0]) / inertia[0] * omega[2])
