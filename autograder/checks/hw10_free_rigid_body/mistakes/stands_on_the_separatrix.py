"""On the separatrix, where the period is infinite, omega stays as it is.

fails: special_bodies_move_too
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right_simulate(t, R, omega, inertia=inertia)
    A, B, C = inertia
    p, _, r = omega
    if p and A < B < C and math.isclose(A * (B - A) * p * p, C * (C - B) * r * r):
        omegas[:] = omega
    return omegas, rotations
