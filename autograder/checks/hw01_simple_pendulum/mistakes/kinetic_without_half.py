"""The kinetic energy lacks its factor 1/2.

fails: energies_are_right, lagrangian_is_kinetic_less_potential, lagrange_gives_the_acceleration, action_is_stationary_on_motions
within: 1e-3
"""

_right_balance, _right_action = energy_balance, action


def energy_balance(theta, omega, **pendulum):
    alpha, kinetic, potential = _right_balance(theta, omega, **pendulum)
    return alpha, 2 * kinetic, potential


def lagrangian():
    import sympy

    theta, omega, m, l, g = sympy.symbols("theta omega m l g")
    return m * l**2 * omega**2 - m * g * l * (1 - sympy.cos(theta))


def action(theta, step, *, mass, length, gravity):
    kinetic = step * np.sum(mass * (length * np.diff(theta) / step) ** 2 / 2)
    return _right_action(theta, step, mass=mass, length=length, gravity=gravity) + kinetic
