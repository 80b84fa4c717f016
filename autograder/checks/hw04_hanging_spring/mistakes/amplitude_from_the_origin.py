"""The closed form takes the position from the origin as amplitude; it should be taken from the equilibrium.

fails: solution_is_the_motion
"""


def solution(t, position, velocity, *, mass, stiffness, gravity):
    w = np.sqrt(stiffness / mass)
    centre = np.array([0.0, 0.0, -mass * gravity / stiffness])
    c, s = np.cos(w * t)[:, None], np.sin(w * t)[:, None]
    return np.hstack([centre + position * c + velocity / w * s, velocity * c - w * position * s])
