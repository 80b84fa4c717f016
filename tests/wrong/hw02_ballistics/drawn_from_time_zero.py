"""The picture's closed form is asked for the times themselves, as if it were launched at t = 0.

fails: both_paths_are_drawn
names: the launch is at t[0]
"""


def plot_comparison(ax, t, speed, angle, **known):
    for motion in (simulate, trajectory):
        ax.plot(*motion(t, speed, angle, **known)[:, :2].T)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
