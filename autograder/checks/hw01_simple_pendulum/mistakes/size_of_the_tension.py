"""The tension has lost its sign; it should be negative where the rod pushes.

fails: newton_gives_the_tension
"""

_right_balance = linear_momentum_balance


def linear_momentum_balance(theta, omega, **pendulum):
    alpha, tension = _right_balance(theta, omega, **pendulum)
    return alpha, abs(tension)
