"""The moments H x omega are not divided by A, B, C.

fails: euler_equations_keep_the_angular_momentum, omega_follows_elliptic_functions, attitude_follows_the_motion, rim_paths_are_drawn
"""


def euler_equations(omega, *, inertia):
    p, q, r = omega
    A, B, C = inertia
    return (B - C) * q * r, (C - A) * r * p, (A - B) * p * q
