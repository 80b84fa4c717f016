"""The spring has a rest length of 1 m; it should be 0.

fails: derivative_is_velocity_and_force_over_mass, simulate_moves_as_it_must, the_path_is_drawn
"""

def state_derivative(t, state, *, mass, stiffness, gravity):
    x, y, z, vx, vy, vz = state
    stretch = stiffness / mass * (1 - 1 / np.sqrt(x * x + y * y + z * z))
    return vx, vy, vz, -stretch * x, -stretch * y, -stretch * z - gravity
