"""The paths are seen along space x.

fails: rim_paths_are_drawn
names: the paths are seen along x
"""


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t, R, omega, inertia=inertia)
    for end in (radius, -radius):
        ax.plot(end * rotations[:, 1, 0], end * rotations[:, 2, 0])
    ax.set(xlabel="y (m)", ylabel="z (m)", aspect="equal")
