"""The radius is left out of the paths.

fails: rim_paths_are_drawn
names: these are the paths for a radius of 1 m
"""

_plot = plot_rim_paths


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _plot(ax, t, R, omega, inertia=inertia, radius=1.0)
