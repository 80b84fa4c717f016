"""The force has the length where its square belongs, which is right only for 1 m.

fails: force_keeps_the_particle_on_the_circle
"""

def constraint_force(state, *, mass, length, gravity):
    x, y, vx, vy = state
    return mass * (gravity * y - vx**2 - vy**2) / length * np.array([x, y])
