"""The momentum m l omega for its moment about the hinge, which is right for a length of 1 m.

fails: momentum_and_moment_are_about_the_hinge
also: the weight's part across the rod for its moment about the hinge, which is right for a length of 1 m
"""

def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    moment = -mass * gravity * length * math.sin(theta)
    return moment / (mass * length**2), mass * length * omega, moment
