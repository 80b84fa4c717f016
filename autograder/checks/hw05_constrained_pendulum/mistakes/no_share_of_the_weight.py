"""The radial force lacks the weight's share.

fails: force_keeps_the_particle_on_the_circle
"""

def constraint_force(state, *, mass, length, gravity):
    x, y, vx, vy = state
    return -mass * (vx**2 + vy**2) / length**2 * np.array([x, y])
