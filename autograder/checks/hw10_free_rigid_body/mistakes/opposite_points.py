"""You draw two opposite points of the rim; they run on one circle, for r(t) of the other is -r(t).

fails: rim_paths_are_drawn
names: it runs on the same circle
"""


def plot_rim_paths(ax, t, R, omega, *, inertia, radius):
    _, rotations = simulate(t, R, omega, inertia=inertia)
    for end in (radius, -radius):
        ax.plot(*end * rotations[:, 1:, 0].T)
    ax.set(xlabel="y (m)", ylabel="z (m)", aspect="equal")
