"""The plot shows the heights over the time; it should show y over x.

fails: both_paths_are_drawn
names: not over the time
"""


def plot_comparison(ax, t, speed, angle, **known):
    ax.plot(t, simulate(t, speed, angle, **known)[:, 1], label="numerical")
    ax.plot(t, trajectory(t, speed, angle, **known)[:, 1], label="closed form")
    ax.set(xlabel="t (s)", ylabel="y (m)")
