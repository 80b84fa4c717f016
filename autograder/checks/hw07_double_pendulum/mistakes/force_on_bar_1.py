"""The second row is the force of bar 2 on bar 1; it should be the force on bar 2.

fails: hinge_forces_balance
"""

on_bar_2 = on_the_fly


def on_the_fly(theta, omega, **known):
    alpha, forces = on_bar_2(theta, omega, **known)
    return alpha, [forces[0], -forces[1]]
