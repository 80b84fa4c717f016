"""The scales of the two axes differ, so that circles look like ellipses.

fails: rim_paths_are_drawn
names: not drawn at the same scale
"""

_right_plot = plot_rim_paths


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _right_plot(ax, t, R, omega, inertia=inertia, radius=radius)
    ax.set_aspect("auto")
