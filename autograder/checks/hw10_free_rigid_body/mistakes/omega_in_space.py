"""omega is given in space components; it should be in body components.

fails: omega_follows_elliptic_functions
"""

_motion = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _motion(t, R, omega, inertia=inertia)
    return np.einsum("nij,nj->ni", rotations, omegas), rotations
