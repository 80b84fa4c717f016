"""The angles after the start are wrapped to -pi to pi; they should count whole turns.

fails: simulation_follows_the_equations
names: never wrap angles
"""

unwrapped = simulate


def simulate(t, theta, omega, **known):
    states = unwrapped(t, theta, omega, **known)
    states[1:, :2] = (states[1:, :2] + math.pi) % (2 * math.pi) - math.pi
    return states
