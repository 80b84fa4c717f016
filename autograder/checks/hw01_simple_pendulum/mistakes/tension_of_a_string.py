"""The tension of a string, which cannot push.

fails: newton_gives_the_tension
suspect: a rod can push
"""

_right_balance = linear_momentum_balance


def linear_momentum_balance(theta, omega, **pendulum):
    alpha, tension = _right_balance(theta, omega, **pendulum)
    return alpha, max(tension, 0.0)
