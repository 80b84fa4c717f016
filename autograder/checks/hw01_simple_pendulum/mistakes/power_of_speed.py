"""The speed, which has no sign, for the velocity in the power.

fails: power_gives_the_acceleration
"""

def power_balance(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), -mass * gravity * length * math.sin(theta) * abs(omega)
