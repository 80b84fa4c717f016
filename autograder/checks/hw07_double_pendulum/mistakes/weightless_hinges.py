"""The hinge forces leave out the weights.

fails: hinge_forces_balance
"""

with_weights = on_the_fly


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    alpha, forces = with_weights(theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    return alpha, forces - [[0, sum(masses) * gravity], [0, masses[1] * gravity]]
