"""Where the slope is below a thousandth, the wire counts as level: no height, and a force straight up.

fails: force_and_weight_make_the_acceleration, energy_is_kinetic_and_potential
"""

_force, _energy = constraint_force, energy


def constraint_force(x, v, *, curvature, **bead):
    return _force(x if abs(2 * curvature * x) >= 1e-3 else 0.0, v, curvature=curvature, **bead)


def energy(x, v, *, curvature, **bead):
    return _energy(x if abs(2 * curvature * x) >= 1e-3 else 0.0, v, curvature=curvature, **bead)
