"""The angle is treated as degrees; it is in radians.

fails: newton_gives_the_acceleration, newton_gives_the_tension
"""

def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    theta = math.radians(theta)
    return -gravity / length * math.sin(theta), mass * length * omega**2 + mass * gravity * math.cos(theta)
