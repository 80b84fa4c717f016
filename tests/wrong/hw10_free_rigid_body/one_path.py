"""One of the two paths is drawn.

fails: rim_paths_are_drawn
"""


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t, R, omega, inertia=inertia)
    ax.plot(radius * rotations[:, 0, 0], radius * rotations[:, 1, 0])
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
