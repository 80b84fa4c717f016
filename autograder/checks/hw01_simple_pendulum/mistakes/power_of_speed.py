"""The power with the speed, which has no sign, for the velocity.

fails: power_gives_the_acceleration
suspect: the speed, which has no sign
"""

def power_balance(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), -mass * gravity * length * math.sin(theta) * abs(omega)
