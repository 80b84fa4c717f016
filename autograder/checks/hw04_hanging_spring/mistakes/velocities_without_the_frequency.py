"""The velocities lack a factor, the frequency.

fails: solution_is_the_motion
"""

def solution(t, position, velocity, *, mass, stiffness, gravity):
    w = np.sqrt(stiffness / mass)
    centre = np.array([0, 0, -mass * gravity / stiffness])
    A, B, t = position - centre, velocity / w, np.asarray(t)[:, None]
    c, s = np.cos(w * t), np.sin(w * t)
    return np.hstack([centre + A * c + B * s, B * c - A * s])
