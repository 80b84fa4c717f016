"""Spin near the middle axis is held constant unless that is axis 1; it should not be.

fails: omega_follows_elliptic_functions
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right_simulate(t, R, omega, inertia=inertia)
    middle = np.argsort(inertia)[1]
    if middle != 1 and 0.9 * math.hypot(*omega) < abs(omega[middle]) < math.hypot(*omega):
        omegas[:] = omega
    return omegas, rotations
