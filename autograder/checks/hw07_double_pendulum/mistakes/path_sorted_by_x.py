"""The points between the ends of the path are sorted by x.

fails: tip_path_is_drawn
names: in the order of time
"""


def plot_tip_path(ax, t, theta, omega, *, masses, lengths, gravity):
    motion = simulate(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    first, *between, last = (wireframe(state[:2], lengths=lengths)[1, 1] for state in motion)
    ax.plot(*np.array([first, *sorted(between, key=lambda tip: tip[0]), last]).T)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
