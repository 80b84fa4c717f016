"""The spring pushes; it should pull.

fails: derivative_is_velocity_and_force_over_mass, simulate_moves_as_it_must, the_path_is_drawn
"""

def state_derivative(t, state, *, mass, stiffness, gravity):
    r, weight = np.asarray(state[:3]), np.array([0.0, 0.0, -mass * gravity])
    return [*state[3:], *((stiffness * r + weight) / mass)]
