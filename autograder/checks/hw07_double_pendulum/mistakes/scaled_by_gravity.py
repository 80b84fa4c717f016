"""The time is scaled by sqrt(l/g), which is infinite without gravity.

fails: momentum_is_conserved_without_gravity
names: ValueError for a pendulum without gravity
"""

unscaled = simulate


def simulate(t, theta, omega, *, masses, lengths, gravity):
    unit = np.sqrt(lengths[0] / gravity)
    scaled = {"masses": masses, "lengths": lengths, "gravity": lengths[0]}
    states = unscaled(t / unit, theta, omega * unit, **scaled)
    return states / [1, 1, unit, unit]
