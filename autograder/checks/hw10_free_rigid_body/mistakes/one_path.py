"""Only one of the two paths is drawn.

fails: rim_paths_are_drawn
names: the number of curves on the axes is 1
"""


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t, R, omega, inertia=inertia)
    ax.plot(*radius * rotations[:, 1:, 0].T)
    ax.set(xlabel="y (m)", ylabel="z (m)", aspect="equal")
