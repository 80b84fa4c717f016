"""The weight's potential energy has the wrong sign.

fails: energy_is_that_of_motion_spring_and_weight
"""

def energy(state, *, mass, stiffness, gravity):
    r, v = state[:3], state[3:]
    return mass * v @ v / 2 + stiffness * r @ r / 2 - mass * gravity * r[2]
