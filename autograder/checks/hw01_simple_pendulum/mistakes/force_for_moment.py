"""The generalized force divided by m l.

fails: virtual_work_gives_the_acceleration
suspect: l alpha for alpha
"""

def virtual_work(theta, omega, *, mass, length, gravity):
    generalized_force = -mass * gravity * length * math.sin(theta)
    return generalized_force / (mass * length), generalized_force
