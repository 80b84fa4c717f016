"""The rate is C/A omega_3, which holds only for spin very near the axis.

fails: wobble_goes_round_the_angular_momentum
"""


def wobble_rate(omega, *, inertia):
    return inertia[2] / inertia[0] * abs(omega[2])
