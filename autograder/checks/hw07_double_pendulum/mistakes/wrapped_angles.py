"""The angles are wrapped to -pi and pi; they should count whole turns.

fails: simulation_follows_the_equations
"""

unwrapped = simulate


def simulate(t, theta, omega, **known):
    states = unwrapped(t, theta, omega, **known)
    states[:, :2] = (states[:, :2] + math.pi) % (2 * math.pi) - math.pi
    return states
