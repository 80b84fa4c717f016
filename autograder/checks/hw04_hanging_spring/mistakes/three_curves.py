"""The picture has x, y and z over time; it should have the path in space.

fails: the_path_is_drawn
names: the number of curves on the axes is 3
"""

def plot_projection(ax, t, position, velocity, azimuth, elevation, **parameters):
    ax.plot(t, simulate(t, position, velocity, **parameters)[:, :3])
    ax.set(xlabel="t (s)", ylabel="r (m)")
