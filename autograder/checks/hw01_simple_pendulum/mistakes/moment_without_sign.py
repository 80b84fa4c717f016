"""Gravity's term has the wrong sign.

fails: moments_give_the_acceleration, momentum_and_moment_are_about_the_hinge
"""

def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    inertia, moment = mass * length**2, mass * gravity * length * math.sin(theta)
    return moment / inertia, inertia * omega, moment
