"""The tension is cut off at zero, as in a string; a rod can push.

fails: newton_gives_the_tension
"""

_right_balance = linear_momentum_balance


def linear_momentum_balance(theta, omega, **pendulum):
    alpha, tension = _right_balance(theta, omega, **pendulum)
    return alpha, max(tension, 0.0)
