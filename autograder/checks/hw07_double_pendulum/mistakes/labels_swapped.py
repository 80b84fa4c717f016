"""The labels of the two axes are swapped.

fails: tip_path_is_drawn
names: the label of x stands at the axis of y
"""

_right = plot_tip_path


def plot_tip_path(ax, t, theta, omega, **known):
    _right(ax, t, theta, omega, **known)
    ax.set(xlabel="y (m)", ylabel="x (m)")
