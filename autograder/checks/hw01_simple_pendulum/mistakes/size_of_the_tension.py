"""The weight's part of the tension without its sign: above the hinge it pushes the rod in.

fails: newton_gives_the_tension
also: the tension without its sign: where the rod pushes it is negative
"""

_right_balance = linear_momentum_balance


def linear_momentum_balance(theta, omega, **pendulum):
    alpha, tension = _right_balance(theta, omega, **pendulum)
    return alpha, abs(tension)
