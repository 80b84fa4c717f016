"""The path is drawn for the mass centre of bar 2, not for the tip.

fails: tip_path_is_drawn
names: the path of bar 2's mass centre
"""


def plot_tip_path(ax, t, theta, omega, *, masses, lengths, gravity):
    motion = simulate(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity)
    centres = np.array([wireframe(state[:2], lengths=lengths)[1].mean(axis=0) for state in motion])
    ax.plot(*centres.T)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
