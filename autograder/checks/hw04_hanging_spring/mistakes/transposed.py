"""The rows and columns are exchanged: solve_ivp returns (6, n).

fails: simulate_moves_as_it_must, the_path_is_drawn
names: not an array of shape (12, 6)
"""

_right_simulate = simulate


def simulate(t, *start, **parameters):
    return _right_simulate(t, *start, **parameters).T


def plot_projection(ax, t, position, velocity, azimuth, elevation, **parameters):
    ax.plot(simulate(t, position, velocity, **parameters)[:3])
