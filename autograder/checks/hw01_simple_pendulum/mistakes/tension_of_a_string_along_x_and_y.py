"""The tension is cut off at zero, as in a string; a rod can push.

fails: newton_gives_the_tension
"""


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    tension = mass * (length * omega**2 + gravity * math.cos(theta))
    ax, ay = -tension / mass * math.sin(theta), tension / mass * math.cos(theta) - gravity
    return (ax * math.cos(theta) + ay * math.sin(theta)) / length, max(tension, 0.0)
