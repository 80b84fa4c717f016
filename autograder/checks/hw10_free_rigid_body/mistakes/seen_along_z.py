"""You draw the paths as seen along space z; there a small tilt shows in second order alone.

fails: rim_paths_are_drawn
names: the paths are seen along z
"""


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t, R, omega, inertia=inertia)
    for axis in (0, 1):
        ax.plot(*radius * rotations[:, :2, axis].T)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
