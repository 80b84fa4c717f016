"""The slope of the potential energy is a difference quotient to one side.

fails: energy_gives_the_acceleration
numerics: the step of a difference
"""


def energy_balance(theta, omega, *, mass, length, gravity):
    kinetic, potential = mass * (length * omega) ** 2 / 2, mass * gravity * length * (1 - math.cos(theta))
    slope = mass * gravity * length * (math.cos(theta) - math.cos(theta + 1e-4)) / 1e-4
    return -slope / (mass * length**2), kinetic, potential
