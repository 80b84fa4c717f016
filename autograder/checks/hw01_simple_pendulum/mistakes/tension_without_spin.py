"""The tension lacks m l omega^2.

fails: newton_gives_the_tension
"""

def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), mass * gravity * math.cos(theta)
