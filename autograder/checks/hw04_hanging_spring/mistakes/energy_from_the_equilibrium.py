"""The energy is zero at the equilibrium; it should be zero at the origin.

fails: energy_is_that_of_motion_spring_and_weight
"""

def energy(state, *, mass, stiffness, gravity):
    r, v = state[:3] + [0, 0, mass * gravity / stiffness], state[3:]
    return mass * v @ v / 2 + stiffness * r @ r / 2
