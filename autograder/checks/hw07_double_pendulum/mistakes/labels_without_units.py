"""The plot's labels have no unit.

fails: tip_path_is_drawn
names: not labelled with their unit
"""

labelled = plot_tip_path


def plot_tip_path(ax, t, theta, omega, **known):
    labelled(ax, t, theta, omega, **known)
    ax.set(xlabel="x", ylabel="y")
