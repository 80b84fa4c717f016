"""The drag is quadratic, -c v^2; it should be linear.

fails: rates_are_newtons, simulation_follows_the_motion, both_paths_are_drawn
"""


def state_derivative(t, state, *, mass, drag, gravity):
    _, _, vx, vy = state
    fade = drag * np.hypot(vx, vy) / mass
    return np.array([vx, vy, -fade * vx, -fade * vy - gravity])


def simulate(t, speed, angle, **known):
    from scipy.integrate import solve_ivp

    start = [0, 0, speed * np.cos(angle), speed * np.sin(angle)]
    rates = lambda t, y: state_derivative(t, y, **known)
    return solve_ivp(rates, (t[0], t[-1]), start, t_eval=t, rtol=1e-9, atol=1e-9).y.T
