"""The numerical path is drawn twice.

fails: both_paths_are_drawn
names: both curves are of one function | both curves are the same numbers
numerics: the curve drawn is right
"""


def plot_comparison(ax, t, speed, angle, **known):
    x, y, _, _ = simulate(t, speed, angle, **known).T
    ax.plot(x, y, label="numerical")
    ax.plot(x, y, "--", label="closed form")
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
