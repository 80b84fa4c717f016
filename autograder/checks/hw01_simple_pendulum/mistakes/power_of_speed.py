"""The speed, which has no sign, stands for the velocity.

fails: power_gives_the_acceleration
"""

def power_balance(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), -mass * gravity * length * math.sin(theta) * abs(omega)
