"""The closed form of hw02 as one writes it, which loses digits where drag is small."""

import math

import numpy as np


def trajectory(t, speed, angle, *, mass, drag, gravity):
    """Positions by integrating the velocities, which fall to the terminal one in the time tau."""
    tau = mass / drag
    vx, vy, decay = speed * math.cos(angle), speed * math.sin(angle), np.exp(-drag * t / mass)
    x, y = tau * vx * (1 - decay), tau * (vy + gravity * tau) * (1 - decay) - gravity * tau * t
    return np.column_stack([x, y, vx * decay, (vy + gravity * tau) * decay - gravity * tau])
