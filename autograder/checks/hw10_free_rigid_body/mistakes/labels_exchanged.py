"""The labels of the two axes are exchanged.

fails: rim_paths_are_drawn
names: the label of y stands at the axis of z
"""

_right_plot = plot_rim_paths


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _right_plot(ax, t, R, omega, inertia=inertia, radius=radius)
    ax.set(xlabel="z (m)", ylabel="y (m)")
