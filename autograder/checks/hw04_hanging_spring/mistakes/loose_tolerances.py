"""The simulation is accurate to four digits only.

fails: simulate_moves_as_it_must, simulate_does_not_depend_on_the_sampling, energy_stays
numerics: a relative tolerance of 1e-4
names: tighten rtol and atol
"""

def simulate(t, position, velocity, **parameters):
    from scipy.integrate import solve_ivp

    start = np.concatenate([position, velocity])
    return solve_ivp(state_derivative_of(parameters), (t[0], t[-1]), start, t_eval=t, rtol=1e-4, atol=1e-9).y.T


def state_derivative_of(parameters):
    return lambda t, state: state_derivative(t, state, **parameters)
