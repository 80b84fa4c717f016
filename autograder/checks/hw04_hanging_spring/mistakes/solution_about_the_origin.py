"""The weight is left out: the equilibrium is at the origin.

fails: solution_is_the_motion
"""

def solution(t, position, velocity, *, mass, stiffness, gravity):
    k = np.sqrt(stiffness / mass)
    c, s = np.cos(k * t)[:, None], np.sin(k * t)[:, None]
    return np.hstack([position * c + velocity / k * s, velocity * c - position * k * s])
