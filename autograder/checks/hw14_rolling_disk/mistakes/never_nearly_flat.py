"""The sine of the tilt is kept from being small, to avoid a division by zero.

fails: euler_equations_hold_next_to_flat_and_upright
names: No tilt but 0 and pi is singular
"""


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    x, y, yaw, tilt, roll, yaw_rate, tilt_rate, roll_rate = state
    A, C = inertia
    c, s = math.cos(tilt), max(math.sin(tilt), 0.01)
    m = mass * radius**2
    w2, spin, turn = yaw_rate * s, roll_rate + yaw_rate * c, yaw_rate * c
    first = (w2 * (A * turn - (C + m) * spin) - mass * gravity * radius * c) / (A + m)
    second = tilt_rate * (C * spin - A * turn) / A
    third = m * tilt_rate * w2 / (C + m)
    yaw_second = (second - yaw_rate * tilt_rate * c) / s
    roll_second = third - yaw_second * c + yaw_rate * tilt_rate * s
    return (
        -radius * roll_rate * math.cos(yaw), -radius * roll_rate * math.sin(yaw),
        yaw_rate, tilt_rate, roll_rate, yaw_second, first, roll_second,
    )
