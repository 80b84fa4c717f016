"""The amplitude is the position from the origin; it oscillates about the equilibrium.

fails: solution_is_the_motion
"""


def solution(t, position, velocity, *, mass, stiffness, gravity):
    w = np.sqrt(stiffness / mass)
    centre = np.array([0.0, 0.0, -mass * gravity / stiffness])
    c, s = np.cos(w * t)[:, None], np.sin(w * t)[:, None]
    return np.hstack([centre + position * c + velocity / w * s, velocity * c - w * position * s])
