"""A pendulum that starts at rest is left where it is; gravity should move it.

fails: energy_is_conserved_from_horizontal
"""

released = simulate


def simulate(t, theta, omega, **known):
    if not np.any(omega):
        return np.tile([*theta, *omega], (len(t), 1))
    return released(t, theta, omega, **known)
