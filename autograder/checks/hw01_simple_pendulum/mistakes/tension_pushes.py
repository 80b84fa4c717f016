"""m l omega^2 has the wrong sign in the tension.

fails: newton_gives_the_tension
"""

def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    tension = mass * gravity * math.cos(theta) - mass * length * omega**2
    return -gravity / length * math.sin(theta), tension
