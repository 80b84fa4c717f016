"""Two inertias that isclose takes for equal leave the third component of omega as it is.

fails: euler_equations_keep_the_angular_momentum
names: for two inertias that are equal to five digits
"""

_right_euler = euler_equations


def euler_equations(omega, *, inertia):
    rates = np.array(_right_euler(omega, inertia=inertia))
    for axis in range(3):
        if np.isclose(inertia[axis - 2], inertia[axis - 1]):
            rates[axis] = 0.0
    return rates
