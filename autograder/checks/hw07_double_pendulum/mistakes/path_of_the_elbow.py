"""The plot shows the path of the elbow; it should show the path of the tip.

fails: tip_path_is_drawn
names: it is the elbow's path
"""


def plot_tip_path(ax, t, theta, omega, **known):
    states = simulate(t, theta, omega, **known)
    elbows = np.array([wireframe(state[:2], lengths=known["lengths"])[0, 1] for state in states])
    ax.plot(*elbows.T)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
