"""The closed form has the rate sqrt(m/k); it should be sqrt(k/m).

fails: solution_is_the_motion
"""

def solution(t, position, velocity, *, mass, stiffness, gravity):
    k, centre = np.sqrt(mass / stiffness), np.array([0, 0, -mass * gravity / stiffness])
    c, s, from_centre = np.cos(k * t)[:, None], np.sin(k * t)[:, None], position - centre
    return np.hstack([centre + from_centre * c + velocity / k * s, velocity * c - k * from_centre * s])
