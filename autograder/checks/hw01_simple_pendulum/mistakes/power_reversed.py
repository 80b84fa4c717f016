"""The power has the wrong sign: gravity speeds the mass up on its way down.

fails: power_gives_the_acceleration
"""

_right_balance = power_balance


def power_balance(theta, omega, **pendulum):
    alpha, power = _right_balance(theta, omega, **pendulum)
    return alpha, -power
