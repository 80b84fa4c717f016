"""Row i is the state at t[i+1]: the start is missing.

fails: simulate_moves_as_it_must
names: row i is the state at t[i+1]
"""

_right_simulate = simulate


def simulate(t, *start, **parameters):
    states = _right_simulate(t, *start, **parameters)
    return np.vstack([states[1:], states[-1:]])


def plot_projection(ax, t, position, velocity, azimuth, elevation, **parameters):
    ax.plot(*project(_right_simulate(t, position, velocity, **parameters)[:, :3], azimuth, elevation).T)
    ax.set(xlabel="right (m)", ylabel="up (m)", aspect="equal")
