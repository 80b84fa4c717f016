"""The component of the weight along the circle with the cosine.

fails: newton_gives_the_acceleration
suspect: cos theta where sin theta belongs
"""

def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    tension = mass * length * omega**2 + mass * gravity * math.cos(theta)
    return -gravity / length * math.cos(theta), tension
