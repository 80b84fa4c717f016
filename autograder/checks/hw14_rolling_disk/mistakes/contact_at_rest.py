"""You set x' = y' = 0; the disk's point at the contact is at rest, but the contact moves along the ground.

fails: euler_equations_hold, euler_simulation_follows_the_motion
"""


def euler_state_derivative(t, state, *, mass, radius, inertia, gravity):
    x, y, yaw, tilt, roll, yaw_rate, tilt_rate, roll_rate = state
    A, C = inertia
    c, s = math.cos(tilt), math.sin(tilt)
    m = mass * radius**2
    w2, spin, turn = yaw_rate * s, roll_rate + yaw_rate * c, yaw_rate * c
    first = (w2 * (A * turn - (C + m) * spin) - mass * gravity * radius * c) / (A + m)
    second = tilt_rate * (C * spin - A * turn) / A
    third = m * tilt_rate * w2 / (C + m)
    yaw_second = (second - yaw_rate * tilt_rate * c) / s
    roll_second = third - yaw_second * c + yaw_rate * tilt_rate * s
    return (
        0.0 * math.cos(yaw), 0.0 * math.sin(yaw),
        yaw_rate, tilt_rate, roll_rate, yaw_second, first, roll_second,
    )
