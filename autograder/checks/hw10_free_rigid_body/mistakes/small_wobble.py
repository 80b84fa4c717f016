"""The wobble rate of spin very near the axis.

fails: wobble_goes_round_the_angular_momentum
suspect: C/A omega_3
"""


def wobble_rate(omega, *, inertia):
    return inertia[2] / inertia[0] * abs(omega[2])
