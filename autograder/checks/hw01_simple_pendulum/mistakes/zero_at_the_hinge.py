"""A potential energy that is zero at the hinge.

fails: energies_are_right
"""

def energy_balance(theta, omega, *, mass, length, gravity):
    kinetic = mass * length**2 * omega**2 / 2
    return -gravity / length * math.sin(theta), kinetic, -mass * gravity * length * math.cos(theta)
