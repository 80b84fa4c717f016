"""You keep omega constant near the middle axis unless that is axis 1; such a spin is unstable about any axis.

fails: omega_follows_elliptic_functions
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right_simulate(t, R, omega, inertia=inertia)
    middle = np.argsort(inertia)[1]
    if middle != 1 and 0.9 * math.hypot(*omega) < abs(omega[middle]) < math.hypot(*omega):
        omegas[:] = omega
    return omegas, rotations
