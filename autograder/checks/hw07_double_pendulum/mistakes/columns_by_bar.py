"""The columns are th1, om1, th2, om2; they should be th1, th2, om1, om2.

fails: simulation_follows_the_equations
"""

by_kind = simulate


def simulate(t, theta, omega, **known):
    return by_kind(t, theta, omega, **known)[:, [0, 2, 1, 3]]


def plot_tip_path(ax, t, theta, omega, **known):
    th1, th2, _, _ = by_kind(t, theta, omega, **known).T
    l1, l2 = known["lengths"]
    ax.plot(l1 * np.sin(th1) + l2 * np.sin(th2), -l1 * np.cos(th1) - l2 * np.cos(th2))
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
