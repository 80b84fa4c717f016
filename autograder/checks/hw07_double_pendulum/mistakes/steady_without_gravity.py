"""Without gravity the angular velocities stay as they are; the bars still act on each other.

fails: momentum_is_conserved_without_gravity
"""

_right = simulate


def simulate(t, theta, omega, *, masses, lengths, gravity):
    if gravity == 0:
        turned = theta + np.outer(t - t[0], omega)
        return np.hstack([turned, np.tile(omega, (len(t), 1))])
    return _right(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity)
