"""The centripetal term of the tension with the wrong sign.

fails: newton_gives_the_tension
suspect: a tension with -m l omega^2
"""

def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    tension = mass * gravity * math.cos(theta) - mass * length * omega**2
    return -gravity / length * math.sin(theta), tension
