"""Every sign in Euler's equations is reversed.

fails: euler_equations_keep_the_angular_momentum, omega_follows_elliptic_functions, attitude_follows_the_motion, rim_paths_are_drawn
"""


def euler_equations(omega, *, inertia):
    p, q, r = omega
    A, B, C = inertia
    return (C - B) / A * q * r, (A - C) / B * r * p, (B - A) / C * p * q
