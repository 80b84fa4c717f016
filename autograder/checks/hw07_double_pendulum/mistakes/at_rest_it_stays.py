"""A pendulum at rest is taken to be in equilibrium.

fails: energy_is_conserved_from_horizontal
names: the bars do not move
"""

released = simulate


def simulate(t, theta, omega, **known):
    if not np.any(omega):
        return np.tile([*theta, *omega], (len(t), 1))
    return released(t, theta, omega, **known)
