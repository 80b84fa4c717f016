"""omega-hat R stands for R omega-hat, or omega q for q omega, but omega is in body components.

fails: attitude_follows_the_motion, rim_paths_are_drawn
"""


def simulate(t, R, omega, *, inertia):
    from scipy.integrate import solve_ivp
    from scipy.spatial.transform import Rotation

    def rates(_, y):
        spin, scalar, vector = y[:3], y[3], y[4:]
        changes = [[-spin @ vector], scalar * spin + np.cross(spin, vector)]
        return np.concatenate([euler_equations(spin, inertia=inertia), np.concatenate(changes) / 2])

    start = np.concatenate([omega, [1.0, 0.0, 0.0, 0.0]])
    y = solve_ivp(rates, (t[0], t[-1]), start, t_eval=t, method="DOP853", rtol=1e-10, atol=1e-10).y.T
    return y[:, :3], np.asarray(R) @ Rotation.from_quat(y[:, [4, 5, 6, 3]]).as_matrix()
