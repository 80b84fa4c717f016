"""A disk at rest is given no rates and no energy, and only its weight as contact force.

fails: euler_equations_hold, matrix_equations_hold, multiplier_equations_hold, euler_simulation_follows_the_motion, matrix_simulation_follows_the_motion, energy_is_kinetic_and_potential, contact_force_moves_the_centre, steady_residual_is_the_tilt_acceleration
also: A disk without tilt rate and roll rate is treated as at rest
"""

_rates = euler_state_derivative, matrix_state_derivative, multiplier_state_derivative
_energy, _force, _residual = energy, contact_force, steady_residual


def euler_state_derivative(t, state, **disk):
    return np.asarray(_rates[0](t, state, **disk)) * bool(np.any(state[5:]))


def matrix_state_derivative(t, state, **disk):
    return np.asarray(_rates[1](t, state, **disk)) * bool(np.any(state[12:]))


def multiplier_state_derivative(t, state, **disk):
    return np.asarray(_rates[2](t, state, **disk)) * bool(np.any(state[12:]))


def energy(state, **disk):
    return _energy(state, **disk) * bool(np.any(state[5:]))


def contact_force(state, **disk):
    weight = disk["mass"] * disk["gravity"]
    return _force(state, **disk) if np.any(state[5:]) else np.array([0.0, 0.0, weight])


def steady_residual(lean, precession, spin, **disk):
    return _residual(lean, precession, spin, **disk) * bool(precession)
