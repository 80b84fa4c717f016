"""Only one of the two paths is drawn.

fails: rim_paths_are_drawn
names: the number of curves on the axes is 1
"""


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t, R, omega, inertia=inertia)
    ax.plot(radius * rotations[:, 0, 0], radius * rotations[:, 1, 0])
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
