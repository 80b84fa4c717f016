"""The potential energy is zero at the hinge; it should be zero at the lowest point.

fails: energies_are_right
"""

def energy_balance(theta, omega, *, mass, length, gravity):
    kinetic = mass * length**2 * omega**2 / 2
    return -gravity / length * math.sin(theta), kinetic, -mass * gravity * length * math.cos(theta)
