"""cos theta stands where sin theta belongs.

fails: newton_gives_the_acceleration
"""

def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    tension = mass * length * omega**2 + mass * gravity * math.cos(theta)
    return -gravity / length * math.cos(theta), tension
