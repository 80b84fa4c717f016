"""The scales of x and y differ; they should be equal.

fails: both_paths_are_drawn
names: not drawn at the same scale
"""


def plot_comparison(ax, t, speed, angle, **known):
    for motion in (simulate, trajectory):
        ax.plot(*motion(t - t[0], speed, angle, **known)[:, :2].T)
    ax.set(xlabel="x (m)", ylabel="y (m)")
