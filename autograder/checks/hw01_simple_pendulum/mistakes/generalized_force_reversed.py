"""The generalized force has the wrong sign.

fails: virtual_work_gives_the_acceleration
"""

def virtual_work(theta, omega, *, mass, length, gravity):
    return -gravity / length * math.sin(theta), mass * gravity * length * math.sin(theta)
