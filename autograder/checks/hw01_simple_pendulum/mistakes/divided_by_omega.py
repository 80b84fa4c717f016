"""The acceleration is power over omega, which is 0/0 at rest.

fails: power_gives_the_acceleration_at_rest
names: power_balance raised ZeroDivisionError
"""

def power_balance(theta, omega, *, mass, length, gravity):
    power = -mass * gravity * length * math.sin(theta) * omega
    return power / (mass * length**2 * omega), power
