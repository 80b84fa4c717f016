"""The energy is half of H . H; it should be half of omega . H, with A, B, C and not their squares.

fails: energy_is_half_omega_h
"""


def energy(omega, *, inertia):
    return 0.5 * sum((moment * w) ** 2 for moment, w in zip(inertia, omega))
