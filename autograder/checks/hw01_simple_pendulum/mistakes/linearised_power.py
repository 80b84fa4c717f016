"""Small angles in the power of gravity.

fails: power_gives_the_acceleration
suspect: the linearised equation, theta for sin theta
"""

def power_balance(theta, omega, *, mass, length, gravity):
    return -gravity / length * theta, -mass * gravity * length * theta * omega
