"""Divided by l in place of l^2: right for a rod of one metre.

fails: force_keeps_the_particle_on_the_circle
suspect: length of 1 m
"""

def constraint_force(state, *, mass, length, gravity):
    x, y, vx, vy = state
    return mass * (gravity * y - vx**2 - vy**2) / length * np.array([x, y])
