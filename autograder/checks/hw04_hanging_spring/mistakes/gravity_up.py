"""Gravity pulls up; it should pull down.

fails: derivative_is_velocity_and_force_over_mass, simulate_moves_as_it_must, the_path_is_drawn
"""

def state_derivative(t, state, *, mass, stiffness, gravity):
    x, y, z, vx, vy, vz = state
    k = stiffness / mass
    return vx, vy, vz, -k * x, -k * y, -k * z + gravity
