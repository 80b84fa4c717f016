"""The sign of the generalized force reversed.

fails: virtual_work_gives_the_acceleration
"""

def virtual_work(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), mass * gravity * length * math.sin(theta)
