"""The given times are scaled in place; work on a copy.

fails: trajectory_is_the_motion
names: trajectory changes the arrays
"""

unharmed = trajectory


def trajectory(t, speed, angle, *, mass, drag, gravity):
    states = unharmed(t, speed, angle, mass=mass, drag=drag, gravity=gravity)
    t *= drag / mass
    return states


def plot_comparison(ax, t, speed, angle, **known):
    x, y, _, _ = unharmed(t - t[0], speed, angle, **known).T
    ax.plot(x, y)
    ax.plot(x, y)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
