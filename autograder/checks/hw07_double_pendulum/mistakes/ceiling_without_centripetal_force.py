"""The force at the ceiling leaves out the centripetal acceleration of bar 1's own mass centre.

fails: hinge_forces_balance
"""

_right = on_the_fly


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    alpha, forces = _right(theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    outwards = np.array([math.sin(theta[0]), -math.cos(theta[0])])
    return alpha, forces + [masses[0] * lengths[0] / 2 * omega[0] ** 2 * outwards, np.zeros(2)]
