"""theta stands for sin theta: this is the linearised equation.

fails: power_gives_the_acceleration
"""

def power_balance(theta, omega, *, mass, length, gravity):
    return -gravity / length * theta, -mass * gravity * length * theta * omega
