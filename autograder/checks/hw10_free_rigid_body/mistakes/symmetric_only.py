"""A = B is put into the third of Euler's equations: omega_3 stays.

fails: euler_equations_keep_the_angular_momentum, omega_follows_elliptic_functions, attitude_follows_the_motion, rim_paths_are_drawn
"""


def euler_equations(omega, *, inertia):
    p, q, r = omega
    A, B, C = inertia
    return (B - C) / A * q * r, (C - A) / B * r * p, 0.0 * p
