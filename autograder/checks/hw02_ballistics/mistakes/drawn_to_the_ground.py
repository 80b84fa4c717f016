"""The curves end on the ground; the paths go on below it.

fails: both_paths_are_drawn
names: do simulate and trajectory pass
"""


def plot_comparison(ax, t, speed, angle, **known):
    for motion in (simulate, trajectory):
        x, y, _, _ = motion(t, speed, angle, **known).T
        ax.plot(x, np.maximum(y, 0), label=motion.__name__)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
