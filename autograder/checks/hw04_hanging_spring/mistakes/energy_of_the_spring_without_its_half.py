"""The energy of the spring lacks its half.

fails: energy_is_that_of_motion_spring_and_weight
"""

_right = energy


def energy(state, *, mass, stiffness, gravity):
    r = np.asarray(state[:3])
    return _right(state, mass=mass, stiffness=stiffness, gravity=gravity) + stiffness * r @ r / 2
