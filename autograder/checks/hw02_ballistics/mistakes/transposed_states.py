"""The rows and columns are exchanged: solve_ivp returns (4, n).

fails: simulation_follows_the_motion
names: not an array of shape (30, 4)
"""


def simulate(t, speed, angle, **known):
    return trajectory(t - t[0], speed, angle, **known).T


def plot_comparison(ax, t, speed, angle, **known):
    x, y, _, _ = trajectory(t - t[0], speed, angle, **known).T
    ax.plot(x, y)
    ax.plot(x, y)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
