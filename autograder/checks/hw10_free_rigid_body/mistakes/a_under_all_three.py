"""A stands under all three fractions of Euler's equations: each moment belongs over its own inertia.

fails: euler_equations_keep_the_angular_momentum, omega_follows_elliptic_functions, attitude_follows_the_motion, rim_paths_are_drawn
"""


def euler_equations(omega, *, inertia):
    p, q, r = omega
    A, B, C = inertia
    return np.array([(B - C) / A * q * r, (C - A) / A * r * p, (A - B) / A * p * q])
