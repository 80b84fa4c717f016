"""The curves end in one long straight line.

fails: both_paths_are_drawn
unnamed: chords between few times are drawn as any other curve is
"""


def plot_comparison(ax, t, speed, angle, **known):
    times = np.append(np.linspace(0.0, 0.01, 20), 1.0) * (t[-1] - t[0])
    for motion in (simulate, trajectory):
        ax.plot(*motion(times, speed, angle, **known)[:, :2].T)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
