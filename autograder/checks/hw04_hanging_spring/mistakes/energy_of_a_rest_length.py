"""The energy has a spring with a rest length of 1 m; its rest length is 0.

fails: energy_is_that_of_motion_spring_and_weight
"""

def energy(state, *, mass, stiffness, gravity):
    r, v = state[:3], state[3:]
    return mass * v @ v / 2 + stiffness * (np.sqrt(r @ r) - 1) ** 2 / 2 + mass * gravity * r[2]
