"""The momentum m l omega stands for its moment m l^2 omega about the hinge.

fails: momentum_and_moment_are_about_the_hinge
"""

def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    moment = -mass * gravity * length * math.sin(theta)
    return moment / (mass * length**2), mass * length * omega, moment
