"""The potential energy is zero at the lowest position; it should be zero with both bars level with the ceiling.

fails: energy_is_kinetic_and_potential
"""

zero_at_the_ceiling = energy


def energy(theta, omega, *, masses, lengths, gravity):
    lowest = masses[0] * lengths[0] / 2 + masses[1] * (lengths[0] + lengths[1] / 2)
    known = {"masses": masses, "lengths": lengths, "gravity": gravity}
    return zero_at_the_ceiling(theta, omega, **known) + gravity * lowest
