"""The paths belong to a flat disk, C = 2 A = 2 B, whatever the inertia.

fails: rim_paths_are_drawn
names: Does simulate pass and get the inertia
"""

_right_plot = plot_rim_paths


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _right_plot(ax, t, R, omega, inertia=np.array([1.0, 1.0, 2.0]), radius=radius)
