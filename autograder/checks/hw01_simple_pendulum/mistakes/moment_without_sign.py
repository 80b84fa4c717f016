"""The moment of the weight turns the pendulum away from the bottom.

fails: moments_give_the_acceleration, momentum_and_moment_are_about_the_hinge
suspect: the sign of gravity's term missing
"""

def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    inertia, moment = mass * length**2, mass * gravity * length * math.sin(theta)
    return moment / inertia, inertia * omega, moment
