"""theta stands for sin theta: this is the linearised equation.

fails: simulate_swings
"""

def simulate(t, theta0, omega0, *, length, gravity):
    return small_angle_solution(t - t[0], theta0, omega0, length=length, gravity=gravity)
