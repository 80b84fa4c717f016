"""The size of the force in the rod, whether it pulls or pushes.

fails: newton_gives_the_tension
suspect: the tension without its sign
"""

_right_balance = linear_momentum_balance


def linear_momentum_balance(theta, omega, **pendulum):
    alpha, tension = _right_balance(theta, omega, **pendulum)
    return alpha, abs(tension)
