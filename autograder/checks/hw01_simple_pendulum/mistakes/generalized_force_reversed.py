"""The generalized force, which is minus the slope of the potential energy, without its minus.

fails: virtual_work_gives_the_acceleration
suspect: the sign of the generalized force reversed
"""

def virtual_work(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), mass * gravity * length * math.sin(theta)
