"""The weight's part of the tension has lost its sign: above the hinge it pushes the rod in.

fails: newton_gives_the_tension
"""

_right_balance = linear_momentum_balance


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    alpha, _ = _right_balance(theta, omega, mass=mass, length=length, gravity=gravity)
    return alpha, mass * (length * omega**2 + gravity * abs(math.cos(theta)))
