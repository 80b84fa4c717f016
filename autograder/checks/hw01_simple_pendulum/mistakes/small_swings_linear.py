"""Small and slow starts swing by the linear equation.

fails: simulate_needs_no_dense_times
names: no swing is so small
"""

_right_simulate = simulate


def simulate(t, theta0, omega0, **rod):
    if abs(theta0) < 0.1 and abs(omega0) < 0.1:
        return small_angle_solution(t - t[0], theta0, omega0, **rod)
    return _right_simulate(t, theta0, omega0, **rod)
