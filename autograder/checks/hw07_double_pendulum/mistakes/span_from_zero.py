"""The given state is treated as the state at t = 0, but it is the state at t[0].

fails: simulation_follows_the_equations, tip_path_is_drawn
"""

from_the_first = simulate


def simulate(t, theta, omega, **known):
    if t[0] < 0:
        raise ValueError("Values in `t_eval` are not within `t_span`.")
    if t[0] == 0:
        return from_the_first(t, theta, omega, **known)
    return from_the_first(np.append(0.0, t), theta, omega, **known)[1:]
