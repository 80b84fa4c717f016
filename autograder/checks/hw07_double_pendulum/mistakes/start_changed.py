"""The given start is advanced in place; work on a copy.

fails: simulation_follows_the_equations, tip_path_is_drawn
names: simulate changes the arrays
"""

unharmed = simulate


def simulate(t, theta, omega, **known):
    states = unharmed(t, theta, omega, **known)
    theta[:], omega[:] = states[-1, :2], states[-1, 2:]
    return states
