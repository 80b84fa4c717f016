"""The third axis of the body is the second times the first.

fails: attitude_follows_the_motion
also: has the opposite sign in component 3
names: the three axes are left-handed
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right_simulate(t, R, omega, inertia=inertia)
    return omegas, rotations * [1.0, 1.0, -1.0]
