"""In the closed form's velocity the term of the position has the wrong sign: the rate of cos is -sin.

fails: solution_is_the_motion
"""

def solution(t, position, velocity, *, mass, stiffness, gravity):
    k, centre = np.sqrt(stiffness / mass), np.array([0, 0, -mass * gravity / stiffness])
    c, s, from_centre = np.cos(k * t)[:, None], np.sin(k * t)[:, None], position - centre
    return np.hstack([centre + from_centre * c + velocity / k * s, velocity * c + k * from_centre * s])
