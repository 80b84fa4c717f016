"""The paths start as if R were the identity.

fails: rim_paths_are_drawn
names: the paths start with the identity
"""

_plot = plot_rim_paths


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _plot(ax, t, np.eye(3), omega, inertia=inertia, radius=radius)
