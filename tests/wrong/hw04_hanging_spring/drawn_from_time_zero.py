"""The picture by the closed form at the times themselves, as if the given state were that at t = 0.

fails: the_path_is_drawn
names: the given state is that at t[0]
"""

def plot_projection(ax, t, position, velocity, azimuth, elevation, **parameters):
    states = solution(t, position, velocity, **parameters)
    ax.plot(*project(states[:, :3], azimuth, elevation).T)
    ax.set(xlabel="right (m)", ylabel="up (m)", aspect="equal")
