"""The last tenth of the paths is not drawn.

fails: rim_paths_are_drawn
names: ends too early
"""

_right_plot = plot_rim_paths


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _right_plot(ax, t[: len(t) * 9 // 10], R, omega, inertia=inertia, radius=radius)
