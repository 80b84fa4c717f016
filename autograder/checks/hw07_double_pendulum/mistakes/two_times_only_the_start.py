"""With two times the motion is not integrated; both rows are the start.

fails: simulation_follows_the_equations
names: Every row is the start
"""

integrated = simulate


def simulate(t, theta, omega, **known):
    states = integrated(t, theta, omega, **known)
    return states[[0, 0]] if len(t) == 2 else states
