"""At the bottom the tension is only the weight, as if the pendulum did not move.

fails: newton_gives_the_tension
"""

_right_balance = linear_momentum_balance


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    if theta == 0:
        return 0.0, mass * gravity
    return _right_balance(theta, omega, mass=mass, length=length, gravity=gravity)
