"""alpha lacks a length: a moment is m l^2 alpha.

fails: virtual_work_gives_the_acceleration
"""

def virtual_work(theta, omega, *, mass, length, gravity):
    generalized_force = -mass * gravity * length * math.sin(theta)
    return generalized_force / (mass * length), generalized_force
