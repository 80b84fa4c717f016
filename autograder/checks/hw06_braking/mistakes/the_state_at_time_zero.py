"""The given state is treated as the state at t = 0, but it is the state at t[0].

fails: simulate_brakes
"""

_right = simulate


def simulate(t, state, locked, **car):
    start = (
        _right(np.array([0.0, t[0]]), state, locked, **car)[1]
        if t[0] > 0
        else _backwards(t[0], state, locked, car)
    )
    return _right(t, start, locked, **car)


def _backwards(t, state, locked, car):
    from scipy.integrate import solve_ivp

    return solve_ivp(
        lambda s, y: state_derivative(s, y, locked, **car), (0.0, t), state, rtol=1e-10, atol=1e-10
    ).y[:, -1]
