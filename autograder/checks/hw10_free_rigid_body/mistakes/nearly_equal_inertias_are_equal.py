"""Where isclose(A, B) holds, the third component of omega stays as it is.

fails: euler_equations_keep_the_angular_momentum
"""

_right_euler = euler_equations


def euler_equations(omega, *, inertia):
    p, q, r = _right_euler(omega, inertia=inertia)
    return p, q, 0.0 if np.isclose(inertia[0], inertia[1]) else r
