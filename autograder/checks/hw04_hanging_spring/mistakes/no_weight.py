"""The weight is left out: the equilibrium is at the origin.

fails: derivative_is_velocity_and_force_over_mass, simulate_moves_as_it_must, the_path_is_drawn
"""

def state_derivative(t, state, *, mass, stiffness, gravity):
    k = stiffness / mass
    return np.concatenate([state[3:], np.multiply(state[:3], -k)])
