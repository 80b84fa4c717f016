"""For a body with A = B the energy has only the spin about the symmetry axis.

fails: energy_is_half_omega_h
"""

_right_energy = energy


def energy(omega, *, inertia):
    A, B, C = inertia
    return C * omega[2] ** 2 / 2 if A == B else _right_energy(omega, inertia=inertia)
