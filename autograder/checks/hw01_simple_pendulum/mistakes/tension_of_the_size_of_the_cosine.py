"""The weight pulls at the rod above the hinge, too.

fails: newton_gives_the_tension
suspect: without its sign
"""

_right_balance = linear_momentum_balance


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    alpha, _ = _right_balance(theta, omega, mass=mass, length=length, gravity=gravity)
    return alpha, mass * (length * omega**2 + gravity * abs(math.cos(theta)))
