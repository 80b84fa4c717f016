"""The picture shows x and y, from whatever direction one looks.

fails: the_path_is_drawn
names: these are x and y
"""

def plot_projection(ax, t, position, velocity, azimuth, elevation, **parameters):
    ax.plot(*simulate(t, position, velocity, **parameters)[:, :2].T)
    ax.set(xlabel="right (m)", ylabel="up (m)", aspect="equal")
