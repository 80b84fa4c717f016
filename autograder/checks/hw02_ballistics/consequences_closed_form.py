"""The closed form of hw02 in its usual form, which loses digits if drag is small."""

import math

import numpy as np


def trajectory(t, speed, angle, *, mass, drag, gravity):
    """Integrate the velocities, which approach the terminal one in the time tau."""
    tau = mass / drag
    vx, vy, decay = speed * math.cos(angle), speed * math.sin(angle), np.exp(-drag * t / mass)
    x, y = tau * vx * (1 - decay), tau * (vy + gravity * tau) * (1 - decay) - gravity * tau * t
    return np.column_stack([x, y, vx * decay, (vy + gravity * tau) * decay - gravity * tau])


def flight_time(speed, angle, *, gravity, **particle):
    """Solve for the return of the closed form to y = 0, after the launch."""
    from scipy.optimize import brentq

    def mean_rise(time):
        return trajectory(np.array([time]), speed, angle, gravity=gravity, **particle)[0, 1] / time

    drag_free = 2 * speed * math.sin(angle) / gravity
    return brentq(mean_rise, 1e-9 * drag_free, 2 * drag_free, rtol=1e-12)
