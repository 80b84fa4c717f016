"""The force turns the velocity alone: right without gravity.

fails: force_keeps_the_particle_on_the_circle
suspect: without the weight's share
"""

def constraint_force(state, *, mass, length, gravity):
    x, y, vx, vy = state
    return -mass * (vx**2 + vy**2) / length**2 * np.array([x, y])
