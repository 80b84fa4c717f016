"""The spring's force is not divided by the mass.

fails: derivative_is_velocity_and_force_over_mass, simulate_moves_as_it_must, the_path_is_drawn
"""

def state_derivative(t, state, *, mass, stiffness, gravity):
    x, y, z, vx, vy, vz = state
    return vx, vy, vz, -stiffness * x, -stiffness * y, -stiffness * z - gravity
