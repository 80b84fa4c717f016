"""Systems that tests integrate."""

import math

EPS = 2.0**-52
PENDULUM = {"length": 1.0, "gravity": 9.81}  # m, m/s^2


def oscillator(t, y):
    """Return the rates of a harmonic oscillator of unit frequency."""
    return y[1], -y[0]


def pendulum(t, state, *, length, gravity):
    """Return the rates of a pendulum; its angle is zero straight down."""
    return state[1], -gravity / length * math.sin(state[0])


def clock(t, y):
    """Return the rate of y = exp(sin t), which depends on t: a stage at the wrong time shows in the result."""
    return (y[0] * math.cos(t),)
