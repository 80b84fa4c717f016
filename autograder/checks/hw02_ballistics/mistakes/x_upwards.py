"""The plot has x upwards and y to the right; it should be the other way round.

fails: both_paths_are_drawn
names: x and y are swapped
"""


def plot_comparison(ax, t, speed, angle, **known):
    for motion in (simulate, trajectory):
        x, y, _, _ = motion(t, speed, angle, **known).T
        ax.plot(y, x, label=motion.__name__)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
