"""The momentum m l omega for its moment: right for a rod of one metre.

fails: momentum_and_moment_are_about_the_hinge
suspect: for its moment about the hinge
"""

def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    moment = -mass * gravity * length * math.sin(theta)
    return moment / (mass * length**2), mass * length * omega, moment
