"""Right functions of hw11 by the student's own moment residual: a spin for which it is zero."""


def rolling_spin(lean, precession, *, mass, radius, inertia, gravity):
    def residual(spin):
        force = contact_force(lean, precession, spin, mass=mass, radius=radius, gravity=gravity)
        return moment_residual(lean, precession, spin, *force, mass=mass, radius=radius, inertia=inertia)

    return residual(0.0) / (residual(0.0) - residual(1.0))


def sliding_spin(lean, precession, *, gravity, **disk):
    def residual(spin):
        return moment_residual(lean, precession, spin, 0.0, disk["mass"] * gravity, **disk)

    return residual(0.0) / (residual(0.0) - residual(1.0))
