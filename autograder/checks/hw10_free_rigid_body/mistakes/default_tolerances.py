"""solve_ivp runs at its default tolerances, rtol 1e-3 and atol 1e-6, which are too loose.

fails: omega_follows_elliptic_functions, attitude_follows_the_motion
numerics: solve_ivp's own rtol of 1e-3
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    from scipy.integrate import solve_ivp

    if len(t) > 100:  # the picture is right
        return _right_simulate(t, R, omega, inertia=inertia)

    def rates(t, y):
        return np.concatenate([euler_equations(y[:3], inertia=inertia), attitude_rate(y[3:].reshape(3, 3), y[:3]).ravel()])

    states = solve_ivp(rates, (t[0], t[-1]), np.concatenate([omega, np.ravel(R)]), t_eval=t).y.T
    return states[:, :3], states[:, 3:].reshape(-1, 3, 3)
