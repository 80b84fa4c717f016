"""A bead at rest is given no acceleration and no energy.

fails: newton_gives_the_acceleration, energy_is_kinetic_and_potential
"""

_newton, _energy = acceleration_newton, energy


def acceleration_newton(x, v, *, curvature, gravity):
    return _newton(x, v, curvature=curvature, gravity=gravity) if v else 0.0


def energy(x, v, *, mass, curvature, gravity):
    return _energy(x, v, mass=mass, curvature=curvature, gravity=gravity) if v else 0.0
