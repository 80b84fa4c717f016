"""You drew m a as a force; no other body exerts it.

fails: forces_on_the_mass
names: You drew m a as a force
"""

_right = free_body_diagram


def free_body_diagram(theta, omega, *, mass, length, gravity):
    alpha = linear_momentum_balance(theta, omega, mass=mass, length=length, gravity=gravity)[0]
    r, across = length * np.array([np.sin(theta), -np.cos(theta)]), length * np.array([np.cos(theta), np.sin(theta)])
    return [*_right(theta, omega, mass=mass, length=length, gravity=gravity), (r, alpha * across - omega**2 * r)]
