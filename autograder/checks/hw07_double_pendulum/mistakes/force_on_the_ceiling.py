"""The first row is the force of bar 1 on the ceiling; it should be the force on bar 1.

fails: hinge_forces_balance
"""

_right = on_the_fly


def on_the_fly(theta, omega, **known):
    alpha, forces = _right(theta, omega, **known)
    return alpha, forces * [[-1], [1]]
