"""The sine of theta has lost its sign; theta may be on either side.

fails: energy_gives_the_acceleration
"""

def energy_balance(theta, omega, *, mass, length, gravity):
    kinetic = mass * length**2 * omega**2 / 2
    potential = mass * gravity * length * (1 - math.cos(theta))
    return -gravity / length * math.sqrt(1 - math.cos(theta) ** 2), kinetic, potential
