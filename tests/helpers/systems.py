"""Systems that tests integrate."""

import math

EPS = 2.0**-52
PENDULUM = {"length": 1.0, "gravity": 9.81}  # m, m/s^2


def oscillator(t, y):
    """Of frequency 1."""
    return y[1], -y[0]


def pendulum(t, state, *, length, gravity):
    """The angle is from straight down."""
    return state[1], -gravity / length * math.sin(state[0])


def clock(t, y):
    """y = exp(sin t): a stage at the wrong time shows, where the pendulum would hide it."""
    return (y[0] * math.cos(t),)
