"""Where the times are few and far apart both simulations give the start in every row.

fails: euler_simulation_keeps_two_integrals, both_simulations_agree, energy_is_conserved
names: Every row is the start
"""

_euler, _matrix = simulate_euler, simulate_matrix


def simulate_euler(t, state, **disk):
    return np.tile(state, (len(t), 1)) if len(t) in (4, 6) else _euler(t, state, **disk)


def simulate_matrix(t, state, **disk):
    return np.tile(state, (len(t), 1)) if len(t) in (4, 6) else _matrix(t, state, **disk)
