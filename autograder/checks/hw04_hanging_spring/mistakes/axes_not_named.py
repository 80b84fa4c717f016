"""The axes have no names, and the picture is stretched.

fails: the_path_is_drawn
names: not labelled with their unit
"""

def plot_projection(ax, t, position, velocity, azimuth, elevation, **parameters):
    ax.plot(*project(simulate(t, position, velocity, **parameters)[:, :3], azimuth, elevation).T)
