"""The tension of a string, from the force along x and y: at the top alpha is what rounding leaves of it.

fails: newton_gives_the_tension
suspect: the tension of a string
"""


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    tension = mass * (length * omega**2 + gravity * math.cos(theta))
    ax, ay = -tension / mass * math.sin(theta), tension / mass * math.cos(theta) - gravity
    return (ax * math.cos(theta) + ay * math.sin(theta)) / length, max(tension, 0.0)
