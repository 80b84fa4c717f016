"""You take the size of cos(theta); above the hinge it is negative, and the weight compresses the rod.

fails: newton_gives_the_tension
"""

_right_balance = linear_momentum_balance


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    alpha, _ = _right_balance(theta, omega, mass=mass, length=length, gravity=gravity)
    return alpha, mass * (length * omega**2 + gravity * abs(math.cos(theta)))
