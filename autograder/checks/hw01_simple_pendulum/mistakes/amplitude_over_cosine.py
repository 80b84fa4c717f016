"""The amplitude is theta0 over the cosine of the phase, which is lost for a pendulum that starts at the bottom.

fails: small_angle_solution_is_harmonic
"""

_right_solution = small_angle_solution


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    if gravity == 0:
        return _right_solution(t, theta0, omega0, length=length, gravity=gravity)
    k = math.sqrt(gravity / length)
    phase = math.atan2(-omega0 / k, theta0)
    amplitude = theta0 / math.cos(phase)
    return np.column_stack([amplitude * np.cos(k * t + phase), -k * amplitude * np.sin(k * t + phase)])
