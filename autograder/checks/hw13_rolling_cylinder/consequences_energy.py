"""Right functions of hw13 by the student's own energy, which is constant."""

STEP = 1e-4  # rad


def acceleration(phi, phi_dot, **cylinder):
    def at(angle, rate):
        return energy(angle, rate, **cylinder)

    slope = (at(phi + STEP, phi_dot) - at(phi - STEP, phi_dot)) / (2 * STEP)
    return -slope / (at(phi, 1.0) + at(phi, -1.0) - 2 * at(phi, 0.0))
