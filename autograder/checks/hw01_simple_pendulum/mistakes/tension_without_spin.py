"""The tension only carries the weight.

fails: newton_gives_the_tension
suspect: a tension without m l omega^2
"""

def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), mass * gravity * math.cos(theta)
