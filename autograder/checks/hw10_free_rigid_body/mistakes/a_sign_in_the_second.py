"""A sign is wrong in the second of Euler's equations.

fails: euler_equations_keep_the_angular_momentum
"""

_right_euler, _right_rates = euler_equations, _rates


def euler_equations(omega, *, inertia):
    p, q, r = _right_euler(omega, inertia=inertia)
    return np.array([p, -q, r])


def _rates(t, state, *, inertia):
    p, q, r = state[:3]
    A, B, C = inertia
    rest = _right_rates(t, state, inertia=inertia)[3:]
    return ((B - C) / A * q * r, (C - A) / B * r * p, (A - B) / C * p * q, *rest)
